#include <pcl/acquisition/digiclops_grabber.h>
#include <pcl/acquisition/pattern_sequence_grabber.h>
#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/acquisition/trinocular_file_grabber.h>
#include <pcl/core/trajectory_error.h>
#include <pcl/egomotion/correspondence_estimation_log_polar.h>
#include <pcl/egomotion/correspondence_rejector_worst_out.h>
#include <pcl/egomotion/gradient_maximum_keypoint.h>
#include <pcl/mapping/map_entropy_types.h>
#include <pcl/pipeline/compact_mapping.h>
#include <pcl/pipeline/session_source.h>
#include <pcl/stereo/active_stereo_grabber.h>
#include <pcl/stereo/rig_calibrator_types.h>
#include <pcl/stereo/trinocular_rectification.h>
#include <pcl/video/camera_grabber.h>

#include <gtest/gtest.h>

#include <cxxabi.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <regex>
#include <set>
#include <sstream>
#include <tuple>
#include <typeinfo>
#include <utility>

namespace pcl::acmap::test {

/** Initializes any member of an aggregate. */
struct Anything {
  template <typename Member>
  operator Member() const;
};

namespace {

namespace fs = std::filesystem;

/** Settings that keys of stages have: all fields but the threads. */
using Settings = std::tuple<EgomotionSettings,
                            KeypointSettings,
                            LogPolarSettings,
                            OdometryNoise,
                            PatchShifts,
                            RectificationSettings,
                            WorstOutSettings>;

/** All other structs that name their fields: reports, and what they are made of. */
using Structs = std::tuple<AbsoluteTrajectoryError,
                           ActiveStereoGrabberReport,
                           AdjustmentRound,
                           BoardImage,
                           BoxFittingReport,
                           CameraGrabberReport,
                           CameraPathReport,
                           CameraState,
                           ChannelOrderCheck,
                           CloudAssessmentReport,
                           CloudAssessmentReport::Colors,
                           CloudAssessmentReport::Noise,
                           CloudAssessmentReport::Unit,
                           CompactMappingReport,
                           ConsolidationReport,
                           ContradictedWindow,
                           CylinderClusteringReport,
                           DeWallReport,
                           DepthPlaneReport,
                           DepthRefinementReport,
                           DigiclopsGrabberReport,
                           DisparityBackProjectionReport,
                           DisparityFusionReport,
                           EgomotionEstimate,
                           EgomotionReport,
                           EntropyRectificationReport,
                           FreeMotion,
                           GradientMaximumReport,
                           MapEntropyReport,
                           MapEvidence,
                           MapLevellingReport,
                           MapQualityReport,
                           MapVerdictReport,
                           MeasuredOdometry,
                           MeasuredOdometry::Component,
                           MergingReport,
                           NextPosition,
                           NextPositionsReport,
                           NoiseScale,
                           NoiseScale::InverseDepth,
                           NoiseScale::InverseDepth::AtDepth,
                           NoiseScale::Range,
                           OdometryPair,
                           PatternSequenceGrabberReport,
                           PlanarAction,
                           PlanarPose,
                           PlaneAdjustmentReport,
                           PlaneClusteringReport,
                           PlaneMappingReport,
                           PoseConventionReport,
                           PoseUncertainty,
                           QualityFigure,
                           RandomLinePatternReport,
                           RayContradictions,
                           RecessFittingReport,
                           RectificationStep,
                           RelativePoseError,
                           RevisitReport,
                           RigCalibratorReport,
                           SensorEvidence,
                           SequenceAlignmentReport,
                           SequenceConsolidationReport,
                           SessionReport,
                           TexturingReport,
                           TrinocularFileReport,
                           TrinocularMatchingReport,
                           TrinocularRectificationReport,
                           TrinocularShot,
                           UpEvidence,
                           VisualOdometryResult,
                           VotingReport,
                           registration::LogPolarReport,
                           registration::WorstOutReport>;

template <typename Struct, typename Members, typename = void>
constexpr bool can_have = false;

template <typename Struct, std::size_t... member>
constexpr bool can_have<Struct,
                        std::index_sequence<member...>,
                        std::void_t<decltype(Struct{((void)member, Anything())...})>> =
    true;

/** Number of members of an aggregate, and of its base. */
template <typename Struct, std::size_t most = 32>
constexpr std::size_t
countMembers()
{
  static_assert(std::is_aggregate_v<Struct>);
  if constexpr (can_have<Struct, std::make_index_sequence<most>>)
    return most;
  else
    return countMembers<Struct, most - 1>();
}

template <typename Struct>
std::string
nameOfType()
{
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(typeid(Struct).name(), nullptr, nullptr, &status),
      &std::free);
  return std::string(name.get()).substr(std::string("pcl::").size());
}

/** A field as the page has it. */
std::string
described(const Field& field)
{
  return std::string(" `") + field.name + "`" +
         (*field.unit ? std::string(" (") + field.unit + ")" : "");
}

template <typename All, typename Function, std::size_t... i>
void
forEachOf(const Function& function, std::index_sequence<i...>)
{
  (function(std::tuple_element_t<i, All>()), ...);
}

template <typename All = Structs, typename Function>
void
forEachStruct(const Function& function)
{
  forEachOf<All>(function, std::make_index_sequence<std::tuple_size_v<All>>());
}

template <typename Struct, typename = void>
constexpr std::size_t number_of_threads = 0;

template <typename Struct>
constexpr std::size_t
    number_of_threads<Struct, std::void_t<decltype(std::declval<Struct>().threads)>> =
        1;

std::string
contentOfFile(const fs::path& path)
{
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/** The names in all public headers that a pattern captures. */
std::set<std::string>
namesInHeaders(const std::string& pattern)
{
  const std::regex regex(pattern);
  std::set<std::string> names;
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(ACMAP_SOURCE_DIR) / "modules")) {
    if (entry.path().extension() != ".h" ||
        entry.path().string().find("/include/") == std::string::npos)
      continue;
    const std::string text = contentOfFile(entry.path());
    for (std::sregex_iterator found(text.begin(), text.end(), regex), end; found != end;
         ++found)
      names.insert((*found)[1]);
  }
  return names;
}

TEST(ReportFields, EachMemberIsNamedOnce)
{
  const auto check = [](const auto& fields) {
    using Struct = std::decay_t<decltype(fields)>;
    const std::size_t base = std::is_base_of_v<Report, Struct> ? 1 : 0;
    std::set<std::string> names;
    std::size_t visited = 0;
    visitFields(fields, [&](const Field& field, const auto&) {
      names.insert(field.name);
      ++visited;
    });
    EXPECT_EQ(visited, countMembers<Struct>() - base - number_of_threads<Struct>)
        << nameOfType<Struct>();
    EXPECT_EQ(names.size(), visited) << nameOfType<Struct>();
  };
  forEachStruct(check);
  forEachStruct<Settings>(check);
}

/** A new report cannot be forgotten here. */
TEST(ReportFields, AllReportsAreChecked)
{
  std::set<std::string> checked;
  const auto add = [&](const auto& fields) {
    const std::string name = nameOfType<std::decay_t<decltype(fields)>>();
    const std::size_t colon = name.rfind("::");
    const bool is_inner = std::isupper(static_cast<unsigned char>(name.front()));
    checked.insert(colon == std::string::npos || is_inner ? name
                                                          : name.substr(colon + 2));
  };
  forEachStruct(add);
  forEachStruct<Settings>(add);
  std::set<std::string> named = namesInHeaders("visitFields\\(const ([A-Za-z:]+)&");
  EXPECT_EQ(named, checked);
  for (const std::string& report : namesInHeaders("struct ([A-Za-z]+) : Report "))
    EXPECT_EQ(checked.count(report), 1U) << report << " does not name its fields";
}

/** The page has all fields. If ACMAP_REFRESH_FINGERPRINTS is set, writes them. */
TEST(ReportFields, ThePageHasThem)
{
  const fs::path path = fs::path(ACMAP_SOURCE_DIR) / "doc" / "report_fields.md";
  const std::string head = "| struct | fields |\n|---|---|\n";
  const std::string page = contentOfFile(path);
  const std::size_t begin = page.find(head);
  ASSERT_NE(begin, std::string::npos);
  std::string table = head;
  forEachStruct([&](const auto& fields) {
    table += "| `" + nameOfType<std::decay_t<decltype(fields)>>() + "` |";
    visitFields(fields,
                [&](const Field& field, const auto&) { table += described(field); });
    table += " |\n";
  });
  if (std::getenv("ACMAP_REFRESH_FINGERPRINTS"))
    std::ofstream(path) << page.substr(0, begin) << table;
  EXPECT_EQ(contentOfFile(path).substr(begin), table);
}

} // namespace
} // namespace pcl::acmap::test
