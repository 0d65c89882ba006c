#include "extraction.h"

#include "cloud_sensors.h"
#include "length_check.h"

namespace pcl::acmap {

namespace {

PlaneClusteringSettings
settingsOf(const PlaneOptions& options)
{
  PlaneClusteringSettings settings;
  settings.noise_driven = !options.paper;
  if (!options.paper)
    settings.plane_distance = 0;
  settings.least_area = options.least_area.value_or(settings.least_area);
  settings.regular = options.regular;
  return settings;
}

/** Votes and clusters; a source is used where the paper's thresholds are not. */
Extraction
extractFrom(Tool& tool,
            const PlaneOptions& options,
            StepTimer& timer,
            HypothesisMesh mesh,
            const PlaneSource& source)
{
  Extraction result;
  result.mesh = std::move(mesh);
  voteOnMesh(tool, result.mesh);
  timer.finish("votes");
  result.clusters = findPlanes(tool, result.mesh, source, settingsOf(options));
  timer.finish("planes");
  return result;
}

} // namespace

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
  Extraction result = extractFrom(tool, options, timer, std::move(mesh), {});
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
  ConsolidationSettings settings;
  settings.voxel_size = options.voxel_size.value_or(0);
  settings.keep_sources = options.paper;
  ConsolidationReport report;
  ConsolidatedCloud cloud = consolidateInput(tool, file, sensors, settings, report);
  timer.finish("consolidate");
  const std::vector<std::int32_t> representative_of =
      std::move(cloud.consolidation.representative_of);
  HypothesisMesh mesh = meshConsolidated(tool, std::move(cloud), report.voxel_size);
  timer.finish("triangulate");

  PlaneSource source;
  if (!options.paper)
    source = {file.points(), report.sensors_fit ? sensors : SensorView()};
  Extraction result = extractFrom(tool, options, timer, std::move(mesh), source);
  result.finite_points = report.points - report.invalid_points;
  result.input_labels = result.clusters.source_labels;
  if (options.paper)
    for (const std::int32_t representative : representative_of)
      result.input_labels.push_back(
          representative < 0
              ? -1
              : result.clusters.labels[static_cast<std::size_t>(representative)]);
  return result;
}

} // namespace pcl::acmap
