#include "viewer_options.h"

#include "command_line.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <map>
#include <optional>

namespace pcl::acmap {

namespace {

const std::map<std::string, SceneLayer> layer_names = {
    {"points", SceneLayer::Points},
    {"mesh", SceneLayer::Mesh},
    {"normals", SceneLayer::Normals},
    {"planes", SceneLayer::Planes},
    {"texture", SceneLayer::Texture},
    {"trajectory", SceneLayer::Trajectory}};

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
addPlaces(CLI::App& app, ViewerOptions& options)
{
  app.add_option("--view",
                 options.place,
                 oneOf(namesIn(place_names)) +
                     "; outside is oblique, plan from above, and inside, for planes, "
                     "wide [default: plan of a folder without planes, else outside]")
      ->type_name("PLACE")
      ->default_str("")
      ->check(nameAmong(namesIn(place_names)));
  app.add_option("--at",
                 options.at_pose,
                 "The eye is that of pose N of the trajectory, counted from 0")
      ->type_name("N")
      ->default_str("")
      ->check(CLI::NonNegativeNumber.description(""));
  addVector(app, "--from", options.from, "Place of the eye, metres [default: oblique]");
  addVector(
      app, "--look", options.look, "Middle of the picture, metres [default: scene]");
  addVector(app, "--up", options.up, "Upward direction [default: from the scene]");
  app.add_option("--size", options.size, "Width and height of the picture, pixels")
      ->type_name("WxH");
}

void
addStates(CLI::App& app, ViewerOptions& options)
{
  app.add_flag("--before",
               options.before,
               "As it was before rectification: points and trajectory");
  app.add_option("--step",
                 options.wall_step,
                 "The mesh as far as the walls of depth 0 to K have made it; it needs "
                 "wall depths")
      ->type_name("K")
      ->default_str("")
      ->check(CLI::NonNegativeNumber.description(""));
}

void
requireOnePlace(const ViewerOptions& options)
{
  const bool placed = !options.from.empty() || !options.look.empty() ||
                      !options.up.empty() || !options.place.empty();
  if (options.at_pose && placed)
    throw UsageError("--at is a place of the eye, beside which --view, --from, --look "
                     "and --up have no meaning");
  if (options.before && options.wall_step)
    throw UsageError("--step has no meaning beside --before, which shows no mesh");
}

std::optional<Eigen::Vector3f>
vectorOf(const std::vector<float>& values)
{
  if (values.empty())
    return {};
  return Eigen::Vector3f(values[0], values[1], values[2]);
}

} // namespace

void
addOptions(Tool& tool, ViewerOptions& options)
{
  CLI::App& app = tool.options();
  app.add_option(
         "input",
         options.input,
         "Mesh (.ply, .vtk), point cloud (.pcd, .ply, .obj, .xyz), planes (.json) "
         "or folder of a map, or of a rectification")
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
  addStates(app, options);
  addPlaces(app, options);
  app.add_flag("--boundary", options.boundary, "Draw the boundary of a mesh as lines");
  app.add_flag("--hide-backs",
               options.hide_backs,
               "Leave out the faces that look away, to see into rooms");
  app.add_flag("--labels",
               options.labels,
               "Colour by the field label of the points, as planes leave it");
  app.add_flag("--grey", options.grey, "Draw without the colours of the file");
  tool.addScale();
}

LayeredView
viewOf(const ViewerOptions& options)
{
  LayeredView view;
  char end = 0;
  if (std::sscanf(options.size.c_str(), "%dx%d%c", &view.width, &view.height, &end) !=
      2)
    throw UsageError("--size: " + options.size + " is not of the form WxH");
  if (!options.place.empty())
    view.place = place_names.at(options.place);
  for (const std::string& layer : options.layers)
    view.layers.insert(layer_names.at(layer));
  if (view.place == MapView::Place::Plan && !options.from.empty())
    throw UsageError("--from has no meaning for a plan, which is seen from above");
  requireOnePlace(options);
  view.at_pose = options.at_pose;
  view.before = options.before;
  view.wall_step = options.wall_step;
  view.from = vectorOf(options.from);
  view.look = vectorOf(options.look);
  view.up = vectorOf(options.up);
  view.show_boundary = options.boundary;
  view.hide_backs = options.hide_backs;
  view.ignore_colors = options.grey;
  return view;
}

} // namespace pcl::acmap
