#include "extraction.h"

#include "length_check.h"
#include "memory.h"
#include "plane_reports.h"
#include "sensor_option.h"

#include <cmath>

namespace pcl::acmap {

namespace {

PlaneMapping
mappingOf(const Tool& tool, const PlaneOptions& options)
{
  PlaneMapping mapping;
  PlaneMapping::Clustering clustering = mapping.getClustering();
  PlaneMapping::DepthSegmentation segmentation;
  clustering.setNoiseDriven(!options.paper);
  if (!options.paper && options.tolerance)
    clustering.setDistanceThreshold(*options.tolerance);
  clustering.setMinArea(options.min_area.value_or(0));
  segmentation.setMinArea(options.min_area.value_or(0));
  clustering.setRegularize(options.regular);
  segmentation.setRegularize(options.regular);
  mapping.setClustering(clustering);
  mapping.setDepthSegmentation(segmentation);
  mapping.setDepthSensor(options.isInSpace() ? DepthSensor::Laser : options.sensor);
  if (options.voxel_size) {
    PlaneMapping::Consolidation consolidation;
    consolidation.setVoxelSize(*options.voxel_size);
    mapping.setConsolidation(consolidation);
    mapping.setConsolidationPolicy(ConsolidationPolicy::Always);
  }
  mapping.setComputeMesh(options.wantsMesh());
  mapping.setNumberOfThreads(tool.threads());
  return mapping;
}

/** Callback that refuses work for which there is not enough memory, and warns of work
 * that takes long. */
CostCallback
costCheck(const Tool& tool)
{
  return [&tool](const std::string& work, std::size_t bytes, double seconds) {
    constexpr double long_time = 60;
    if (bytes > 0)
      requireMemory(bytes, work);
    if (seconds > long_time)
      tool.warnAtOnce(
          "the paper's clustering looks at all pairs of points within 0.8 m: that may "
          "take about " +
          std::to_string(std::lround(seconds / 60)) +
          " min; a larger voxel (--consolidate M) shortens it, and without --paper it "
          "takes seconds");
  };
}

} // namespace

MappedPlanes
extractPlanes(Tool& tool,
              const PlaneOptions& options,
              const std::shared_ptr<const PointCloudFile>& cloud,
              std::vector<Eigen::Vector3f> viewpoints,
              TriangleMesh mesh)
{
  if (options.voxel_size.value_or(0) > 0)
    requireFineLength(tool, "--consolidate", *options.voxel_size, cloud->points());
  PlaneMapping mapping = mappingOf(tool, options);
  mapping.setInputCloud(cloud);
  mapping.setInputMesh(std::move(mesh));
  mapping.setViewpoints(std::move(viewpoints));
  mapping.setCostCallback(costCheck(tool));
  MappedPlanes found;
  try {
    tool.withProgress([&](const ProgressCallback& progress) {
      mapping.setProgressCallback(progress);
      mapping.compute(found);
    });
  }
  catch (const UnorganizedPointCloudException&) {
    throw UsageError(needs_picture);
  }
  tellMapping(tool, mapping.getReport());
  if (found.planes.empty() && options.sensor == DepthSensor::Stereo)
    tool.warn("--sensor stereo expects noise that is even in inverse depth; where the "
              "cloud's is not, leave --sensor out");
  return found;
}

void
requirePlanes(const Tool& tool, const std::string& input, const MappedPlanes& found)
{
  if (found.planes.empty())
    tool.failWithNothing(input + ": no plane was found");
}

} // namespace pcl::acmap
