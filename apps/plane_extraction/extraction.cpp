#include "extraction.h"

#include "cloud_sensors.h"
#include "length_check.h"
#include "plane_reports.h"

#include <pcl/core/cloud_fields.h>
#include <pcl/core/noise_scale.h>
#include <pcl/segmentation/depth_plane_kernel.h>

namespace pcl::acmap {

namespace {

PlaneClusteringSettings
settingsOf(const PlaneOptions& options)
{
  PlaneClusteringSettings settings;
  settings.noise_driven = !options.paper;
  if (!options.paper)
    settings.plane_distance = options.tolerance.value_or(0);
  settings.least_area = options.least_area.value_or(settings.least_area);
  settings.regular = options.regular;
  return settings;
}

/** Votes and clusters; a source is used where the paper's thresholds are not.
 * \param[in] sensors of the vertices, unknown where the faces know better */
Extraction
extractFrom(Tool& tool,
            const PlaneOptions& options,
            StepTimer& timer,
            HypothesisMesh mesh,
            const SensorView& sensors,
            const PlaneSource& source)
{
  Extraction result;
  result.mesh = std::move(mesh);
  voteOnMesh(tool, result.mesh, sensors);
  timer.finish("votes");
  result.clusters = findPlanes(tool, result.mesh, source, settingsOf(options));
  timer.finish("planes");
  return result;
}

/** A mesh of a cloud, and what its vertices stand for. */
struct CloudMesh {
  HypothesisMesh mesh;
  SensorView sensors;                  ///< of the points
  SensorView vertex_sensors;           ///< unknown where the faces know better
  std::vector<std::int32_t> vertex_of; ///< a point; empty where points are vertices
};

CloudMesh
consolidateAndMesh(Tool& tool,
                   const PlaneOptions& options,
                   double voxel_size,
                   StepTimer& timer,
                   const PointCloudFile& file,
                   const SensorView& sensors)
{
  ConsolidationSettings settings;
  settings.voxel_size = voxel_size;
  settings.keep_sources = options.paper;
  ConsolidationReport report;
  ConsolidatedCloud cloud = consolidateInput(tool, file, sensors, settings, report);
  timer.finish("consolidate");
  CloudMesh result;
  result.sensors = report.sensors_fit ? sensors : SensorView();
  result.vertex_of = std::move(cloud.consolidation.representative_of);
  result.mesh = meshConsolidated(tool, std::move(cloud), report.voxel_size);
  return result;
}

/** As it is, where its noise is small beside its spacing. */
CloudMesh
meshCloud(Tool& tool,
          const PlaneOptions& options,
          StepTimer& timer,
          const PointCloudFile& file,
          const SensorView& sensors)
{
  if (options.voxel_size)
    return consolidateAndMesh(tool, options, *options.voxel_size, timer, file, sensors);
  const NoiseScale scale = measureNoiseScale(file.points(), sensors, tool.threads());
  if (scale.inverse_depth)
    tool.warn(scale.remarks.front());
  timer.finish("noise scale");
  if (needsConsolidation(scale))
    return consolidateAndMesh(
        tool, options, automaticVoxel(scale), timer, file, sensors);
  tool.tell("consolidated", "no, the points lie close enough to their surface");
  // its faces look to the file's sensor; the points' own ones know better
  const bool names_views = findField(file.cloud, "view", PCLPointField::INT32);
  return {meshAsItIs(tool, file), sensors, names_views ? sensors : SensorView(), {}};
}

/** Planes in the picture of one view; the mesh only where it is asked for. */
Extraction
extractFromView(Tool& tool,
                const PlaneOptions& options,
                StepTimer& timer,
                const PointCloudFile& file,
                const MeasuredView& measured)
{
  tellDepthNoise(tool, measured);
  timer.finish("noise scale");
  DepthSegmentationSettings settings;
  settings.least_area = options.least_area.value_or(settings.least_area);
  settings.regular = options.regular;
  DepthPlaneReport report;
  Extraction result;
  tool.withProgress([&](const ProgressCallback& progress) {
    result.clusters = segmentDepthPlanes(
        measured.view, measured.noise, settings, Progress(progress), report);
  });
  for (const std::string& remark : report.remarks)
    tool.warn(remark);
  if (result.clusters.patches.empty() && options.sensor == DepthSensor::Stereo)
    tool.warn("--sensor stereo expects noise that is even in inverse depth; where the "
              "cloud's is not, leave --sensor out");
  tool.details()["report"] = jsonOf(report);
  result.input_labels = measured.order
                            ? measured.order->labelsOfPoints(result.clusters.labels)
                            : result.clusters.labels;
  result.finite_points = measured.view.measured();
  timer.finish("planes");
  result.mesh.vertices.remarks = file.remarks;
  if (!options.wantsMesh() || result.clusters.patches.empty())
    return result;
  PointCloudFile refined = file;
  const DepthPlanes known =
      depthPlanesOf(result.clusters.patches, result.clusters.labels);
  refineInput(tool, measured, &known, refined);
  timer.finish("refine");
  result.mesh = meshAsItIs(tool, refined);
  timer.finish("triangulate");
  voteOnMesh(tool, result.mesh, SensorView(file.sensor_origin));
  timer.finish("votes");
  return result;
}

std::vector<std::int32_t>
labelsOfPoints(const std::vector<std::int32_t>& of_vertices,
               const std::vector<std::int32_t>& vertex_of)
{
  if (vertex_of.empty())
    return of_vertices;
  std::vector<std::int32_t> labels;
  for (const std::int32_t vertex : vertex_of)
    labels.push_back(vertex < 0 ? -1 : of_vertices[static_cast<std::size_t>(vertex)]);
  return labels;
}

} // namespace

void
requirePlanes(const Tool& tool, const std::string& input, const Extraction& extraction)
{
  if (extraction.clusters.patches.empty())
    tool.failWithNothing(input + ": no plane was found");
}

Extraction
extractFromMesh(Tool& tool,
                const PlaneOptions& options,
                StepTimer& timer,
                const PointCloudFile& file,
                TriangleMesh triangles)
{
  HypothesisMesh mesh;
  mesh.vertices = file;
  mesh.mesh = std::move(triangles);
  Extraction result = extractFrom(tool, options, timer, std::move(mesh), {}, {});
  result.input_labels = result.clusters.labels;
  result.finite_points = cloudExtent(file.points()).finite_points;
  return result;
}

Extraction
extractFromCloud(Tool& tool,
                 const PlaneOptions& options,
                 StepTimer& timer,
                 const PointCloudFile& file)
{
  std::vector<std::string> remarks;
  const SensorView sensors = sensorsOfFile(file, options.input, tool.scale(), remarks);
  for (const std::string& remark : remarks)
    tool.warn(remark);
  return extractFromCloud(tool, options, timer, file, sensors);
}

Extraction
extractFromCloud(Tool& tool,
                 const PlaneOptions& options,
                 StepTimer& timer,
                 const PointCloudFile& file,
                 const SensorView& sensors)
{
  if (!options.isInSpace())
    if (const std::optional<MeasuredView> measured = viewOfFile(file, options.sensor))
      return extractFromView(tool, options, timer, file, *measured);
  CloudMesh cloud = meshCloud(tool, options, timer, file, sensors);
  timer.finish("triangulate");
  PlaneSource source;
  if (!options.paper)
    source = {file.points(), cloud.sensors};
  Extraction result = extractFrom(
      tool, options, timer, std::move(cloud.mesh), cloud.vertex_sensors, source);
  result.finite_points = cloudExtent(file.points()).finite_points;
  result.input_labels = options.paper
                            ? labelsOfPoints(result.clusters.labels, cloud.vertex_of)
                            : result.clusters.source_labels;
  return result;
}

} // namespace pcl::acmap
