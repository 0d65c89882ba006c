#include "length_check.h"
#include "output_target.h"
#include "reading_options.h"
#include "setter_option.h"
#include "stage_reports.h"
#include "tool.h"

#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/mesh_file.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/process_memory.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/pipeline/cloud_meshing.h>
#include <pcl/pipeline/observation_files.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <utility>

namespace {

using namespace pcl::acmap;

struct Options {
  std::string input;
  std::string output;
  pcl::CloudMeshing meshing;
};

void
addOptions(Tool& tool, Options& options)
{
  CLI::App& app = tool.options();
  app.add_option(
         "input",
         options.input,
         "Point cloud (.pcd, .ply, .obj, .xyz, .txt, .csv, .pts, .ptx, .las, .e57)")
      ->type_name("IN")
      ->required();
  app.add_option("output", options.output, "Triangle mesh to write: .ply or .vtk")
      ->type_name("OUT")
      ->required();
  tool.addLengthOrAuto(
      "--consolidate",
      [&](double voxel_size) {
        options.meshing.consolidation.setVoxelSize(voxel_size);
        options.meshing.consolidates = true;
      },
      "First replace the points of each voxel by one on their plane; "
      "the voxel's edge in "
      "metres, or automatic from noise and spacing. For noisy clouds. "
      "Automatic: the steps of a depth camera's view are taken out in "
      "its picture instead");
  tool.addSensor(options.meshing.sensor);
  using Triangulation = pcl::DeWallParameters;
  addSetter(app,
            "--max-edge",
            options.meshing.triangulation,
            &Triangulation::setMaximumEdgeLength,
            &Triangulation::getMaximumEdgeLength,
            "No edge is longer, in metres [default: automatic, from the spacing "
            "around each point; 2.5 voxels of a consolidated cloud]",
            "M")
      ->default_str("");
  addSetterChoice(
      app,
      "--rule",
      options.meshing.triangulation,
      &Triangulation::setAcceptanceRule,
      &Triangulation::getAcceptanceRule,
      {{"guarded", pcl::DeWallRule::Guarded},
       {"dense", pcl::DeWallRule::Dense},
       {"strict", pcl::DeWallRule::Strict},
       {"paper", pcl::DeWallRule::Guarded}},
      "guarded: no point inside the smallest sphere through a triangle; dense: no such "
      "test, covers noisy surfaces better; strict: the paper's algorithm as printed, "
      "without our guard, for comparison: edges may have more than two triangles; "
      "paper: the former name of guarded");
  addSwitch(app,
            "--wall-depth",
            options.meshing.triangulation,
            &Triangulation::setComputeWallDepth,
            true,
            "Write with each triangle the depth of the dividing wall that made it "
            "(.ply only)");
  addSwitch(
      app,
      "--outward",
      options.meshing.triangulation,
      &Triangulation::setOutward,
      true,
      "An object that was seen from all sides: its surface faces outward, whatever "
      "sensor the cloud has");
  tool.addThreads();
  addReading(app, tool.reader());
}

void
checkPlaces(const Tool& tool, const Options& options)
{
  requireWritable(options.output, {".ply", ".vtk"}, {options.input});
  tool.requireReportWritable({options.input, options.output});
  if (options.meshing.triangulation.getComputeWallDepth() &&
      endingOf(options.output) != ".ply")
    throw UsageError("--wall-depth needs an output that ends in .ply");
}

/** \brief Large arrays are in files beside the output if they might not fit into the
 * memory. */
std::unique_ptr<pcl::ScratchMemory>
scratchFor(const Options& options)
{
  // A point has at least 12 bytes in a file, and its mesh takes up to 180.
  constexpr std::size_t bytes_a_byte = 16;
  std::error_code unknown_size;
  const auto bytes = std::filesystem::file_size(options.input, unknown_size);
  if (unknown_size || bytes <= availableMemory() / bytes_a_byte)
    return nullptr;
  const auto folder = std::filesystem::path(options.output).parent_path();
  // what is visited again should still be there: arrays are visited in no order
  const std::size_t of_process =
      memoryLimit() > 0 ? memoryLimit() : availableMemory() / 2;
  return std::make_unique<pcl::ScratchMemory>(
      folder.empty() ? "." : folder.string(), residentScratch(), of_process);
}

void
summarize(const Options& options, const pcl::DeWallReport& report, StageLog& log)
{
  log.details["input"] = options.input;
  log.details["output"] = options.output;
  log.details["report"] = jsonOf(report);
  log.tell("points", std::to_string(report.points));
  log.tell(
      "used",
      std::to_string(report.used_points) + " (" +
          percent(report.used_points,
                  report.points - report.invalid_points - report.duplicate_points) +
          " of the finite, different ones)");
  if (report.sides == pcl::DeWallSides::Undetermined)
    log.tell(
        "sides",
        "undetermined: no sensor is stated, and the points do not prove one at the "
        "origin; --outward is for objects seen from all sides");
  if (report.sides == pcl::DeWallSides::Outward &&
      !options.meshing.triangulation.getOutward())
    log.tell("sides", "outward: no sensor is known, and the surface is closed");
  log.tell("triangles", std::to_string(report.triangles));
  log.tell("components", std::to_string(report.components));
  if (options.meshing.triangulation.getAcceptanceRule() == pcl::DeWallRule::Strict)
    log.tell("crowded",
             percent(report.crowded_edges, report.edges) +
                 " of the edges have more than two triangles");
  log.tell("boundary", percent(report.boundary_edges, report.edges) + " of the edges");
  log.tellSeconds();
  log.tell("file", options.output);
}

/** Tells what the noise was, and what tells the sides of the surfaces. */
void
tellCloud(const pcl::PointCloudFile& file, const pcl::MeshedCloud& made, StageLog& log)
{
  if (made.consolidation) {
    log.warn(made.consolidation->remarks);
    tellConsolidation(*made.consolidation, log);
  }
  if (made.refinement) {
    tellDepthNoise(made.refinement->noise, log);
    tellRefinement(*made.refinement, log);
  }
  if (made.shows_steps)
    log.warn("the depth is quantised, and the mesh shows its steps: --consolidate "
             "takes them out");
  log.warn(file.remarks);
  log.warn(made.triangulation.remarks);
  tellColumns(file.columns, log);
  if (!made.names_views && made.sensor.outcome != pcl::SensorOutcome::Stated)
    log.tell("sensor", describe(made.sensor));
  if (made.tells_sides && made.up.outcome != pcl::UpOutcome::Stated)
    log.tell("up", describe(made.up));
}

pcl::MeshedCloud
meshOf(const Options& options,
       pcl::CloudRows rows,
       const pcl::PointCloudFile& file,
       const RunControls& controls,
       StageLog& log)
{
  pcl::CloudMeshing meshing = options.meshing;
  meshing.threads = controls.threads;
  meshing.progress = controls.progress;
  meshing.cost = pcl::memoryCheck();
  const double voxel_size = meshing.consolidation.getVoxelSize();
  if (meshing.consolidates)
    meshing.viewpoints = viewpointsOfFile(
        file, options.input, controls.reader.getScale(), log.report.remarks);
  if (voxel_size > 0)
    requireFineLength("--consolidate", voxel_size, requirePoints(rows), log);
  try {
    return pcl::meshCloud(std::move(rows), file, meshing);
  }
  catch (const pcl::UnorganizedPointCloudException&) {
    throw UsageError(needs_picture);
  }
}

void
meshFile(const Options& options, const RunControls& controls, StageLog& log)
{
  StepTimer timer(log.report);
  const std::unique_ptr<pcl::ScratchMemory> scratch = scratchFor(options);
  const Progress progress(controls.progress);
  progress.tell(0, "reading");
  pcl::PointCloudFile file;
  pcl::CloudRows rows = controls.reader.readRows(options.input, file);
  timer.finish("read");
  stopIfInterrupted();
  const pcl::MeshedCloud made = meshOf(options, std::move(rows), file, controls, log);
  auto& seconds = log.report.seconds;
  seconds.back().second += made.steps.seconds.front().second; // what it is
  seconds.insert(
      seconds.end(), made.steps.seconds.begin() + 1, made.steps.seconds.end());
  tellCloud(file, made, log);
  if (scratch && scratch->getRefused() > 0)
    log.warn(options.output + ": the disk is full, " +
             gigabytes(scratch->getRefused()) + " of arrays stayed in memory");
  if (made.mesh.triangles.empty())
    log.failWithNothing(options.input + ": no triangle is possible");

  stopIfInterrupted();
  StepTimer writing(log.report);
  pcl::saveTriangleMesh(options.output, made.vertices, made.mesh);
  writing.finish("write");
  summarize(options, made.triangulation, log);
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool("pcl_dewall_surface",
            "Makes an open, manifold triangle mesh of a point cloud.");
  Options options;
  addOptions(tool, options);
  tool.setHelp({{{"pcl_dewall_surface cloud.pcd mesh.ply",
                  "A mesh of a cloud, with edges as long as its spacing allows."},
                 {"pcl_dewall_surface cloud.pcd mesh.ply --max-edge 0.1",
                  "The same with edges of at most 10 cm."}},
                {}});
  return tool.run(argc, argv, [&] {
    checkPlaces(tool, options);
    meshFile(options, tool.controls(), tool.log());
  });
}
