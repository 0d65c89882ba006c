#include "cloud_labels.h"
#include "length_check.h"
#include "memory.h"
#include "output_target.h"
#include "reading_options.h"
#include "setter_option.h"
#include "stage_reports.h"
#include "tool.h"

#include <pcl/core/cloud_assessment.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/part_of_progress.h>
#include <pcl/core/impl/up_direction.h>
#include <pcl/core/mesh_file.h>
#include <pcl/core/noise_scale.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/filters/depth_refinement.h>
#include <pcl/filters/voxel_consolidation.h>
#include <pcl/pipeline/picture.h>
#include <pcl/surface/dewall_triangulation.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <optional>

namespace {

using namespace pcl::acmap;

/** Fraction of the progress where the mesh begins. */
constexpr double meshing = 0.4;

struct Options {
  std::string input;
  std::string output;
  bool consolidates = false;
  pcl::VoxelConsolidation<pcl::PCLPointCloud2> consolidation;
  pcl::DepthSensor sensor = pcl::DepthSensor::Automatic;
  pcl::DeWallTriangulation<pcl::PCLPointCloud2> dewall;
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
        options.consolidation.setVoxelSize(voxel_size);
        options.consolidates = true;
      },
      "First replace the points of each voxel by one on their plane; "
      "the voxel's edge in "
      "metres, or automatic from noise and spacing. For noisy clouds. "
      "Automatic: the steps of a depth camera's view are taken out in "
      "its picture instead");
  tool.addSensor(options.sensor);
  using Triangulation = pcl::DeWallParameters;
  addSetter(app,
            "--max-edge",
            options.dewall,
            &Triangulation::setMaximumEdgeLength,
            &Triangulation::getMaximumEdgeLength,
            "No edge is longer, in metres [default: automatic, from the spacing "
            "around each point; 2.5 voxels of a consolidated cloud]",
            "M")
      ->default_str("");
  addSetterChoice(
      app,
      "--rule",
      options.dewall,
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
            options.dewall,
            &Triangulation::setComputeWallDepth,
            true,
            "Write with each triangle the depth of the dividing wall that made it "
            "(.ply only)");
  addSwitch(
      app,
      "--outward",
      options.dewall,
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
  if (options.dewall.getComputeWallDepth() && endingOf(options.output) != ".ply")
    throw UsageError("--wall-depth needs an output that ends in .ply");
}

/** \brief The cloud of the input, later its consolidation. */
struct Input {
  pcl::PointCloudFile file; ///< without the data of its cloud
  pcl::CloudRows rows;
  /** Up direction, if free space has to tell the sides of the surfaces. */
  std::optional<Eigen::Vector3d> up;

  pcl::SensorEvidence sensor; ///< of a cloud without views
  pcl::UpEvidence evidence;   ///< of a cloud without a sensor

  /** Finds out what the sides of the surfaces depend on. */
  void
  assess(unsigned threads)
  {
    sensor = sensorEvidence(rows, file);
    if (const auto stated = statedUp(std::nullopt, file))
      evidence = *stated;
    else if (!sensor.isKnown()) {
      const pcl::NoiseScale scale = measureNoiseScale(points(), {}, threads);
      evidence =
          findUp(points(), scale.spacing, scale.sigma, file.usual_up, threads, sensor);
    }
    findSides(true);
  }

  bool
  namesViews() const
  {
    return findField(rows.layout(), "view", pcl::PCLPointField::INT32);
  }

  /** \param[in] sensors_fit can the surface have been seen from the sensor? */
  void
  findSides(bool sensors_fit)
  {
    up = upWithoutSensors(rows, evidence, sensor.isKnown(), sensors_fit);
  }

  pcl::acmap::PointView
  points() const
  {
    return requirePoints(rows);
  }
};

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

pcl::DeWallReport
triangulate(pcl::DeWallTriangulation<pcl::PCLPointCloud2>& dewall,
            const Input& input,
            const RunControls& controls,
            pcl::TriangleMesh& mesh)
{
  requireMemory(
      estimateDeWallMemory(input.rows.size(), true, dewall.getAcceptanceRule()),
      "triangulating this cloud");
  dewall.setInputCloud(input.rows);
  if (input.sensor.outcome == pcl::SensorOutcome::Stated)
    dewall.setSensorOrigin(input.file.sensor_origin);
  if (input.up)
    dewall.setUpDirection(*input.up);
  dewall.setNumberOfThreads(controls.threads);
  dewall.setProgressCallback(partOf(controls.progress, meshing, 1));
  dewall.reconstruct(mesh);
  return dewall.getReport();
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
  if (report.sides == pcl::DeWallSides::Outward && !options.dewall.getOutward())
    log.tell("sides", "outward: no sensor is known, and the surface is closed");
  log.tell("triangles", std::to_string(report.triangles));
  log.tell("components", std::to_string(report.components));
  if (options.dewall.getAcceptanceRule() == pcl::DeWallRule::Strict)
    log.tell("crowded",
             percent(report.crowded_edges, report.edges) +
                 " of the edges have more than two triangles");
  log.tell("boundary", percent(report.boundary_edges, report.edges) + " of the edges");
  log.tellSeconds();
  log.tell("file", options.output);
}

/** Replaces the cloud by its consolidation.
 * \return the edge length of a voxel, metres */
double
consolidate(const Options& options,
            Input& input,
            const RunControls& controls,
            StageLog& log)
{
  pcl::VoxelConsolidation<pcl::PCLPointCloud2> consolidation = options.consolidation;
  consolidation.setViewpoints(
      viewpointsOfFile(input.file, options.input, controls.reader.getScale(), log));
  if (input.sensor.isKnown())
    consolidation.setSensorOrigin(input.file.sensor_origin);
  if (const double voxel_size = consolidation.getVoxelSize(); voxel_size > 0)
    requireFineLength("--consolidate", voxel_size, input.points(), log);
  consolidation.setNumberOfThreads(controls.threads);
  consolidation.setProgressCallback(partOf(controls.progress, 0.1, meshing));
  consolidation.setInputCloud(input.rows);
  consolidation.filter(input.rows);
  const pcl::ConsolidationReport& report = consolidation.getReport();
  input.findSides(report.sensors_fit);
  log.warn(report.remarks);
  tellConsolidation(report, log);
  return report.voxel_size;
}

/** Removes the quantisation steps of the cloud, which becomes organized. */
void
refine(const Picture& picture, Input& input, const RunControls& controls, StageLog& log)
{
  auto cloud = std::make_shared<pcl::PCLPointCloud2>(input.rows.copy());
  if (picture.order)
    *cloud = picture.order->arrange(*cloud);
  pcl::DepthRefinement<pcl::PCLPointCloud2> refinement;
  refinement.setNumberOfThreads(controls.threads);
  refinement.setProgressCallback(partOf(controls.progress, 0.1, meshing));
  refinement.setInputCloud(cloud);
  const auto refined = std::make_shared<pcl::PCLPointCloud2>();
  refinement.filter(*refined);
  input.rows = refined;
  tellDepthNoise(refinement.getReport().noise, log);
  tellRefinement(refinement.getReport(), log);
}

/** The picture in which a cloud is refined; nothing if it is processed in space. */
std::optional<Picture>
pictureOfFile(const Options& options, const Input& input)
{
  const bool is_automatic = options.consolidation.getVoxelSize() == 0;
  try {
    return is_automatic
               ? pictureOf(input.points(), input.rows.layout().width, options.sensor)
               : std::nullopt;
  }
  catch (const pcl::UnorganizedPointCloudException&) {
    throw UsageError(needs_picture);
  }
}

void
meshCloud(const Options& options, const RunControls& controls, StageLog& log)
{
  StepTimer timer(log.report);
  const std::unique_ptr<pcl::ScratchMemory> scratch = scratchFor(options);
  const Progress progress(controls.progress);
  progress.tell(0, "reading");
  Input input;
  input.rows = controls.reader.readRows(options.input, input.file);
  input.assess(controls.threads);
  timer.finish("read");
  stopIfInterrupted();

  pcl::DeWallTriangulation<pcl::PCLPointCloud2> dewall = options.dewall;
  const std::optional<Picture> picture = pictureOfFile(options, input);
  if (picture && options.consolidates) {
    refine(*picture, input, controls, log);
    timer.finish("refine");
  }
  else if (options.consolidates) {
    const double voxel_size = consolidate(options, input, controls, log);
    timer.finish("consolidate");
    if (dewall.getMaximumEdgeLength() == 0)
      dewall.setMaximumEdgeLength(pcl::mesh_edge_in_voxels * voxel_size);
  }
  else if (picture && measureDepthStep(input.points()) > 0)
    log.warn("the depth is quantised, and the mesh shows its steps: --consolidate "
             "takes them out");
  pcl::TriangleMesh mesh;
  const pcl::DeWallReport report = triangulate(dewall, input, controls, mesh);
  timer.finish("triangulate");
  log.warn(input.file.remarks);
  log.warn(report.remarks);
  tellColumns(input.file.columns, log);
  if (!input.namesViews() && input.sensor.outcome != pcl::SensorOutcome::Stated)
    log.tell("sensor", describe(input.sensor));
  if (input.up && input.evidence.outcome != pcl::UpOutcome::Stated)
    log.tell("up", describe(input.evidence));
  if (scratch && scratch->getRefused() > 0)
    log.warn(options.output + ": the disk is full, " +
             gigabytes(scratch->getRefused()) + " of arrays stayed in memory");
  if (mesh.triangles.empty())
    log.failWithNothing(options.input + ": no triangle is possible");

  stopIfInterrupted();
  pcl::saveTriangleMesh(options.output, input.rows, mesh);
  timer.finish("write");
  summarize(options, report, log);
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
    meshCloud(options, tool.controls(), tool.log());
  });
}
