#include "drawn_apart.h"
#include "output_target.h"
#include "plane_extraction/extraction.h"
#include "reading_options.h"

#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/map_file.h>
#include <pcl/core/mesh_file.h>
#include <pcl/core/output_group.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/pipeline/cloud_labels.h>
#include <pcl/pipeline/mapped_planes.h>
#include <pcl/pipeline/observation_files.h>

#include <CLI/CLI.hpp>

namespace {

using namespace pcl::acmap;

/** Outputs without a name are not written. */
struct Options : PlaneOptions {
  std::string input;
  std::string output;
  std::string labels;
  std::string normals;
  std::string picture;
};

void
addOptions(Tool& tool, Options& options)
{
  CLI::App& app = tool.options();
  const auto add = [&app](const char* name,
                          std::string& path,
                          const char* type,
                          const char* purpose) {
    return app.add_option(name, path, purpose)->type_name(type);
  };
  add("input",
      options.input,
      "IN",
      "Point cloud (.pcd, .ply, .obj, .xyz, .txt, .csv, .pts, .ptx, .las, .e57), or "
      "mesh (.ply or .obj with "
      "faces)")
      ->required();
  add("output", options.output, "PLANES.json", "Planes to write, in metres: .json")
      ->required();
  add("--labels",
      options.labels,
      "OUT.pcd",
      "Write the input's points with a field label: plane id + 1, 0 for none; "
      "cylinders are numbered after the planes");
  add("--normals",
      options.normals,
      "OUT.ply",
      "Write the mesh with its voted normals, creases and labels");
  add("--picture",
      options.picture,
      "OUT.png",
      "Draw the mesh in colours by plane, if there is an X server, as xvfb-run gives");
  addPlaneChoices(tool, options);
  app.add_flag("--paper",
               options.paper,
               "The paper's way, with nothing added: raw points, its triangulation, "
               "votes and fixed thresholds (0.8 m, 22.5 degrees, 0.25 m, more than 50 "
               "points)");
  tool.addThreads();
  addReading(app, tool.reader());
}

/** Checks before the work that all outputs can be written, and that the options are
 * compatible. */
void
checkOptions(const Tool& tool, const Options& options)
{
  std::vector<std::string> others = {options.input};
  for (const auto& [path, ending] : {std::pair(options.output, ".json"),
                                     std::pair(options.labels, ".pcd"),
                                     std::pair(options.normals, ".ply"),
                                     std::pair(options.picture, ".png")}) {
    if (path.empty())
      continue;
    requireWritable(path, {ending}, others);
    others.push_back(path);
  }
  tool.requireReportWritable(others);
  checkChoices(options);
}

/** Writes a cloud as PCD with the plane of each point, see withLabels. */
void
saveLabels(const std::string& path,
           const pcl::PointCloudFile& file,
           const std::vector<std::int32_t>& planes)
{
  pcl::PCLPointCloud2 cloud = withLabels(file.cloud, planes);
  dropUnwritableFields(cloud);
  pcl::savePointCloud(path, cloud, file.sensor_origin, file.sensor_orientation);
}

void
writeOutputs(const Options& options,
             const pcl::MappedPlanes& found,
             const pcl::PointCloudFile& file)
{
  OutputGroup outputs;
  const auto write = [&](const std::string& path, const auto& save) {
    stopIfInterrupted();
    if (!path.empty())
      outputs.write(path, save);
  };
  write(options.output, [&](const std::string& place) {
    pcl::CompactMap map = mapOf(found);
    map.shift = file.shift;
    pcl::saveMapFile(place, map);
  });
  write(options.normals,
        [&](const std::string& place) { saveMappedMesh(place, found); });
  write(options.labels,
        [&](const std::string& place) { saveLabels(place, file, labelsOf(found)); });
  stopIfInterrupted();
  outputs.commit();
}

void
run(const Options& options, const RunControls& controls, StageLog& log)
{
  const PicturesApart pictures(!options.picture.empty(), log);
  StepTimer timer(log.report);
  const auto file =
      std::make_shared<pcl::PointCloudFile>(controls.reader.read(options.input));
  pcl::TriangleMesh triangles;
  const std::string ending = endingOf(options.input);
  if (!options.consolidates() && (ending == ".ply" || ending == ".obj"))
    triangles = pcl::loadTriangleMesh(options.input);
  std::vector<Eigen::Vector3f> viewpoints;
  if (triangles.triangles.empty())
    viewpoints = viewpointsOfFile(
        *file, options.input, controls.reader.getScale(), log.report.remarks);
  timer.finish("read");
  stopIfInterrupted();

  const pcl::MappedPlanes found = extractPlanes(options,
                                                sharedCloud(file),
                                                file,
                                                std::move(viewpoints),
                                                controls,
                                                log,
                                                std::move(triangles));
  log.warn(file->remarks);
  requirePlanes(options.input, found, log);
  StepTimer write_timer(log.report);
  writeOutputs(options, found, *file);
  const bool is_drawn =
      pictures.canBeDrawn() &&
      pictures.draw([&] { savePicture(options.picture, found); }, log);
  write_timer.finish("write");

  tellPlanes(found, log);
  log.tellSeconds();
  log.details["input"] = options.input;
  log.details["output"] = options.output;
  for (const std::string& path : {options.output,
                                  options.labels,
                                  options.normals,
                                  is_drawn ? options.picture : std::string()})
    if (!path.empty())
      log.tell("file", path);
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool("pcl_plane_extraction", "Finds the planes of a point cloud or a mesh.");
  Options options;
  addOptions(tool, options);
  tool.setHelp({{{"pcl_plane_extraction cloud.ply planes.json",
                  "The planes of a cloud, with outlines and covariances."},
                 {"pcl_plane_extraction view.pcd planes.json --labels labels.pcd "
                  "--picture planes.png",
                  "The plane of each point, too, and a picture."}},
                {}});
  return tool.run(argc, argv, [&] {
    checkOptions(tool, options);
    options.stage.setComputeMesh(!options.normals.empty() || !options.picture.empty());
    run(options, tool.controls(), tool.log());
  });
}
