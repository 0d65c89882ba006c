#include "cloud_labels.h"
#include "interruption.h"
#include "length_check.h"
#include "output_target.h"
#include "scaled_cloud.h"
#include "tool.h"

#include <pcl/visualization/mesh_snapshot.h>
#include <pcl/visualization/scene_file.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>

namespace {

using namespace pcl::acmap;

struct Options {
  std::string input;
  std::string screenshot;
  std::vector<float> from;
  std::vector<float> look;
  std::vector<float> up;
  std::string size = "1280x960";
  bool boundary = false;
  bool hide_backs = false;
  bool grey = false;
  bool labels = false;
};

void
addVector(CLI::App& app,
          const std::string& name,
          std::vector<float>& value,
          const std::string& purpose)
{
  app.add_option(name, value, purpose)
      ->expected(3)
      ->type_name("X Y Z")
      ->default_str("");
}

void
addOptions(Tool& tool, Options& options)
{
  CLI::App& app = tool.options();
  app.add_option("input",
                 options.input,
                 "Mesh (.ply, .vtk) or point cloud (.pcd, .ply, .obj, .xyz)")
      ->type_name("FILE")
      ->required();
  app.add_option("--screenshot",
                 options.screenshot,
                 "Write a picture there instead of opening a window")
      ->type_name("OUT.png");
  addVector(app, "--from", options.from, "Place of the eye, metres [default: oblique]");
  addVector(
      app, "--look", options.look, "Middle of the picture, metres [default: scene]");
  addVector(app, "--up", options.up, "Upward direction [default: from the scene]");
  app.add_option("--size", options.size, "Width and height of the picture, pixels")
      ->type_name("WxH");
  app.add_flag("--boundary", options.boundary, "Draw the boundary of a mesh as lines");
  app.add_flag("--hide-backs",
               options.hide_backs,
               "Leave out the faces of a mesh that look away, to see into rooms");
  app.add_flag("--labels",
               options.labels,
               "Colour by the field label of the points, as planes leave it");
  app.add_flag("--grey", options.grey, "Draw without the colours of the file");
  tool.addScale();
}

std::optional<Eigen::Vector3f>
vectorOf(const std::vector<float>& values)
{
  if (values.empty())
    return {};
  return Eigen::Vector3f(values[0], values[1], values[2]);
}

pcl::SceneView
viewOf(const Options& options, const pcl::PointCloudFile& file)
{
  pcl::SceneView view;
  char end = 0;
  if (std::sscanf(options.size.c_str(), "%dx%d%c", &view.width, &view.height, &end) !=
      2)
    throw UsageError("--size: " + options.size + " is not of the form WxH");
  view.from = vectorOf(options.from);
  view.look = vectorOf(options.look);
  view.up = vectorOf(options.up);
  view.sensor_origin = file.sensor_origin;
  view.sensor_orientation = file.sensor_orientation;
  view.show_boundary = options.boundary;
  view.hide_backs = options.hide_backs;
  view.ignore_colors = options.grey;
  return view;
}

void
checkPlaces(const Tool& tool, const Options& options)
{
  if (!options.screenshot.empty())
    requireWritable(options.screenshot, {".png"}, {options.input});
  tool.requireReportWritable({options.input, options.screenshot});
  if (std::filesystem::is_directory(options.input))
    throw pcl::InputFileException(options.input +
                                  ": is a folder, only single files can be shown yet");
}

void
summarize(Tool& tool, const Options& options, const pcl::SceneFile& scene)
{
  const std::size_t points = scene.points.points().size();
  const std::size_t triangles = scene.mesh.triangles.size();
  tool.details() = {{"input", options.input},
                    {"output", options.screenshot},
                    {"report", {{"points", points}, {"triangles", triangles}}}};
  for (const std::string& remark : scene.points.remarks)
    tool.warn(remark);
  for (const std::string& remark :
       lengthRemarks(scene.points.points(), 0, tool.scale()))
    tool.warn(remark);
  tool.tell("points", std::to_string(points));
  tool.tell("triangles", std::to_string(triangles));
  if (!options.screenshot.empty())
    tool.tell("file", options.screenshot);
}

void
show(Tool& tool, const Options& options)
{
  checkPlaces(tool, options);
  StepTimer timer(tool.report());
  pcl::SceneFile scene = pcl::loadScene(options.input);
  scaleCloud(scene.points, tool.scale());
  timer.finish("read");
  if (cloudExtent(scene.points.points()).finite_points == 0)
    throw NothingFound(options.input + ": nothing to show, no point is finite");
  if (options.labels)
    scene.points.cloud = coloredByLabel(std::move(scene.points.cloud));
  tool.stopIfInterrupted();

  const pcl::SceneView view = viewOf(options, scene.points);
  if (options.screenshot.empty()) {
    obeyInterruptions();
    pcl::showScene(options.input, scene.points.cloud, scene.mesh, view);
  }
  else
    pcl::saveSnapshot(options.screenshot, scene.points.cloud, scene.mesh, view);
  timer.finish("draw");
  summarize(tool, options, scene);
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool("pcl_compact_viewer",
            "Shows a triangle mesh or a point cloud, in a window or as a picture.");
  Options options;
  addOptions(tool, options);
  return tool.run(argc, argv, [&] { show(tool, options); });
}
