#include "figures.h"

#include "exit_code.h"
#include "figure_plan.h"
#include "pictures/drawing.h"
#include "tool.h"

#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/acquisition/trinocular_file_grabber.h>
#include <pcl/conversions.h>
#include <pcl/core/file_format.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/output_file.h>
#include <pcl/core/output_folder.h>
#include <pcl/core/planar_pose.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/process_memory.h>
#include <pcl/core/trajectory_error.h>
#include <pcl/filters/voxel_consolidation.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/plan_picture.h>
#include <pcl/pipeline/session_source.h>
#include <pcl/point_types.h>
#include <pcl/surface/dewall_triangulation.h>
#include <pcl/texture/compact_map_folder.h>
#include <pcl/visualization/display_connection.h>
#include <pcl/visualization/layered_scene.h>
#include <pcl/visualization/map_snapshot.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>

namespace pcl::acmap {

namespace {

using Poses = std::vector<Eigen::Isometry3d>;

/** Data of a simulated session and its building. */
struct FilmedSession {
  std::string folder;
  std::string scene;
  std::size_t observations = 0;
  std::size_t patterns = 0; ///< per observation
  std::size_t lines = 0;    ///< of a pattern
  Trajectory trajectory;    ///< the true one

  /** Walls and all other upright rectangles from above, in the frame of the true
   * trajectory: the two ends (y is 0). */
  std::vector<std::array<Eigen::Vector3d, 2>> uprights;
};

/** Data of a map of the session. */
struct MappedSession {
  std::string folder;
  PCLPointCloud2 points; ///< map.pcd: x y z rgb view, map frame
  /** Before and after rectification, T_map_camera, the same observations. */
  Trajectory before, after;
  std::vector<std::string> observations; ///< paths of their clouds
  CompactMap map;
};

constexpr double farthest = 1e6; // metres
constexpr std::size_t maximum = 1000000;

Eigen::Vector3d
cornerOf(const YamlNode& node)
{
  Eigen::Vector3d corner;
  const auto& values = node.list(3, 3);
  for (std::size_t i = 0; i < values.size(); ++i)
    corner[static_cast<Eigen::Index>(i)] = values[i].number(-farthest, farthest);
  return corner;
}

/** The ends of an upright rectangle: its two corners that are farthest from each other
 * seen from above. */
std::array<Eigen::Vector3d, 2>
endsOf(const YamlNode& rectangle)
{
  std::vector<Eigen::Vector3d> corners;
  for (const YamlNode& corner : rectangle.list(4, 4)) {
    corners.push_back(cornerOf(corner));
    corners.back().y() = 0;
  }
  std::array<Eigen::Vector3d, 2> ends = {corners[0], corners[0]};
  for (const Eigen::Vector3d& a : corners)
    for (const Eigen::Vector3d& b : corners)
      if ((a - b).norm() > (ends[1] - ends[0]).norm())
        ends = {a, b};
  return ends;
}

void
requireThere(const std::string& path, const std::string& advice)
{
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    throw InputFileException(path + ": is not there; " + advice);
}

/** Compares positions, in metres: the map of another session differs by more than any
 * drift. */
void
requireSameWay(const MappedSession& map, const FilmedSession& session)
{
  const std::string what = map.folder + ": is not a map of " + session.folder + ": ";
  if (map.after.poses.size() != session.trajectory.poses.size())
    throw InputFileException(what + "it has " + std::to_string(map.after.poses.size()) +
                             " poses, the session " +
                             std::to_string(session.trajectory.poses.size()));
  constexpr double minimum = 0.5, share = 0.1;
  double way = 0;
  const auto& truth = session.trajectory.poses;
  for (std::size_t i = 1; i < truth.size(); ++i)
    way += (truth[i].translation() - truth[i - 1].translation()).norm();
  const double error = absoluteTrajectoryError(map.after.poses, truth).unaligned;
  if (!(error <= minimum + share * way))
    throw InputFileException(what + "its places are " + std::to_string(error) +
                             " m from the true ones");
}

/** Reads truth.json and trajectory.txt of a session. */
FilmedSession
loadFilmedSession(const std::string& folder)
{
  const std::string path = folder + "/truth.json";
  requireThere(path,
               "the figures need the truth of a session that pcl_simulated_rig filmed");
  const YamlNode truth = loadYaml(path); // JSON is a subset of YAML
  requireFormat(truth, file_formats::truth);
  FilmedSession session;
  session.folder = folder;
  session.scene = truth.at("scene").text();
  session.observations = truth.at("observations").count(1, maximum);
  session.patterns = truth.at("patterns").count(1, maximum);
  session.lines = truth.at("lines").count(1, maximum);
  for (const YamlNode& plane : truth.at("planes").list(1, maximum)) {
    constexpr double level = 0.7; // cosine
    const auto& coefficients = plane.at("coefficients").list(4, 4);
    if (std::abs(coefficients[1].number(-farthest, farthest)) > level)
      continue;
    for (const YamlNode& rectangle : plane.at("rectangles").list(1, maximum))
      session.uprights.push_back(endsOf(rectangle));
  }
  session.trajectory = loadTrajectory(folder + "/" + trajectory_name);
  if (session.trajectory.poses.size() != session.observations)
    truth.at("observations").fail("is not the number of poses in trajectory.txt");
  return session;
}

/** Reads the results of pcl_compact_mapping for the session. */
MappedSession
loadMappedSession(const std::string& folder, const FilmedSession& session)
{
  const std::string advice = "make the map by pcl_compact_mapping " + session.folder;
  const auto path = [&](const std::string& name) {
    const std::string whole = folder + "/" + name;
    requireThere(whole, advice);
    return whole;
  };
  MappedSession map;
  map.folder = folder;
  map.after = loadTrajectory(path(trajectory_name));
  map.before = loadTrajectory(path("trajectory_before.txt"));
  if (map.before.poses.size() != map.after.poses.size())
    throw InputFileException(folder +
                             ": trajectory_before.txt and trajectory.txt differ "
                             "in number of poses");
  requireSameWay(map, session);
  const std::string clouds = path("stages/observations");
  for (const std::string& name : observationNames(clouds))
    map.observations.push_back((std::filesystem::path(clouds) / name).string());
  if (map.observations.size() != session.observations)
    throw InputFileException(
        clouds + ": has " + std::to_string(map.observations.size()) +
        " observations, the session " + std::to_string(session.observations));
  map.points = loadPointCloud(path("map.pcd")).cloud;
  if (!findField(map.points, "view", PCLPointField::INT32))
    throw InputFileException(folder + "/map.pcd: has no field view, an integer");
  map.map = loadCompactMap(folder);
  return map;
}

constexpr double camera_rate = 14;           // frames a second
constexpr std::size_t bytes_of_a_point = 16; // x y z rgb

std::string
grouped(std::size_t number)
{
  std::string text = std::to_string(number);
  for (std::size_t i = text.size(); i > 3; i -= 3)
    text.insert(i - 3, ",");
  return text;
}

std::string
fixed(double number, int digits)
{
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, number);
  return text;
}

double
ateOf(const Trajectory& found, const Trajectory& truth)
{
  const auto on_floor = [](const Trajectory& trajectory) {
    std::vector<PlanarPose> poses;
    for (const Eigen::Isometry3d& pose : trajectory.poses)
      poses.push_back(planarPartOf(pose));
    return poses;
  };
  return absoluteTrajectoryError(on_floor(found), on_floor(truth)).unaligned;
}

/** Finite points and image size of all observations. */
struct PointCount {
  std::size_t points = 0;
  int width = 0, height = 0; ///< px
};

PointCount
countPoints(const std::vector<std::string>& paths)
{
  PointCount count;
  for (const std::string& path : paths) {
    const PointCloudFile file = loadPointCloud(path);
    count.width = static_cast<int>(file.cloud.width);
    count.height = static_cast<int>(file.cloud.height);
    const PointView points = file.points();
    for (std::size_t i = 0; i < points.size(); ++i)
      count.points += points[i].allFinite() ? 1 : 0;
  }
  return count;
}

/** Compares numbers of the session and its map with those of the paper. */
std::string
tableOf(const FilmedSession& session,
        const MappedSession& mapped,
        const PointCount& count)
{
  const std::size_t observations = mapped.observations.size();
  const std::size_t shots = observations * session.patterns;
  double area = 0; // square metres of all planes
  for (const PlanePatch& plane : mapped.map.planes)
    area += plane.area;
  // of map.glb without its details, which are in no figure of the paper
  std::ifstream file(mapped.folder + "/report.json");
  const auto report = nlohmann::json::parse(file, nullptr, false);
  const std::size_t map_bytes =
      report.is_object() ? report.value(nlohmann::json::json_pointer("/bytes/textured"),
                                        std::size_t{0})
                         : 0;
  const std::size_t ratio =
      bytes_of_a_point * count.points / std::max<std::size_t>(map_bytes, 1);
  const RandomLinePattern pattern;
  const struct {
    const char *what, *paper;
    std::string here;
  } rows[] = {
      {"observations", "106", grouped(observations)},
      {"patterns an observation", "10", grouped(session.patterns)},
      {"lines a pattern", "200", grouped(session.lines)},
      {"pattern, px", "1024 x 768", sizeText(pattern.getWidth(), pattern.getHeight())},
      {"image, px", "640 x 480", sizeText(count)},
      {"points an observation", "138,653", grouped(count.points / observations)},
      {"points in all", "14,697,233", grouped(count.points)},
      {"shots under patterns, and what a camera of 14 a second takes for them",
       "not told",
       grouped(shots) + " in " + fixed(static_cast<double>(shots) / camera_rate, 1) +
           " s"},
      {"planes", "not told", grouped(mapped.map.planes.size())},
      {"area of all planes, m2", "not told", fixed(area, 1)},
      {"map.glb without details, bytes; points of 16 bytes to one of it",
       "not told",
       grouped(map_bytes) + "; " + grouped(ratio) + " : 1"},
      {"places of the robot off the truth before rectification, m rms",
       "not told",
       fixed(ateOf(mapped.before, session.trajectory), 3)},
      {"the same after",
       "not told",
       fixed(ateOf(mapped.after, session.trajectory), 3)}};
  std::string table = "| | paper | here |\n|---|---|---|\n";
  for (const auto& row : rows)
    table +=
        std::string("| ") + row.what + " | " + row.paper + " | " + row.here + " |\n";
  return table;
}

/** The text of figures.md: the table, and each figure with its description. */
std::string
figurePage(const std::string& table, const FigurePlan& plan, bool has_both)
{
  const auto observation = [](const ObservationFigure& figure) {
    return "observation " + std::to_string(figure.observation);
  };
  std::string page =
      "# The paper's figures again\n\n"
      "Of a simulated building: nothing here is a photograph. Colours are "
      "2.5 times as light as the cameras saw them.\n\n" +
      table;
  const std::pair<const char*, std::string> figures[] = {
      {"2",
       "Above: the reference image of " + observation(plan.fusion) +
           " with the projector off, then under three patterns. Middle: what stereo "
           "finds in each of them alone; red is near, blue far, black nothing. Below: "
           "the median of the disparities of all patterns, as in the paper; the "
           "disparities of all patterns matched together, of which the map is made; "
           "the surface that these are, in the colours of the first image."},
      {"3",
       "Acquisitions in the corridor, one a row: reference image, disparities of all "
       "patterns, the surface in the colours of the image."},
      {"4",
       "From the top: the true plan of what was filmed, with the robot's way; the "
       "points of the walls from above before rectification and after it, upon the "
       "true plan in red; the points after it from two places, without the ceiling."},
      {"5",
       "How the mesh of " + observation(plan.walls) +
           " grows, from the top: the triangles of the first splitting plane, then "
           "those of the planes that divide the halves, and so on; those of earlier "
           "steps are pale. Left as the paper does it, Fig. 6 with the raw points: "
           "each "
           "call also builds a triangle over every side that it receives. Right ours, "
           "with the points at their noise scale: each step has only the triangles "
           "that "
           "its planes cut."},
      {"7",
       "The mesh of " + observation(plan.mesh) +
           ". Left as the paper does it, with the raw points, whose noise exceeds "
           "their "
           "spacing; right ours, with the points at their noise scale."},
      {"8",
       "The planes with their textures as the robot sees them; on the top right "
       "without textures, each plane in a colour of its own. Plain grey is what no "
       "camera saw, white what lies on no plane."},
      {"9",
       "The textured planes from outside; planes that look away from the eye are left "
       "out."},
      {"10", "The same from the other end."}};
  for (const auto& [number, caption] : figures)
    page += std::string("\n## Fig. ") + number + "\n\n![Fig. " + number + "](fig" +
            number + ".png)\n\n" + caption + "\n";
  if (has_both) {
    page += "\n## Figs. 8 to 10 by the paper's way and by ours\n";
    for (const char* const number : {"8", "9", "10"})
      page +=
          std::string("\n![Fig. ") + number + " of both](fig" + number + "_both.png)\n";
    page += "\nLeft the map of the paper's way, right ours.\n";
  }
  return page;
}

constexpr double lightening = 2.5; // of the colours that the cameras saw

std::uint8_t
lightened(std::uint8_t level)
{
  return static_cast<std::uint8_t>(std::lround(std::min(lightening * level, 255.0)));
}

/** Brightens the colours of points. */
void
lighten(PCLPointCloud2& cloud)
{
  const PCLPointField* const color = findColor(cloud);
  if (!color)
    return;
  for (std::size_t i = 0; i < rowsOf(cloud); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint8_t& level = cloud.data[i * cloud.point_step + color->offset + c];
      level = lightened(level);
    }
}

/** A view from an eye, by default 640 x 480 px; up is -y. */
template <typename View = SceneView>
View
viewFrom(const FigureEye& eye, int width = 640, int height = 480)
{
  View view;
  view.width = width;
  view.height = height;
  view.from = eye.from;
  view.look = eye.look;
  view.up = -Eigen::Vector3f::UnitY();
  return view;
}

/** Returns the picture that a function draws into a given file.
 * \param[in] folder for that file, which is removed again */
cv::Mat3b
drawn(const OutputFolder& folder,
      const std::function<void(const std::string& path)>& draw)
{
  const std::string path = folder.path("drawing.png");
  {
    const UnlimitedMemory while_drawing;
    draw(path);
  }
  RgbImage image = loadRgbImage(path);
  std::filesystem::remove(path);
  return matOf(image).clone();
}

constexpr int gap = 6; // px between two pictures

double
aspectOf(const cv::Mat3b& picture)
{
  return static_cast<double>(picture.cols) / picture.rows;
}

/** Pictures beside each other; each pixel is the mean of the area that it covers. */
cv::Mat3b
rowOf(const std::vector<cv::Mat3b>& pictures, int width)
{
  double all_aspects = 0;
  for (const cv::Mat3b& picture : pictures)
    all_aspects += aspectOf(picture);
  const double height =
      (width - gap * (static_cast<double>(pictures.size()) - 1)) / all_aspects;
  cv::Mat3b row(std::max(1, cvRound(height)), width, white);
  double end = 0; // not rounded, so that the last picture ends with the row
  for (const cv::Mat3b& picture : pictures) {
    const int first = cvRound(end);
    end += height * aspectOf(picture);
    cv::Mat3b part = row.colRange(first, std::min(width, cvRound(end)));
    cv::resize(picture, part, part.size(), 0, 0, cv::INTER_AREA);
    end += gap;
  }
  return row;
}

/** Places rows of pictures below each other. Each row has the width of the sheet, and
 * its pictures have the same height.
 * \param[in] width pixels */
cv::Mat3b
sheetOf(const std::vector<std::vector<cv::Mat3b>>& rows, int width)
{
  std::vector<cv::Mat3b> parts;
  for (const auto& row : rows) {
    if (!parts.empty())
      parts.emplace_back(gap, width, white);
    parts.push_back(rowOf(row, width));
  }
  cv::Mat3b sheet;
  cv::vconcat(parts, sheet);
  return sheet;
}

/** Writes a figure.
 * \param[in] step between the levels of its colours: with fewer levels, the file of a
 * noisy picture is small */
void
saveFigure(const OutputFolder& folder,
           const std::string& name,
           const cv::Mat3b& picture,
           int step = 8)
{
  RgbImage image = rgbImageOf(picture);
  for (std::uint8_t& value : image.values)
    value = cv::saturate_cast<std::uint8_t>((value + step / 2) / step * step);
  savePng(folder.path(name), image);
}

// thresholds for a single shot, above what the noise of the cameras reaches by chance
constexpr double min_texture = 2; // grey levels
constexpr double min_correlation = 0.5;

/** Reads the shots of a session in any order, and computes disparities as
 * pcl_active_stereo does. */
class Acquisition {
public:
  Acquisition(const std::string& session, unsigned threads)
  {
    settings_.threads = threads;
    session_ = openSession(std::make_shared<TrinocularFileGrabber>(session), settings_);
  }

  /** The shots of an observation, rectified. */
  ObservationShots
  shotsOf(std::size_t observation) const
  {
    for (std::size_t i = 0; i < session_->size(); ++i)
      if (session_->numberOf(i) == observation)
        if (auto shots = session_->shots(i))
          return *shots;
    throw InputFileException(session_->name() + ": has no shot of observation " +
                             std::to_string(observation));
  }

  SessionObservation
  together(const ObservationShots& shots, const std::string& method) const
  {
    SessionSettings settings = settings_;
    settings.method = disparityFusionMethod(method);
    return ShotFusion(session_->rig(), settings, memoryCheck()).fuse(shots, {});
  }

  DisparityImage
  ofOne(const TrinocularFrame& shot) const
  {
    TrinocularMatching matching;
    matching.setInputRig(session_->rig());
    matching.setXOffset(session_->range().minimum);
    matching.setMaxDisparity(session_->range().count);
    matching.setNumberOfThreads(settings_.threads);
    // also for the shot without a pattern, which would otherwise be filled with guesses
    matching.setPeakFilter(min_texture);
    matching.setCorrelationThreshold(min_correlation);
    MatchedDisparity matched;
    matching.match(shot, matched);
    return matched.disparity;
  }

private:
  std::shared_ptr<const SessionSource> session_;
  SessionSettings settings_;
};

/** The shot under a pattern, or the one without a pattern. */
const TrinocularFrame&
shotUnder(const ObservationShots& shots, std::int32_t pattern)
{
  for (const TrinocularFrame::ConstPtr& frame : shots.frames)
    if (frame->pattern == pattern)
      return *frame;
  throw InputFileException("observation " + std::to_string(shots.number) +
                           " has no shot " +
                           (pattern == TrinocularFrame::no_pattern
                                ? "with the projector off"
                                : "under pattern " + std::to_string(pattern)));
}

/** Disparities as colours, from blue (far) over green to red (near); black if invalid.
 * The colours span nearly all disparities of one image. */
class DisparityColors {
public:
  explicit DisparityColors(const DisparityImage& disparity)
  {
    std::vector<float> found;
    std::copy_if(disparity.values.begin(),
                 disparity.values.end(),
                 std::back_inserter(found),
                 [](float value) { return std::isfinite(value); });
    if (found.empty())
      return;
    std::sort(found.begin(), found.end());
    const std::size_t cut = found.size() / 100;
    minimum_ = found[cut];
    maximum_ = std::max(found[found.size() - 1 - cut], minimum_ + 1e-3f);
  }

  cv::Mat3b
  of(const DisparityImage& disparity) const
  {
    cv::Mat1b levels(disparity.height, disparity.width), invalid(levels.size());
    for (std::size_t i = 0; i < disparity.values.size(); ++i) {
      const float value = disparity.values[i];
      const float share = (value - minimum_) / (maximum_ - minimum_);
      invalid.data[i] = std::isfinite(value) ? 0 : 1;
      // the colour scale begins with a blue that is hard to tell from black
      const float level = invalid.data[i] ? 0 : 25 + 230 * share;
      levels.data[i] = cv::saturate_cast<std::uint8_t>(level);
    }
    cv::Mat3b colors;
    cv::applyColorMap(levels, colors, cv::COLORMAP_TURBO);
    cv::cvtColor(colors, colors, cv::COLOR_BGR2RGB);
    colors.setTo(cv::Vec3b(0, 0, 0), invalid);
    return colors;
  }

private:
  float minimum_ = 0, maximum_ = 1; // px
};

/** The reference image, lighter. */
cv::Mat3b
reference(const TrinocularFrame& shot)
{
  const CameraImage& image = shot.image(RigCamera::Reference);
  cv::Mat picture = cv::Mat(image.values, true).reshape(image.channels, image.height);
  std::transform(picture.datastart, picture.dataend, picture.data, lightened);
  if (image.channels == 1)
    cv::cvtColor(picture, picture, cv::COLOR_GRAY2RGB);
  return picture;
}

/** Connects neighbouring pixels of an observation by triangles that face the camera.
 * Pixels whose depths differ by more than those of a slanted wall are not connected. */
TriangleMesh
surfaceOf(const PointCloud<PointXYZRGBSigma>& observation)
{
  TriangleMesh mesh;
  const auto width = static_cast<std::int32_t>(observation.width);
  const auto height = static_cast<std::int32_t>(observation.height);
  const auto add = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
    constexpr float largest_step = 0.03f; // relative to the depth
    const auto depth = [&](std::int32_t i) {
      return observation[static_cast<std::size_t>(i)].z;
    };
    const auto [minimum, maximum] = std::minmax({depth(a), depth(b), depth(c)});
    if (std::isfinite(depth(a) + depth(b) + depth(c)) &&
        maximum - minimum <= largest_step * minimum)
      mesh.triangles.push_back({a, b, c});
  };
  for (std::int32_t y = 0; y + 1 < height; ++y)
    for (std::int32_t x = 0; x + 1 < width; ++x) {
      const std::int32_t corner = y * width + x;
      add(corner, corner + width, corner + 1);
      add(corner + 1, corner + width, corner + width + 1);
    }
  return mesh;
}

cv::Mat3b
modelOf(const SessionObservation& made,
        const FigureEye& eye,
        const OutputFolder& folder)
{
  PCLPointCloud2 cloud;
  toPCLPointCloud2(made.cloud, cloud);
  lighten(cloud);
  return drawn(folder, [&](const std::string& path) {
    saveSnapshot(path, cloud, surfaceOf(made.cloud), viewFrom(eye));
  });
}

cv::Mat3b
fusionFigure(const Acquisition& acquisition,
             const FigurePlan& plan,
             const OutputFolder& folder)
{
  const ObservationShots shots = acquisition.shotsOf(plan.fusion.observation);
  const SessionObservation median = acquisition.together(shots, "median");
  const SessionObservation all = acquisition.together(shots, "spacetime");
  const DisparityColors colors(all.matched.disparity);
  std::vector<std::int32_t> shown = {TrinocularFrame::no_pattern};
  shown.insert(shown.end(), plan.patterns.begin(), plan.patterns.end());
  std::vector<cv::Mat3b> images, disparities;
  for (const std::int32_t pattern : shown) {
    const TrinocularFrame& shot = shotUnder(shots, pattern);
    images.push_back(reference(shot));
    disparities.push_back(colors.of(acquisition.ofOne(shot)));
  }
  return sheetOf({images,
                  disparities,
                  {colors.of(median.matched.disparity),
                   colors.of(all.matched.disparity),
                   modelOf(all, plan.fusion.eye, folder)}},
                 plan.width);
}

/** Draws fig2.png and fig3.png. */
void
drawAcquisitions(const std::string& session,
                 const FigurePlan& plan,
                 unsigned threads,
                 const OutputFolder& folder)
{
  const Acquisition acquisition(session, threads);
  saveFigure(folder, "fig2.png", fusionFigure(acquisition, plan, folder));
  std::vector<std::vector<cv::Mat3b>> rows;
  for (const ObservationFigure& example : plan.acquisitions) {
    const ObservationShots shots = acquisition.shotsOf(example.observation);
    const SessionObservation made = acquisition.together(shots, "spacetime");
    const DisparityImage& disparity = made.matched.disparity;
    rows.push_back({reference(shotUnder(shots, TrinocularFrame::no_pattern)),
                    DisparityColors(disparity).of(disparity),
                    modelOf(made, example.eye, folder)});
  }
  saveFigure(folder, "fig3.png", sheetOf(rows, plan.width));
}

const Color truth_color(255, 150, 140);
const Color trajectory_color(120, 160, 220);

Poses
transformed(const Eigen::Isometry3d& T, Poses poses)
{
  for (Eigen::Isometry3d& pose : poses)
    pose = T * pose;
  return poses;
}

/** Plans of the map, rotated so that its longer side is horizontal. */
class Plans {
public:
  /** \param[in] cut points farther above or below the first camera are left out,
   * metres */
  Plans(const FilmedSession& session, const MappedSession& map, double cut)
  : session_(session)
  , map_(map)
  , points_(map.points.data.data() + findField(map.points, "x")->offset,
            map.points.point_step,
            rowsOf(map.points))
  , cut_(cut)
  , view_(findField(map.points, "view")->offset)
  {
    Eigen::AlignedBox3d box;
    for (const Eigen::Isometry3d& pose : map.after.poses)
      box.extend(pose.translation());
    if (box.sizes().z() > box.sizes().x()) // z to the right, x downwards
      T_plan_map_ = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitY());
    PlanContents contents;
    for (const Trajectory* trajectory : {&map.before, &map.after})
      forEachPoint(*trajectory,
                   [&](const Eigen::Vector3d& point) { contents.addPoint(point); });
    // metres by which the extent is widened for the true walls
    constexpr double beyond = 0.8;
    const PlanExtent seen = contents.extent();
    contents.addPlace({seen.minimum.x() + seen.pixel * seen.width + beyond,
                       0,
                       seen.minimum.y() + seen.pixel * seen.height / 2});
    extent_ = contents.extent();
  }

  /** Draws only the walls. */
  cv::Mat3b
  truth() const
  {
    const auto poses = transformed(T_plan_map_, session_.trajectory.poses);
    RgbImage image = PlanPicture(extent_).draw(poses, channelsOf(trajectory_color));
    cv::Mat3b picture = matOf(image).clone();
    drawWalls(picture, 1, black);
    return named(picture, "true plan");
  }

  /** Draws the points at the poses of a trajectory, over the true walls. */
  cv::Mat3b
  of(const Trajectory& trajectory, const std::string& when) const
  {
    PlanPicture plan(extent_);
    forEachPoint(trajectory, [&](const Eigen::Vector3d& point) { plan.add(point); });
    RgbImage points = plan.draw(transformed(T_plan_map_, trajectory.poses),
                                channelsOf(trajectory_color));
    cv::Mat3b picture(extent_.height, extent_.width, white);
    drawWalls(picture, 2, truth_color);
    cv::min(picture, cv::Mat(matOf(points)), picture);
    return named(picture, when + " rectification - true plan in red");
  }

private:
  static cv::Mat3b
  named(cv::Mat3b picture, const std::string& name)
  {
    drawText(picture, {8, 14}, name, black);
    return picture;
  }

  /** Calls a function with each point near the height of the camera, in the plan, for
   * the pose of its observation in a trajectory. */
  template <typename Function>
  void
  forEachPoint(const Trajectory& trajectory, const Function& function) const
  {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (!(std::abs(points_[i].y()) <= cut_))
        continue;
      std::int32_t view;
      std::memcpy(&view,
                  map_.points.data.data() + i * map_.points.point_step + view_,
                  sizeof view);
      Eigen::Vector3d point = points_[i].cast<double>();
      const auto row = static_cast<std::size_t>(view);
      if (view >= 0 && row < trajectory.poses.size())
        point = trajectory.poses[row] * (map_.after.poses[row].inverse() * point);
      function(T_plan_map_ * point);
    }
  }

  void
  drawWalls(cv::Mat3b& image, int width, const Color& color) const
  {
    for (const auto& [from, to] : session_.uprights)
      drawLine(image,
               extent_.pixelOf(T_plan_map_ * from),
               extent_.pixelOf(T_plan_map_ * to),
               width,
               color);
  }

  const FilmedSession& session_;
  const MappedSession& map_;
  PointView points_;
  double cut_;
  std::size_t view_;
  Eigen::Isometry3d T_plan_map_ = Eigen::Isometry3d::Identity();
  PlanExtent extent_;
};

/** The points that are at most this height above the first camera. */
PCLPointCloud2
below(const PCLPointCloud2& cloud, double height)
{
  PCLPointCloud2 low = cloud;
  low.data.clear();
  const std::size_t y = findField(cloud, "y")->offset;
  for (std::size_t i = 0; i < rowsOf(cloud); ++i) {
    const auto* const row = cloud.data.data() + i * cloud.point_step;
    float down;
    std::memcpy(&down, row + y, sizeof down);
    if (down >= -height)
      low.data.insert(low.data.end(), row, row + cloud.point_step);
  }
  resizeRows(low, low.data.size() / cloud.point_step);
  return low;
}

/** Draws fig4.png. */
void
drawMapFigure(const FilmedSession& session,
              const MappedSession& map,
              const FigurePlan& plan,
              const OutputFolder& folder)
{
  const Plans plans(session, map, plan.cut);
  LayeredScene scene;
  scene.points = below(map.points, plan.cut);
  lighten(scene.points);
  std::vector<std::vector<cv::Mat3b>> rows = {{plans.truth()},
                                              {plans.of(map.before, "before")},
                                              {plans.of(map.after, "after")},
                                              {}};
  for (const FigureEye& eye : plan.perspectives) {
    auto view = viewFrom<LayeredView>(eye, 960, 720);
    view.layers = {SceneLayer::Points};
    rows.back().push_back(drawn(
        folder, [&](const std::string& path) { saveSnapshot(path, scene, view); }));
  }
  saveFigure(folder, "fig4.png", sheetOf(rows, plan.width));
}

struct ObservationMesh {
  PCLPointCloud2 vertices;
  TriangleMesh mesh;
};

/** Meshes the vertices, with the recursion depths of the walls. */
template <typename PointT>
void
triangulate(DeWallTriangulation<PointT> dewall,
            ObservationMesh& observation,
            const std::string& path,
            unsigned threads)
{
  const typename PointCloud<PointT>::Ptr cloud(new PointCloud<PointT>);
  fromPCLPointCloud2(observation.vertices, *cloud);
  dewall.setInputCloud(cloud);
  dewall.setComputeWallDepth(true);
  dewall.setNumberOfThreads(threads);
  dewall.reconstruct(observation.mesh);
  if (observation.mesh.triangles.empty())
    throw NothingFound(path + ": no triangle is possible");
}

/** The mesh of the raw points of an observation, as the paper makes it. */
ObservationMesh
papersMeshOf(const std::string& path, unsigned threads)
{
  DeWallTriangulation<PointXYZ> dewall;
  dewall.setAcceptanceRule(DeWallRule::Strict);
  ObservationMesh result;
  result.vertices = loadPointCloud(path).cloud;
  triangulate(dewall, result, path, threads);
  return result;
}

/** The mesh of an observation's cloud at its noise scale.
 * \param[in] leaf_size as for \ref DeWallTriangulation */
ObservationMesh
ourMeshOf(const std::string& path, int leaf_size, unsigned threads)
{
  VoxelConsolidation<PCLPointCloud2> consolidation;
  consolidation.setInputCloud(
      std::make_shared<const PCLPointCloud2>(loadPointCloud(path).cloud));
  // the cloud is in the camera's frame
  consolidation.setSensorOrigin(Eigen::Vector3f::Zero());
  consolidation.setNumberOfThreads(threads);
  ObservationMesh result;
  consolidation.filter(result.vertices);
  DeWallTriangulation<PointNormal> dewall;
  dewall.setLeafSize(leaf_size);
  dewall.setMaximumEdgeLength(mesh_edge_in_voxels *
                              consolidation.getReport().voxel_size);
  triangulate(dewall, result, path, threads);
  return result;
}

/** The first steps of the walls. */
std::vector<cv::Mat3b>
wallPictures(const ObservationMesh& observation,
             const FigurePlan& plan,
             const OutputFolder& folder)
{
  LayeredScene scene;
  scene.vertices = scene.points = observation.vertices;
  lighten(scene.points);
  scene.mesh = observation.mesh;
  auto view = viewFrom<LayeredView>(plan.walls.eye);
  view.layers = {SceneLayer::Points, SceneLayer::Mesh};
  std::vector<cv::Mat3b> pictures;
  const std::size_t steps = std::min(plan.wall_steps, wallSteps(observation.mesh));
  for (std::size_t step = 0; step < steps; ++step) {
    view.wall_step = step;
    pictures.push_back(drawn(
        folder, [&](const std::string& path) { saveSnapshot(path, scene, view); }));
  }
  return pictures;
}

cv::Mat3b
meshPicture(const ObservationMesh& observation,
            const FigurePlan& plan,
            const OutputFolder& folder)
{
  constexpr int finer = 2; // oversampling, since mesh edges are thinner than a pixel
  auto view = viewFrom(plan.mesh.eye, finer * plan.width, finer * (plan.width * 3 / 4));
  view.ignore_colors = true;
  view.show_edges = true;
  return drawn(folder, [&](const std::string& path) {
    saveSnapshot(path, observation.vertices, observation.mesh, view);
  });
}

/** Draws fig5.png and fig7.png: on the left as the paper, on the right ours. */
void
drawMeshes(const MappedSession& map,
           const FigurePlan& plan,
           unsigned threads,
           const OutputFolder& folder)
{
  // so few points that single walls can be distinguished
  constexpr int small_leaf = 256, usual_leaf = 0;
  const std::string& of_walls = map.observations[plan.walls.observation];
  const auto papers = wallPictures(papersMeshOf(of_walls, threads), plan, folder);
  const auto ours =
      wallPictures(ourMeshOf(of_walls, small_leaf, threads), plan, folder);
  std::vector<std::vector<cv::Mat3b>> rows;
  for (std::size_t step = 0; step < std::min(papers.size(), ours.size()); ++step)
    rows.push_back({papers[step], ours[step]});
  saveFigure(folder, "fig5.png", sheetOf(rows, plan.width));
  const std::string& of_mesh = map.observations[plan.mesh.observation];
  saveFigure(folder,
             "fig7.png",
             rowOf({meshPicture(papersMeshOf(of_mesh, threads), plan, folder),
                    meshPicture(ourMeshOf(of_mesh, usual_leaf, threads), plan, folder)},
                   plan.width));
}

cv::Mat3b
pictureOf(const CompactMap& map, const MapView& view, const OutputFolder& folder)
{
  return drawn(folder,
               [&](const std::string& path) { saveMapSnapshot(path, map, view); });
}

/** The planes from inside, as Fig. 8, and from outside, as Figs. 9 and 10. */
std::vector<cv::Mat3b>
planePictures(CompactMap map, const FigurePlan& plan, const OutputFolder& folder)
{
  map.exposure = lightening;
  const int height = plan.width * 3 / 4;
  auto view = viewFrom<MapView>(plan.inside, plan.width, height);
  view.place = MapView::Place::Inside;
  std::vector<cv::Mat3b> pictures = {pictureOf(map, view, folder)};
  cv::Mat3b& inside = pictures.front();
  view.paint = MapView::Paint::PlaneColors;
  constexpr int part = 3, frame = 4; // 1 / 3 of the figure's side; px
  const cv::Mat3b plain = rowOf({pictureOf(map, view, folder)}, plan.width / part);
  const int left = inside.cols - plain.cols;
  inside(cv::Rect(left - frame, 0, plain.cols + frame, plain.rows + frame)) = white;
  plain.copyTo(inside(cv::Rect({left, 0}, plain.size())));
  for (const FigureEye& eye : plan.outside)
    pictures.push_back(
        pictureOf(map, viewFrom<MapView>(eye, plan.width, height), folder));
  return pictures;
}

/** Draws fig8.png, fig9.png and fig10.png.
 * \param[in] papers also draws fig8_both.png …, with this map on the left */
void
drawPlanes(const CompactMap& map,
           const std::optional<CompactMap>& papers,
           const FigurePlan& plan,
           const OutputFolder& folder)
{
  constexpr int fine_step = 4; // textures are smooth
  const auto ours = planePictures(map, plan, folder);
  const auto literal =
      papers ? planePictures(*papers, plan, folder) : std::vector<cv::Mat3b>();
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const std::string name = "fig" + std::to_string(8 + i);
    saveFigure(folder, name + ".png", ours[i], i == 0 ? fine_step : 1);
    if (papers)
      saveFigure(folder,
                 name + "_both.png",
                 rowOf({literal[i], ours[i]}, plan.width),
                 fine_step);
  }
}

void
warnOfOtherScene(const FilmedSession& session, const FigurePlan& plan, StageLog& log)
{
  if (session.scene != plan.scene)
    log.warn("the figures are made for scene " + plan.scene + ", the session is of " +
             session.scene + ": the places of the eye may show little");
  else if (session.observations != plan.observations)
    log.warn("the figures are made for " + std::to_string(plan.observations) +
             " observations, the session has " + std::to_string(session.observations));
}

} // namespace

void
drawFigures(const FigureOptions& options, const RunControls& controls, StageLog& log)
{
  const DisplayConnection display;
  StepTimer timer(log.report);
  const FigurePlan plan = loadFigurePlan(options.figures);
  const FilmedSession session = loadFilmedSession(options.session);
  plan.requireWithin(session.observations, session.patterns);
  const MappedSession mapped = loadMappedSession(options.map, session);
  warnOfOtherScene(session, plan, log);
  OutputFolder folder(options.output);
  timer.finish("read");

  drawAcquisitions(options.session, plan, controls.threads, folder);
  timer.finish("stereo");
  stopIfInterrupted();
  drawMapFigure(session, mapped, plan, folder);
  timer.finish("map");
  stopIfInterrupted();
  drawMeshes(mapped, plan, controls.threads, folder);
  timer.finish("meshes");
  stopIfInterrupted();
  drawPlanes(mapped.map,
             options.papers_map.empty()
                 ? std::nullopt
                 : std::optional(loadCompactMap(options.papers_map)),
             plan,
             folder);
  timer.finish("planes");
  const PointCount count = countPoints(mapped.observations);
  const std::string page =
      figurePage(tableOf(session, mapped, count), plan, !options.papers_map.empty());
  OutputFile file(folder.path("figures.md"));
  file.write(page.data(), page.size());
  file.commit();
  timer.finish("count");
  stopIfInterrupted();
  folder.commit();

  const std::size_t observations = mapped.observations.size();
  log.details = {{"session", options.session},
                 {"map", options.map},
                 {"output", options.output},
                 {"observations", observations},
                 {"points", count.points},
                 {"planes", mapped.map.planes.size()}};
  log.tell("observations", std::to_string(observations) + " (paper: 106)");
  log.tell("points", std::to_string(count.points) + " (paper: 14697233)");
  log.tellSeconds();
  log.tell("figures", options.output + "/figures.md");
}

} // namespace pcl::acmap
