#include "length_check.h"
#include "memory.h"
#include "output_target.h"
#include "scaled_cloud.h"
#include "tool.h"

#include <pcl/core/mesh_file.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/surface/dewall_triangulation.h>

#include "command_line.h"

#include <CLI/CLI.hpp>

#include <map>

namespace {

using namespace pcl::acmap;

struct Options {
  std::string input;
  std::string output;
  double maximum_edge_length = 0;
  pcl::DeWallRule rule = pcl::DeWallRule::Paper;
  bool wall_depth = false;
};

const std::map<std::string, pcl::DeWallRule> rules = {
    {"paper", pcl::DeWallRule::Paper}, {"dense", pcl::DeWallRule::Dense}};

void
addOptions(Tool& tool, Options& options)
{
  CLI::App& app = tool.options();
  app.add_option("input", options.input, "Point cloud: .pcd, .ply, .obj or .xyz")
      ->type_name("IN")
      ->required();
  app.add_option("output", options.output, "Triangle mesh to write: .ply or .vtk")
      ->type_name("OUT")
      ->required();
  app.add_option("--max-edge",
                 options.maximum_edge_length,
                 "No edge is longer, in metres [default: automatic, from the spacing "
                 "around each point]")
      ->type_name("M")
      ->default_str("")
      ->check(positiveNumber().description(""));
  app.add_option(
         "--rule",
         options.rule,
         "paper: no point inside the smallest sphere through a triangle; dense: "
         "no such test, covers noisy surfaces better [default: paper]")
      ->type_name("paper|dense")
      ->default_str("")
      ->transform(CLI::CheckedTransformer(rules).description(""));
  app.add_flag("--wall-depth",
               options.wall_depth,
               "Write with each triangle the depth of the dividing wall that made it "
               "(.ply only)");
  tool.addThreads();
  tool.addScale();
}

void
checkPlaces(const Tool& tool, const Options& options)
{
  requireWritable(options.output, {".ply", ".vtk"}, {options.input});
  tool.requireReportWritable({options.input, options.output});
  if (options.wall_depth && endingOf(options.output) != ".ply")
    throw UsageError("--wall-depth needs an output that ends in .ply");
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
coordinatesOf(const pcl::PointCloudFile& file)
{
  const PointView view = file.points();
  // the class states 220 bytes a point; the copy comes on top
  constexpr std::size_t bytes_per_point = 240;
  requireMemory(view.size() * bytes_per_point, "triangulating this cloud");
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  cloud->reserve(view.size());
  for (std::size_t i = 0; i < view.size(); ++i)
    cloud->push_back(pcl::PointXYZ(view[i].x(), view[i].y(), view[i].z()));
  // An organized cloud is known to come from one sensor.
  cloud->width = file.cloud.width;
  cloud->height = file.cloud.height;
  cloud->is_dense = false;
  cloud->sensor_origin_.head<3>() = file.sensor_origin;
  cloud->sensor_orientation_ = file.sensor_orientation;
  return cloud;
}

nlohmann::ordered_json
jsonOf(const pcl::DeWallReport& report)
{
  return {{"points", report.points},
          {"invalid_points", report.invalid_points},
          {"duplicate_points", report.duplicate_points},
          {"used_points", report.used_points},
          {"clusters", report.clusters},
          {"triangles", report.triangles},
          {"edges", report.edges},
          {"boundary_edges", report.boundary_edges},
          {"components", report.components},
          {"refused_moebius", report.refused_moebius},
          {"removed_fans", report.removed_fans},
          {"median_spacing", report.median_spacing},
          {"least_maximum_edge", report.least_maximum_edge},
          {"largest_maximum_edge", report.largest_maximum_edge}};
}

std::string
percent(std::size_t part, std::size_t whole)
{
  return shortNumber(whole ? 100.0 * static_cast<double>(part) /
                                 static_cast<double>(whole)
                           : 0.0) +
         " %";
}

pcl::DeWallReport
triangulate(Tool& tool,
            const Options& options,
            const pcl::PointCloudFile& file,
            pcl::TriangleMesh& mesh)
{
  pcl::DeWallTriangulation<pcl::PointXYZ> dewall;
  dewall.setInputCloud(coordinatesOf(file));
  dewall.setMaximumEdgeLength(options.maximum_edge_length);
  dewall.setAcceptanceRule(options.rule);
  dewall.setComputeWallDepth(options.wall_depth);
  dewall.setNumberOfThreads(tool.threads());
  tool.withProgress([&](const pcl::ProgressCallback& progress) {
    dewall.setProgressCallback(progress);
    dewall.reconstruct(mesh);
  });
  return dewall.getReport();
}

void
collectWarnings(Tool& tool,
                const pcl::PointCloudFile& file,
                const pcl::DeWallReport& report)
{
  for (const std::string& remark : file.remarks)
    tool.warn(remark);
  for (const std::string& remark : report.remarks)
    tool.warn(remark);
  for (const std::string& remark :
       lengthRemarks(file.points(), report.median_spacing, tool.scale()))
    tool.warn(remark);
}

void
requireTriangles(const Tool& tool, const Options& options, std::size_t triangles)
{
  if (triangles > 0)
    return;
  std::string reason = options.input + ": no triangle is possible";
  for (const std::string& remark : tool.warnings())
    reason += "; " + remark;
  throw NothingFound(reason);
}

void
summarize(Tool& tool, const Options& options, const pcl::DeWallReport& report)
{
  double seconds = 0;
  for (const auto& step : tool.report().seconds)
    seconds += step.second;
  tool.tell("points", std::to_string(report.points));
  tool.tell(
      "used",
      std::to_string(report.used_points) + " (" +
          percent(report.used_points,
                  report.points - report.invalid_points - report.duplicate_points) +
          " of the finite, different ones)");
  tool.tell("triangles", std::to_string(report.triangles));
  tool.tell("components", std::to_string(report.components));
  tool.tell("boundary", percent(report.boundary_edges, report.edges) + " of the edges");
  tool.tell("seconds", shortNumber(seconds));
  tool.tell("file", options.output);
}

void
meshCloud(Tool& tool, const Options& options)
{
  checkPlaces(tool, options);
  StepTimer timer(tool.report());
  const pcl::PointCloudFile file = loadScaledCloud(options.input, tool.scale());
  timer.finish("read");
  tool.stopIfInterrupted();

  pcl::TriangleMesh mesh;
  const pcl::DeWallReport report = triangulate(tool, options, file, mesh);
  timer.finish("triangulate");
  collectWarnings(tool, file, report);
  requireTriangles(tool, options, mesh.triangles.size());

  tool.stopIfInterrupted();
  pcl::saveTriangleMesh(options.output, file.cloud, mesh);
  timer.finish("write");

  tool.details() = {
      {"input", options.input}, {"output", options.output}, {"report", jsonOf(report)}};
  for (const auto& [step, seconds] : report.seconds)
    tool.details()["report"]["seconds"][step] = seconds;
  summarize(tool, options, report);
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool("pcl_dewall_surface",
            "Makes an open, manifold triangle mesh of a point cloud.");
  Options options;
  addOptions(tool, options);
  return tool.run(argc, argv, [&] { meshCloud(tool, options); });
}
