#include "bench.h"
#include "bench_data.h"
#include "chain_runs.h"
#include "run_tool.h"
#include "temporary_folder.h"

#include <pcl/core/trajectory_error.h>
#include <pcl/pipeline/compact_mapping.h>
#include <pcl/pipeline/map_comparison.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/texture/compact_map_folder.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>

namespace pcl::acmap::bench {
namespace {

/** \param[in] variable of the environment */
std::size_t
numberOf(const char* variable, std::size_t usual)
{
  const char* const told = std::getenv(variable);
  return told ? std::strtoul(told, nullptr, 10) : usual;
}

/** The first ones of each input are mapped. */
const std::size_t max_observations = numberOf("ACMAP_OBSERVATIONS", 6);

/** Maximum where raw points are meshed: above it every second, fourth ... is taken. */
const std::size_t max_raw_points = numberOf("ACMAP_RAW_POINTS", 60000);

/** \brief The paper's way, ours, or ours with one departure from the paper taken
 * back. */
struct PaperWay {
  const char* name;
  const char* stereo; ///< option of pcl_active_stereo
  bool meshes_raw;    ///< raw points are meshed
  std::function<void(CompactMapping& mapping)> change;
};

/** \brief Result of a way for one input. */
struct PaperWayRun {
  std::string failure; ///< empty if there is a map
  CompactMap map;
  Trajectory odometry; ///< before the rectification
  std::size_t every = 1;
  double compactness = 0; ///< 16 bytes per point divided by the size of map.glb
  double seconds = 0;     ///< wall time, without stereo
};

constexpr const char *spacetime = "--method=spacetime",
                     *median_of_shots = "--method=median", *unlit = "--unlit";

void
setEgomotion(CompactMapping& mapping)
{
  VisualOdometry odometry;
  VisualOdometry::Egomotion egomotion;
  egomotion.setPaperMode(true);
  odometry.setEgomotion(egomotion);
  mapping.setVisualOdometry(odometry);
}

/** Ours with another step from points to planes. */
PaperWay
ourPlanes(const char* name,
          const std::function<void(PlaneMapping& planes)>& change,
          bool meshes_raw = false)
{
  return {name, spacetime, meshes_raw, [change](CompactMapping& mapping) {
            PlaneMapping planes = mapping.getPlaneMapping();
            change(planes);
            mapping.setPlaneMapping(planes);
          }};
}

double
compactnessOf(CompactMap map, std::size_t points)
{
  const test::TemporaryFolder folder;
  saveCompactMap(folder.path(""), map);
  constexpr double bytes_of_point = 16;
  return bytes_of_point * static_cast<double>(points) /
         static_cast<double>(std::filesystem::file_size(folder.path("map.glb")));
}

const std::vector<PaperWay>&
paperWays()
{
  constexpr auto nothing = [](CompactMapping&) {};
  constexpr auto setPaper = [](CompactMapping& mapping) {
    mapping.setMode(MappingMode::Paper);
    setEgomotion(mapping); // planar, whatever the motion is
  };
  static const std::vector<PaperWay> ways = {
      {"the paper's way", median_of_shots, true, setPaper},
      {"the paper's way, unlit", unlit, true, setPaper},
      {"ours", spacetime, false, nothing},
      {"ours, median of the disparities", median_of_shots, false, nothing},
      {"ours, paper's egomotion", spacetime, false, setEgomotion},
      {"ours, paper's rectification",
       spacetime,
       false,
       [](CompactMapping& mapping) {
         CompactMapping::Rectification rectification = mapping.getRectification();
         rectification.setMode(RectificationMode::Paper);
         mapping.setRectification(rectification);
       }},
      ourPlanes(
          "ours, no consolidation",
          [](PlaneMapping& planes) {
            planes.setConsolidationPolicy(ConsolidationPolicy::Never);
          },
          true),
      ourPlanes("ours, strict mesh",
                [](PlaneMapping& planes) {
                  const auto dewall =
                      std::make_shared<DeWallTriangulation<PlaneMapping::Vertex>>();
                  dewall->setAcceptanceRule(DeWallRule::Strict);
                  planes.setMeshConstruction(dewall);
                }),
      ourPlanes("ours, paper's votes",
                [](PlaneMapping& planes) {
                  PlaneMapping::Voting voting;
                  voting.setPaperMode(true);
                  planes.setVoting(voting);
                }),
      ourPlanes("ours, literal hypotheses",
                [](PlaneMapping& planes) {
                  PlaneMapping::Clustering clustering;
                  clustering.setNoiseDriven(false);
                  planes.setClustering(clustering);
                }),
      {"ours, colours of points",
       spacetime,
       false,
       [](CompactMapping& mapping) {
         CompactMapping::Texturing texturing;
         texturing.setPaperMode(true);
         mapping.setTexturing(texturing);
       }},
      {"ours, unlit", unlit, false, nothing}};
  return ways;
}

/** \param[in] is_rigid the motion model, where the way is not the paper's */
PaperWayRun
runPaperWay(const PaperWay& way, const ObservationSequence& observations, bool is_rigid)
{
  CompactMapping mapping;
  if (is_rigid) {
    VisualOdometry odometry;
    VisualOdometry::Egomotion egomotion;
    egomotion.setMotionModel(MotionModel::Rigid);
    odometry.setEgomotion(egomotion);
    mapping.setVisualOdometry(odometry);
  }
  way.change(mapping);
  if (way.meshes_raw) {
    ObservationMerging merging = mapping.getMerging();
    merging.setMaximumPoints(max_raw_points);
    mapping.setMerging(merging);
  }
  mapping.setInputSequence(observations, false);
  PaperWayRun run;
  try {
    run.seconds = measureCost([&] { mapping.compute(run.map); }).wall;
    const CompactMappingReport& report = mapping.getReport();
    run.odometry = mapping.getOdometryTrajectory();
    run.every = report.merging.every;
    if (run.map.planes.empty())
      run.failure = "no plane";
    else
      run.compactness =
          compactnessOf(run.map, report.merging.points * report.merging.every);
  }
  catch (const PCLException&) {
    run.failure = "no map: no observation could be joined to another one";
  }
  return run;
}

/** Figures of a map that are not those of its run. */
struct PaperWayScores {
  std::string found;        ///< such as "5 of 7"
  std::size_t spurious = 0; ///< planes of the map that are none of the truth
  double angle = 0;         ///< degrees, mean
  double offset = 0;        ///< metres, mean
  double ate = 0;           ///< metres, aligned
  double cover = 0;         ///< of the truth, square metres
};

void
printWayHead()
{
  printHead("way | planes found | spurious | angle, degrees | offset, mm | ATE, cm | "
            "cover, m² | seconds | compactness | each n-th point");
}

void
printRow(const PaperWay& way,
         const PaperWayRun& run,
         double stereo_seconds,
         const PaperWayScores& scores)
{
  Row row;
  row << way.name;
  if (!run.failure.empty()) {
    row << run.failure;
    for (int column = 0; column < 5; ++column)
      row << "";
    row << figure(stereo_seconds + run.seconds, 1) << ""
        << "";
    return;
  }
  row << scores.found << scores.spurious << figure(scores.angle, 3)
      << figure(milli * scores.offset, 1) << figure(centi * scores.ate, 1)
      << figure(scores.cover, 1) << figure(stereo_seconds + run.seconds, 1)
      << std::to_string(std::lround(run.compactness)) + " : 1" << run.every;
}

/** Posed observations of a map: the stamps of estimated poses are their numbers. */
std::vector<std::size_t>
placesOf(const CompactMap& map)
{
  std::vector<std::size_t> places;
  for (const double stamp : map.trajectory.stamps)
    places.push_back(static_cast<std::size_t>(std::lround(stamp)));
  return places;
}

PaperWayScores
scoresOf(const PaperWayRun& run, const SessionTruth& truth)
{
  const Trajectory& after = run.map.trajectory;
  const MappedTrajectory way = {placesOf(run.map),
                                run.odometry.poses.size() == after.poses.size()
                                    ? run.odometry.poses
                                    : after.poses,
                                after.poses};
  const MapDeviation main = compareWithTruth(run.map, way, truth).aligned;
  PaperWayScores scores;
  scores.found =
      std::to_string(main.found) + " of " + std::to_string(main.planes.size());
  scores.angle = main.mean_angle;
  scores.offset = main.mean_offset;
  scores.ate = main.ate_after;
  for (const PlaneDeviation& plane : main.planes)
    scores.cover += plane.cover;
  // a plane is spurious if, alone in a map, it finds none of all true planes
  SessionTruth all = truth;
  for (TruePlane& plane : all.planes)
    plane.points = 1;
  for (const PlanePatch& plane : run.map.planes) {
    CompactMap alone;
    alone.planes = {plane};
    scores.spurious += compareWithTruth(alone, way, all).aligned.found == 0 ? 1 : 0;
  }
  return scores;
}

void
printScene(const std::string& scene)
{
  const test::TemporaryFolder folder;
  const std::string session = folder.path("session");
  test::runTool(ACMAP_SIMULATED_RIG,
                {"-o",
                 session,
                 "--scene",
                 scene,
                 "--observations",
                 std::to_string(max_observations)})
      .succeeded();
  const SessionTruth truth = loadSessionTruth(session);
  std::map<std::string, double> stereo_seconds; // by option
  printWayHead();
  for (const PaperWay& way : paperWays()) {
    const std::string observations = folder.path(way.stereo);
    if (stereo_seconds.count(way.stereo) == 0) {
      stereo_seconds[way.stereo] =
          measureCost([&] {
            test::runTool(ACMAP_ACTIVE_STEREO,
                          {session, "-o", observations, way.stereo})
                .succeeded();
          }).wall;
    }
    const PaperWayRun run =
        runPaperWay(way, ObservationSequence(observationPaths(observations)), false);
    printRow(way,
             run,
             stereo_seconds[way.stereo],
             run.failure.empty() ? scoresOf(run, truth) : PaperWayScores());
  }
}

/** Compares with the map of the given poses, which is made our way. */
PaperWayScores
scoresOf(const PaperWayRun& run,
         const CompactMap& reference,
         const std::vector<Eigen::Isometry3d>& given)
{
  std::vector<ChainView> views;
  std::vector<Eigen::Isometry3d> true_poses;
  const std::vector<std::size_t> places = placesOf(run.map);
  for (std::size_t i = 0; i < places.size(); ++i) {
    true_poses.push_back(given[places[i]]);
    views.push_back({{Eigen::Vector3d::Zero(),
                      Eigen::Vector3d::UnitX(),
                      Eigen::Vector3d::UnitY(),
                      Eigen::Vector3d::UnitZ()},
                     true_poses.back(),
                     run.map.trajectory.poses[i]});
  }
  const Eigen::Isometry3d T_given_found = comparePoints(views).T_given_found;
  const PlaneAgreement planes =
      comparePlanes(reference.planes, run.map.planes, T_given_found);
  double area = 0;
  for (const PlanePatch& plane : reference.planes)
    area += plane.area;
  PaperWayScores scores;
  scores.found =
      std::to_string(planes.planes) + " of " + std::to_string(reference.planes.size());
  scores.spurious =
      run.map.planes.size() -
      comparePlanes(run.map.planes, reference.planes, T_given_found.inverse()).planes;
  scores.angle = planes.angle;
  scores.offset = planes.offset;
  scores.ate = absoluteTrajectoryError(run.map.trajectory.poses, true_poses).aligned;
  scores.cover = planes.area * area;
  return scores;
}

const Section survey_section("corridor_survey", [] { printScene("corridor_survey"); });

const Section office_section("office", [] { printScene("office"); });

const Section kitchen_section("kitchen", [] {
  const auto recording = pathOfKitchen();
  if (!recording)
    return;
  const test::TemporaryFolder folder;
  const std::string posed = folder.path("posed");
  test::runTool(ACMAP_RGBD_IMPORT, {*recording, "-o", posed}).succeeded();
  std::vector<std::string> files = observationPaths(posed);
  files.resize(std::min(files.size(), max_observations));
  std::vector<Eigen::Isometry3d> given =
      loadTrajectory(posed + "/trajectory.txt").poses;
  given.resize(files.size());
  CompactMapping mapping;
  mapping.setRectify(false);
  mapping.setInputSequence(ObservationSequence(files), true);
  CompactMap reference;
  mapping.compute(reference);
  printWayHead();
  for (const PaperWay& way : paperWays()) {
    if (way.stereo == unlit || (way.stereo != spacetime && !way.meshes_raw))
      continue; // the depth is not that of our stereo
    const PaperWayRun run = runPaperWay(way, ObservationSequence(files), true);
    printRow(way,
             run,
             0,
             run.failure.empty() ? scoresOf(run, reference, given) : PaperWayScores());
  }
});

} // namespace
} // namespace pcl::acmap::bench
