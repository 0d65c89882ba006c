#include "command_line.h"
#include "output_target.h"
#include "reading_options.h"
#include "stage_reports.h"
#include "tool.h"

#include <pcl/conversions.h>
#include <pcl/core/cloud_assessment.h>
#include <pcl/core/impl/length_remarks.h>
#include <pcl/core/map_file.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/process_memory.h>
#include <pcl/pipeline/cloud_labels.h>
#include <pcl/pipeline/map_folder.h>
#include <pcl/visualization/layered_scene.h>
#include <pcl/visualization/scene_file.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

struct ViewerOptions {
  std::string input;
  std::string screenshot;
  std::vector<float> from;
  std::vector<float> look;
  std::string size =
      std::to_string(LayeredView().width) + "x" + std::to_string(LayeredView().height);
  std::vector<std::string> layers;
  std::string place;
  bool labels = false;
  LayeredView view; ///< options that need no conversion
};

/** \brief The data to be shown. */
struct ViewerInput {
  LayeredScene scene;
  std::optional<Eigen::Vector3f> sensor_origin; ///< metres; of a cloud or mesh
  Eigen::Quaternionf sensor_orientation = Eigen::Quaternionf::Identity();
  std::optional<Eigen::Vector3f> up; ///< of a cloud or mesh
  std::string up_line;               ///< what shows it; empty if it is stated
  std::vector<std::string> remarks;  ///< warnings
};

const std::map<std::string, SceneLayer> layer_names = {
    {"points", SceneLayer::Points},
    {"mesh", SceneLayer::Mesh},
    {"normals", SceneLayer::Normals},
    {"planes", SceneLayer::Planes},
    {"texture", SceneLayer::Texture},
    {"trajectory", SceneLayer::Trajectory},
    {"proposed", SceneLayer::Proposed}};

const std::map<std::string, MapView::Place> place_names = {
    {"outside", MapView::Place::Outside},
    {"inside", MapView::Place::Inside},
    {"plan", MapView::Place::Plan}};

template <typename Value>
std::vector<std::string>
namesIn(const std::map<std::string, Value>& values)
{
  std::vector<std::string> names;
  for (const auto& entry : values)
    names.push_back(entry.first);
  return names;
}

void
addPlaces(CLI::App& app, ViewerOptions& options)
{
  const auto add_vector =
      [&app](const char* name, std::vector<float>& value, const char* purpose) {
        app.add_option(name, value, purpose)
            ->expected(3)
            ->type_name("X Y Z")
            ->default_str("");
      };
  app.add_option("--view",
                 options.place,
                 oneOf(namesIn(place_names)) +
                     "; outside is oblique, plan from above, and inside, for planes, "
                     "wide [default: plan of a folder without planes, else outside]")
      ->type_name("PLACE")
      ->default_str("")
      ->check(nameAmong(namesIn(place_names)));
  app.add_option("--at",
                 options.view.at_pose,
                 "The eye is that of pose N of the trajectory, counted from 0")
      ->type_name("N")
      ->default_str("")
      ->check(CLI::NonNegativeNumber.description(""));
  add_vector("--from", options.from, "Place of the eye, metres [default: oblique]");
  add_vector("--look", options.look, "Middle of the picture, metres [default: scene]");
  app.add_option("--size", options.size, "Width and height of the picture, pixels")
      ->type_name("WxH");
}

void
addOptions(Tool& tool, ViewerOptions& options)
{
  CLI::App& app = tool.options();
  app.add_option("input",
                 options.input,
                 "Mesh (.ply, .vtk), point cloud (.pcd, .ply, .obj, .xyz, .txt, .csv, "
                 ".pts, .ptx, .las, .e57), "
                 "planes (.json) "
                 "or folder of a map, of observations, or of a rectification")
      ->type_name("FILE|DIR")
      ->required();
  app.add_option("--screenshot",
                 options.screenshot,
                 "Write a picture there instead of opening a window")
      ->type_name("OUT.png");
  app.add_option("--layers",
                 options.layers,
                 "What is shown, each " + oneOf(namesIn(layer_names)) +
                     " [default: texture, else planes, mesh, points]")
      ->delimiter(',')
      ->type_name("LAYER,..")
      ->default_str("")
      ->check(nameAmong(namesIn(layer_names)));
  app.add_flag("--before",
               options.view.before,
               "As it was before rectification: points and trajectory");
  app.add_option("--step",
                 options.view.wall_step,
                 "The mesh as far as the walls of depth 0 to K have made it; it needs "
                 "wall depths")
      ->type_name("K")
      ->default_str("")
      ->check(CLI::NonNegativeNumber.description(""));
  addPlaces(app, options);
  app.add_flag(
      "--boundary", options.view.show_boundary, "Draw the boundary of a mesh as lines");
  app.add_flag("--hide-backs",
               options.view.hide_backs,
               "Leave out the faces that look away, to see into rooms");
  app.add_flag("--labels",
               options.labels,
               "Colour by the field label of the points, as planes leave it");
  app.add_flag(
      "--grey", options.view.ignore_colors, "Draw without the colours of the file");
  addReading(app, tool.reader());
}

/** \throws UsageError for options that exclude each other */
void
requireOnePlace(const ViewerOptions& options, bool states_up)
{
  const bool placed = !options.from.empty() || !options.look.empty() || states_up ||
                      !options.place.empty();
  if (options.view.at_pose && placed)
    throw UsageError("--at is a place of the eye, beside which --view, --from, --look "
                     "and --up have no meaning");
  if (options.view.before && options.view.wall_step)
    throw UsageError("--step has no meaning beside --before, which shows no mesh");
}

std::optional<Eigen::Vector3f>
vectorOf(const std::vector<float>& values)
{
  if (values.empty())
    return {};
  return Eigen::Vector3f(values[0], values[1], values[2]);
}

LayeredView
viewOf(const ViewerOptions& options)
{
  LayeredView view = options.view;
  const auto size = crossedNumbers(options.size);
  if (!size)
    throw UsageError("--size: " + options.size + " is not of the form WxH");
  view.width = (*size)[0];
  view.height = (*size)[1];
  if (!options.place.empty())
    view.place = place_names.at(options.place);
  for (const std::string& layer : options.layers)
    view.layers.insert(layer_names.at(layer));
  if (view.place == MapView::Place::Plan && !options.from.empty())
    throw UsageError("--from has no meaning for a plan, which is seen from above");
  view.from = vectorOf(options.from);
  view.look = vectorOf(options.look);
  return view;
}

/** Does a path exist? If that cannot be determined, reading it later gives the
 * reason. */
bool
isThere(const fs::path& path)
{
  std::error_code error;
  return fs::exists(path, error);
}

void
note(const PointCloudFile& file, std::vector<std::string>& remarks)
{
  remarks.insert(remarks.end(), file.remarks.begin(), file.remarks.end());
  const std::vector<std::string> lengths = lengthRemarks(file.points());
  remarks.insert(remarks.end(), lengths.begin(), lengths.end());
}

/** \brief What a cloud is, as stated, else as its points show it. */
CloudAssessmentReport
assess(const std::shared_ptr<const PointCloudFile>& file,
       const PointCloudReader& reader)
{
  CloudAssessment assessment;
  assessment.setInputCloud(file);
  if (reader.getUpDirection())
    assessment.setUpDirection(*reader.getUpDirection());
  assessment.compute();
  return assessment.getReport();
}

void
takeUp(const UpEvidence& up, ViewerInput& input)
{
  input.up = up.value.cast<float>();
  if (up.outcome != UpOutcome::Stated)
    input.up_line = describe(up);
}

ViewerInput
loadFile(const std::string& path, const PointCloudReader& reader)
{
  SceneFile file = loadScene(path, reader);
  if (cloudExtent(file.points.points()).finite_points == 0)
    throw NothingFound(path + ": nothing to show, no point is finite");
  ViewerInput input;
  note(file.points, input.remarks);
  const auto points = std::make_shared<PointCloudFile>(std::move(file.points));
  const CloudAssessmentReport report = assess(points, reader);
  takeUp(report.up, input);
  if (report.sensors.isKnown())
    input.sensor_origin = points->sensor_origin;
  input.sensor_orientation = points->sensor_orientation;
  LayeredScene& scene = input.scene;
  (file.mesh.triangles.empty() ? scene.points : scene.vertices) =
      std::move(points->cloud);
  scene.mesh = std::move(file.mesh);
  return input;
}

/** \brief Number of points of the cloud, or of the mesh if there is no cloud. */
std::size_t
pointsIn(const LayeredScene& scene)
{
  const auto size = [](const PCLPointCloud2& cloud) {
    return std::size_t{cloud.width} * cloud.height;
  };
  return size(scene.points) != 0 ? size(scene.points) : size(scene.vertices);
}

/** Is a folder a sequence of observations? */
bool
hasClouds(const fs::path& folder)
{
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (endingOf(entry.path().string()) == ".pcd")
      return true;
  return false;
}

/** \brief Some of the points of all observations of a folder, under their poses. */
ViewerInput
loadObservations(const std::string& folder, const PointCloudReader& reader)
{
  constexpr std::size_t most_points = 2000000; // of all observations
  SequenceSample sample =
      sampleSequence(ObservationSequence(folder, reader.getScale()),
                     most_points,
                     [](double, const std::string&) { return !interrupted(); });
  if (sample.points.empty())
    throw NothingFound(folder + ": nothing to show, no point is finite");
  ViewerInput input;
  input.scene.map.trajectory = std::move(sample.trajectory);
  const auto merged = std::make_shared<PointCloudFile>();
  toPCLPointCloud2(sample.points, merged->cloud);
  if (const UpEvidence up = assess(merged, reader).up; up.isKnown())
    takeUp(up, input); // else the cameras tell it
  input.scene.points = std::move(merged->cloud);
  return input;
}

ViewerInput
loadFolder(const std::string& folder)
{
  MapFolder loaded = loadMapFolder(folder);
  ViewerInput input;
  input.scene = {std::move(loaded.cloud),
                 std::move(loaded.vertices),
                 std::move(loaded.mesh),
                 std::move(loaded.map),
                 std::move(loaded.trajectory_before)};
  input.remarks = std::move(loaded.remarks);
  return input;
}

/** \brief Reads a cloud, a mesh, planes (.json), a folder of observations, or one with
 * map.json, or with map.pcd and trajectory.txt, and the other files in the folder: mesh.ply, map.pcd,
 * trajectory.txt, trajectory_before.txt.
 * \param[in] reader of a cloud or mesh, with what is stated of it
 * \throws InputFileException naming file and fault
 * \throws UsageError for a scale of a map
 * \throws NothingFound when no point is finite and there is no plane */
ViewerInput
loadViewerInput(const std::string& path, const PointCloudReader& reader)
{
  std::error_code error;
  const bool is_folder = fs::is_directory(path, error);
  const bool is_map = is_folder || endingOf(path) == ".json";
  if (!is_map)
    return loadFile(path, reader);
  const fs::path place = path;
  if (is_folder && !isThere(place / "map.json") && !isThere(place / "map.pcd") &&
      hasClouds(place))
    return loadObservations(path, reader);
  if (reader.getScale() != 1)
    throw UsageError("--scale is for clouds and meshes; maps are in metres");
  ViewerInput input;
  if (is_folder)
    input = loadFolder(path);
  else
    input.scene.map = loadMapFile(path);
  const CompactMap& map = input.scene.map;
  if (map.planes.empty() && map.cylinders.empty() && pointsIn(input.scene) == 0)
    throw NothingFound(path + ": nothing to show, there is no plane");
  return input;
}

void
checkPlaces(const Tool& tool, const ViewerOptions& options)
{
  if (!options.screenshot.empty())
    requireWritable(options.screenshot, {".png"}, {options.input});
  tool.requireReportWritable({options.input, options.screenshot});
}

void
colorByLabel(LayeredScene& scene)
{
  if (scene.points.width != 0)
    scene.points = coloredByLabel(std::move(scene.points));
  if (scene.vertices.width != 0 || scene.points.width == 0)
    scene.vertices = coloredByLabel(std::move(scene.vertices));
}

/** \brief Chooses the plan for a cloud with poses: from outside, only its ceilings
 * would be visible. */
void
choosePlace(const ViewerOptions& options, const LayeredScene& scene, LayeredView& view)
{
  const bool is_chosen = !options.place.empty() || view.from || view.at_pose;
  if (!is_chosen && scene.map.planes.empty() && scene.map.cylinders.empty() &&
      scene.mesh.triangles.empty() && !scene.map.trajectory.poses.empty())
    view.place = MapView::Place::Plan;
}

void
summarize(const ViewerOptions& options, const ViewerInput& input, StageLog& log)
{
  const LayeredScene& scene = input.scene;
  const std::size_t points = pointsIn(scene);
  const std::size_t triangles = scene.mesh.triangles.size();
  log.details = {{"input", options.input},
                 {"output", options.screenshot},
                 {"report",
                  {{"points", points},
                   {"triangles", triangles},
                   {"planes", scene.map.planes.size()},
                   {"poses", scene.map.trajectory.poses.size()}}}};
  log.warn(input.remarks);
  if (!input.up_line.empty())
    log.tell("up", input.up_line);
  log.tell("points", std::to_string(points));
  log.tell("triangles", std::to_string(triangles));
  log.tell("planes", std::to_string(scene.map.planes.size()));
  if (const std::size_t cylinders = scene.map.cylinders.size(); cylinders > 0) {
    log.details["report"]["cylinders"] = cylinders;
    log.tell("cylinders", std::to_string(cylinders));
  }
  if (!options.screenshot.empty())
    log.tell("file", options.screenshot);
}

/** The last part of a path: "kitchen" of "maps/kitchen/". */
std::string
nameOf(const std::string& path)
{
  const fs::path whole = fs::absolute(path).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

void
show(const ViewerOptions& options, const PointCloudReader& reader, StageLog& log)
{
  requireOnePlace(options, reader.getUpDirection().has_value());
  LayeredView view = viewOf(options);
  StepTimer timer(log.report);
  std::optional<SceneWindow> window;
  if (options.screenshot.empty() && isThere(options.input)) {
    const UnlimitedMemory while_drawing;
    window.emplace(nameOf(options.input), view.width, view.height);
  }
  ViewerInput input = loadViewerInput(options.input, reader);
  timer.finish("read");
  if (options.labels)
    colorByLabel(input.scene);
  view.sensor_origin = input.sensor_origin;
  view.sensor_orientation = input.sensor_orientation;
  view.up = input.up;
  if (const std::optional<Eigen::Vector3d>& up = reader.getUpDirection())
    view.up = up->cast<float>(); // of a map
  choosePlace(options, input.scene, view);
  stopIfInterrupted();

  const UnlimitedMemory while_drawing;
  if (window) {
    obeyInterruptions();
    window->show(input.scene, view, [](const std::string& text) {
      std::fputs(text.c_str(), stdout);
      std::fflush(stdout);
    });
  }
  else
    saveSnapshot(options.screenshot, input.scene, view);
  timer.finish("draw");
  summarize(options, input, log);
}

} // namespace

} // namespace pcl::acmap

int
main(int argc, char** argv)
{
  using namespace pcl::acmap;
  Tool tool(
      "pcl_compact_viewer",
      "Shows a map, a triangle mesh or a point cloud, in a window or as a picture.");
  ViewerOptions options;
  addOptions(tool, options);
  tool.setHelp({{{"pcl_compact_viewer map", "A map in a window; h shows the keys."},
                 {"pcl_compact_viewer mesh.ply --screenshot mesh.png",
                  "A picture of a mesh or a cloud."}},
                {}});
  return tool.run(argc, argv, [&] {
    checkPlaces(tool, options);
    show(options, tool.reader(), tool.log());
  });
}
