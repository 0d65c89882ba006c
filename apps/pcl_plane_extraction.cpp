#include "length_check.h"
#include "output_group.h"
#include "output_target.h"
#include "plane_extraction/extraction.h"
#include "plane_extraction/plane_outputs.h"
#include "plane_extraction/plane_reports.h"

#include <pcl/core/map_file.h>
#include <pcl/core/mesh_file.h>
#include <pcl/core/scaled_cloud.h>
#include <pcl/visualization/display_connection.h>

#include <optional>

namespace {

using namespace pcl::acmap;

void
writeOutputs(const Tool& tool,
             const PlaneOptions& options,
             const Extraction& extraction,
             pcl::PointCloudFile file)
{
  OutputGroup outputs;
  const auto write = [&](const std::string& path, const auto& save) {
    tool.stopIfInterrupted();
    if (!path.empty())
      outputs.write(path, save);
  };
  const std::vector<std::int32_t>& labels = extraction.clusters.labels;
  write(options.output, [&](const std::string& place) {
    pcl::CompactMap map;
    map.planes = extraction.clusters.patches;
    pcl::saveMapFile(place, map);
  });
  write(options.normals,
        [&](const std::string& place) { saveNormals(place, extraction.mesh, labels); });
  write(options.picture,
        [&](const std::string& place) { savePicture(place, extraction.mesh, labels); });
  write(options.labels, [&](const std::string& place) {
    saveLabels(place, std::move(file), extraction.input_labels);
  });
  tool.stopIfInterrupted();
  outputs.commit();
}

void
summarize(Tool& tool, const PlaneOptions& options, const Extraction& extraction)
{
  tellPlanes(tool,
             extraction.clusters.patches,
             extraction.input_labels,
             extraction.finite_points);
  tool.tellSeconds();
  tool.details()["input"] = options.input;
  tool.details()["output"] = options.output;
  for (const std::string& path :
       {options.output, options.labels, options.normals, options.picture})
    if (!path.empty())
      tool.tell("file", path);
}

void
collectWarnings(Tool& tool, const HypothesisMesh& mesh)
{
  for (const std::string& remark : mesh.vertices.remarks)
    tool.warn(remark);
  for (const std::string& remark :
       lengthRemarks(mesh.vertices.points(), mesh.spacing, tool.scale()))
    tool.warn(remark);
}

void
run(Tool& tool, const PlaneOptions& options)
{
  checkPlaces(tool, options);
  std::optional<DisplayConnection> display;
  if (!options.picture.empty())
    display.emplace();
  StepTimer timer(tool.report());
  pcl::PointCloudFile file = loadScaledCloud(options.input, tool.scale());
  pcl::TriangleMesh triangles;
  const std::string ending = endingOf(options.input);
  if (!options.voxel_size && (ending == ".ply" || ending == ".obj"))
    triangles = pcl::loadTriangleMesh(options.input);
  timer.finish("read");
  tool.stopIfInterrupted();

  const Extraction extraction =
      triangles.triangles.empty()
          ? extractFromCloud(tool, options, timer, file)
          : extractFromMesh(tool, options, timer, file, std::move(triangles));
  collectWarnings(tool, extraction.mesh);
  requirePlanes(tool, options.input, extraction);
  writeOutputs(tool, options, extraction, std::move(file));
  timer.finish("write");
  summarize(tool, options, extraction);
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
