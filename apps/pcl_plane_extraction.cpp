#include "cloud_labels.h"
#include "length_check.h"
#include "output_group.h"
#include "output_target.h"
#include "plane_extraction/extraction.h"
#include "plane_extraction/plane_outputs.h"
#include "plane_extraction/plane_reports.h"

#include <pcl/core/map_file.h>
#include <pcl/core/mesh_file.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/visualization/display_connection.h>

#include <optional>

namespace {

using namespace pcl::acmap;

void
writeOutputs(const Tool& tool,
             const PlaneOptions& options,
             const pcl::MappedPlanes& found,
             pcl::PointCloudFile file)
{
  OutputGroup outputs;
  const auto write = [&](const std::string& path, const auto& save) {
    tool.stopIfInterrupted();
    if (!path.empty())
      outputs.write(path, save);
  };
  write(options.output, [&](const std::string& place) {
    pcl::CompactMap map;
    map.planes = found.planes;
    pcl::saveMapFile(place, map);
  });
  write(options.normals, [&](const std::string& place) { saveNormals(place, found); });
  write(options.picture, [&](const std::string& place) { savePicture(place, found); });
  write(options.labels, [&](const std::string& place) {
    saveLabels(place, std::move(file), found.labels);
  });
  tool.stopIfInterrupted();
  outputs.commit();
}

void
summarize(Tool& tool, const PlaneOptions& options, const pcl::MappedPlanes& found)
{
  tellPlanes(tool, found.planes, found.labels, found.finite_points);
  tool.tellSeconds();
  tool.details()["input"] = options.input;
  tool.details()["output"] = options.output;
  for (const std::string& path :
       {options.output, options.labels, options.normals, options.picture})
    if (!path.empty())
      tool.tell("file", path);
}

std::vector<Eigen::Vector3f>
viewpointsOf(Tool& tool, const PlaneOptions& options, const pcl::PointCloudFile& file)
{
  std::vector<std::string> remarks;
  std::vector<Eigen::Vector3f> viewpoints =
      viewpointsOfFile(file, options.input, tool.scale(), remarks);
  for (const std::string& remark : remarks)
    tool.warn(remark);
  return viewpoints;
}

void
run(Tool& tool, const PlaneOptions& options)
{
  checkPlaces(tool, options);
  std::optional<DisplayConnection> display;
  if (!options.picture.empty())
    display.emplace();
  StepTimer timer(tool.report());
  const auto file = std::make_shared<pcl::PointCloudFile>(
      loadScaledCloud(options.input, tool.scale()));
  pcl::TriangleMesh triangles;
  const std::string ending = endingOf(options.input);
  if (!options.voxel_size && (ending == ".ply" || ending == ".obj"))
    triangles = pcl::loadTriangleMesh(options.input);
  std::vector<Eigen::Vector3f> viewpoints;
  if (triangles.triangles.empty())
    viewpoints = viewpointsOf(tool, options, *file);
  timer.finish("read");
  tool.stopIfInterrupted();

  const pcl::MappedPlanes found =
      extractPlanes(tool, options, file, std::move(viewpoints), std::move(triangles));
  for (const std::string& remark : file->remarks)
    tool.warn(remark);
  for (const std::string& remark :
       lengthRemarks(found.vertices.points(), found.spacing, tool.scale()))
    tool.warn(remark);
  requirePlanes(tool, options.input, found);
  StepTimer write_timer(tool.report());
  writeOutputs(tool, options, found, std::move(*file));
  write_timer.finish("write");
  summarize(tool, options, found);
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool("pcl_plane_extraction", "Finds the planes of a point cloud or a mesh.");
  PlaneOptions options;
  addOptions(tool, options);
  return tool.run(argc, argv, [&] { run(tool, options); });
}
