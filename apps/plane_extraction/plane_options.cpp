#include "plane_options.h"

#include "command_line.h"
#include "output_target.h"

#include <CLI/CLI.hpp>

namespace pcl::acmap {

namespace {

void
addOutput(CLI::App& app,
          const std::string& name,
          std::string& path,
          const std::string& type,
          const std::string& purpose)
{
  app.add_option(name, path, purpose)->type_name(type);
}

} // namespace

void
addPlaneChoices(Tool& tool, PlaneOptions& options)
{
  CLI::App& app = tool.options();
  tool.addLengthOrAuto("--consolidate",
                       options.voxel_size,
                       "The voxel's edge in metres to which a cloud is consolidated "
                       "[default: by its noise and spacing, and not at all where that "
                       "is small]; given for a mesh, its vertices are taken as a "
                       "cloud");
  app.add_option(
         "--min-area",
         options.min_area,
         "Least area of a plane in square metres [default: 0.1, or 0.3 % of the "
         "surface where that is less]")
      ->type_name("M2")
      ->check(positiveNumber().description(""));
  app.add_option("--tolerance",
                 options.tolerance,
                 "How far off a plane in metres points and bumps are still of it "
                 "[default: by the noise, warped walls up to 0.025]")
      ->type_name("M")
      ->check(positiveNumber().description(""));
  addSensor(tool, options.sensor);
  app.add_flag("--regular",
               options.regular,
               "Turn planes to be exactly parallel or at right angles to larger ones, "
               "within their own uncertainty and a degree");
  app.add_flag(
      "--paper",
      options.paper,
      "The paper's fixed thresholds (0.8 m, 22.5 degrees, 0.25 m, more than 50 "
      "points) instead of those of the noise");
}

void
addOptions(Tool& tool, PlaneOptions& options)
{
  CLI::App& app = tool.options();
  app.add_option(
         "input",
         options.input,
         "Point cloud (.pcd, .ply, .obj, .xyz), or mesh (.ply or .obj with faces)")
      ->type_name("IN")
      ->required();
  app.add_option("output", options.output, "Planes to write, in metres: .json")
      ->type_name("PLANES.json")
      ->required();
  addOutput(app,
            "--labels",
            options.labels,
            "OUT.pcd",
            "Write the input's points with a field label: plane id + 1, 0 for none");
  addOutput(app,
            "--normals",
            options.normals,
            "OUT.ply",
            "Write the mesh with its voted normals, creases and labels");
  addOutput(app,
            "--picture",
            options.picture,
            "OUT.png",
            "Draw the mesh in colours by plane; needs an X server, as xvfb-run gives");
  addPlaneChoices(tool, options);
  tool.addThreads();
  tool.addScale();
}

void
checkChoices(const PlaneOptions& options)
{
  const auto refuse = [&](bool is_given, const std::string& option) {
    if (options.paper && is_given)
      throw UsageError(option + " is not among the paper's thresholds, leave it out "
                                "with --paper");
  };
  refuse(options.min_area.has_value(), "--min-area");
  refuse(options.tolerance.has_value(), "--tolerance");
  if (options.sensor != DepthSensor::Automatic && options.isInSpace())
    throw UsageError(
        "--sensor is not used with --consolidate, --tolerance and --paper, "
        "which work in space: leave it out");
}

void
checkPlaces(const Tool& tool, const PlaneOptions& options)
{
  std::vector<std::string> others = {options.input};
  const auto check = [&](const std::string& path, const char* ending) {
    if (path.empty())
      return;
    requireWritable(path, {ending}, others);
    others.push_back(path);
  };
  check(options.output, ".json");
  check(options.labels, ".pcd");
  check(options.normals, ".ply");
  check(options.picture, ".png");
  tool.requireReportWritable(others);
  checkChoices(options);
}

} // namespace pcl::acmap
