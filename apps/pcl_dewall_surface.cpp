#include "cloud_labels.h"
#include "command_line.h"
#include "length_check.h"
#include "memory.h"
#include "output_target.h"
#include "sensor_option.h"
#include "stage_reports.h"
#include "tool.h"

#include <pcl/conversions.h>
#include <pcl/core/mesh_file.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/filters/depth_refinement.h>
#include <pcl/filters/voxel_consolidation.h>
#include <pcl/pipeline/picture.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/surface/dewall_triangulation.h>

#include <CLI/CLI.hpp>

#include <optional>

namespace {

using namespace pcl::acmap;

struct Options {
  std::string input;
  std::string output;
  std::optional<double> voxel_size;
  pcl::DepthSensor sensor = pcl::DepthSensor::Automatic;
  double maximum_edge_length = 0;
  pcl::DeWallRule rule = pcl::DeWallRule::Paper;
  bool wall_depth = false;
};

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
  tool.addLengthOrAuto("--consolidate",
                       options.voxel_size,
                       "First replace the points of each voxel by one on their plane; "
                       "the voxel's edge in "
                       "metres, or automatic from noise and spacing. For noisy clouds. "
                       "Automatic: the steps of a depth camera's view are taken out in "
                       "its picture instead");
  addSensor(tool, options.sensor);
  app.add_option("--max-edge",
                 options.maximum_edge_length,
                 "No edge is longer, in metres [default: automatic, from the spacing "
                 "around each point; 2.5 voxels of a consolidated cloud]")
      ->type_name("M")
      ->default_str("")
      ->check(positiveNumber().description(""));
  addChoice<pcl::DeWallRule>(
      app,
      "--rule",
      options.rule,
      {{"paper", pcl::DeWallRule::Paper}, {"dense", pcl::DeWallRule::Dense}},
      "paper: no point inside the smallest sphere through a triangle; dense: no such "
      "test, covers noisy surfaces better");
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

template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr
typedCloud(const pcl::PointCloudFile& file)
{
  const std::size_t size = file.points().size();
  requireMemory(estimateDeWallMemory(size, true) + size * sizeof(PointT),
                "triangulating this cloud");
  typename pcl::PointCloud<PointT>::Ptr cloud(new pcl::PointCloud<PointT>);
  pcl::fromPCLPointCloud2(file.cloud, *cloud);
  // An organized cloud is measured by a single sensor.
  cloud->width = file.cloud.width;
  cloud->height = file.cloud.height;
  cloud->is_dense = false;
  cloud->sensor_origin_.template head<3>() = file.sensor_origin;
  cloud->sensor_orientation_ = file.sensor_orientation;
  return cloud;
}

bool
hasNormals(const pcl::PointCloudFile& file)
{
  std::size_t found = 0;
  for (const pcl::PCLPointField& field : file.cloud.fields)
    for (const char* name : {"normal_x", "normal_y", "normal_z"})
      found += field.name == name && field.datatype == pcl::PCLPointField::FLOAT32;
  return found == 3;
}

template <typename PointT>
pcl::DeWallReport
triangulate(Tool& tool,
            const Options& options,
            const pcl::PointCloudFile& file,
            double maximum_edge_length,
            pcl::TriangleMesh& mesh)
{
  pcl::DeWallTriangulation<PointT> dewall;
  dewall.setInputCloud(typedCloud<PointT>(file));
  dewall.setMaximumEdgeLength(maximum_edge_length);
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
summarize(Tool& tool, const Options& options, const pcl::DeWallReport& report)
{
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
  tool.tellSeconds();
  tool.tell("file", options.output);
}

std::shared_ptr<const pcl::PCLPointCloud2>
giveUp(pcl::PCLPointCloud2& cloud)
{
  return std::make_shared<const pcl::PCLPointCloud2>(std::move(cloud));
}

/** Replaces the cloud by its consolidation.
 * \return the edge length of a voxel, metres */
double
consolidate(Tool& tool, const Options& options, pcl::PointCloudFile& file)
{
  std::vector<std::string> remarks;
  pcl::VoxelConsolidation<pcl::PCLPointCloud2> consolidation;
  consolidation.setViewpoints(
      viewpointsOfFile(file, options.input, tool.scale(), remarks));
  consolidation.setSensorOrigin(file.sensor_origin);
  for (const std::string& remark : remarks)
    tool.warn(remark);
  if (*options.voxel_size > 0)
    requireFineLength(tool, "--consolidate", *options.voxel_size, file.points());
  consolidation.setVoxelSize(*options.voxel_size);
  consolidation.setNumberOfThreads(tool.threads());
  consolidation.setInputCloud(giveUp(file.cloud));
  tool.withProgress([&](const pcl::ProgressCallback& progress) {
    consolidation.setProgressCallback(progress);
    consolidation.filter(file.cloud);
  });
  const pcl::ConsolidationReport& report = consolidation.getReport();
  for (const std::string& remark : report.remarks)
    tool.warn(remark);
  tellConsolidation(tool, report);
  return report.voxel_size;
}

/** Removes the quantisation steps of the cloud, which becomes organized. */
void
refine(Tool& tool, const Picture& picture, pcl::PointCloudFile& file)
{
  if (picture.order)
    file.cloud = picture.order->arrange(file.cloud);
  pcl::DepthRefinement<pcl::PCLPointCloud2> refinement;
  refinement.setNumberOfThreads(tool.threads());
  refinement.setInputCloud(giveUp(file.cloud));
  tool.withProgress([&](const pcl::ProgressCallback& progress) {
    refinement.setProgressCallback(progress);
    refinement.filter(file.cloud);
  });
  tellDepthNoise(tool, refinement.getReport().noise);
  tellRefinement(tool, refinement.getReport());
}

/** The picture in which a cloud is refined; nothing if it is processed in space. */
std::optional<Picture>
pictureOfFile(const Options& options, const pcl::PointCloudFile& file)
{
  const bool is_automatic = options.voxel_size.value_or(0) == 0;
  try {
    return is_automatic ? pictureOf(file.points(), file.cloud.width, options.sensor)
                        : std::nullopt;
  }
  catch (const pcl::UnorganizedPointCloudException&) {
    throw UsageError(needs_picture);
  }
}

void
meshCloud(Tool& tool, const Options& options)
{
  checkPlaces(tool, options);
  StepTimer timer(tool.report());
  pcl::PointCloudFile file = loadScaledCloud(options.input, tool.scale());
  timer.finish("read");
  tool.stopIfInterrupted();

  double maximum_edge_length = options.maximum_edge_length;
  const std::optional<Picture> picture = pictureOfFile(options, file);
  if (picture && options.voxel_size) {
    refine(tool, *picture, file);
    timer.finish("refine");
  }
  else if (options.voxel_size) {
    const double voxel_size = consolidate(tool, options, file);
    timer.finish("consolidate");
    if (maximum_edge_length == 0)
      maximum_edge_length = pcl::mesh_edge_in_voxels * voxel_size;
  }
  else if (picture && measureDepthStep(file.points()) > 0)
    tool.warn(
        "the depth is quantised, and the mesh shows its steps: --consolidate takes "
        "them out");
  pcl::TriangleMesh mesh;
  const pcl::DeWallReport report =
      hasNormals(file)
          ? triangulate<pcl::PointNormal>(
                tool, options, file, maximum_edge_length, mesh)
          : triangulate<pcl::PointXYZ>(tool, options, file, maximum_edge_length, mesh);
  timer.finish("triangulate");
  collectWarnings(tool, file, report);
  if (mesh.triangles.empty())
    tool.failWithNothing(options.input + ": no triangle is possible");

  tool.stopIfInterrupted();
  pcl::saveTriangleMesh(options.output, file.cloud, mesh);
  timer.finish("write");

  tool.details()["input"] = options.input;
  tool.details()["output"] = options.output;
  tool.details()["report"] = jsonOf(report);
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
