#pragma once

#include "scene_truth.h"

#include <pcl/core/impl/point_view.h>
#include <pcl/core/impl/voxel_moments.h>
#include <pcl/core/point_types.h>
#include <pcl/core/sensor_view.h>
#include <pcl/filters/impl/consolidation_kernel.h>
#include <pcl/point_cloud.h>
#include <pcl/simulation/simulated_observation.h>

#include <memory>
#include <string>

namespace pcl::acmap::bench {

/** \brief A cloud of a simulated scene with its truth. */
struct SimulatedCloud {
  std::string name;
  MergedObservations merged; ///< points and planes in the frame of the cloud
  Eigen::Isometry3d T_scene_cloud = Eigen::Isometry3d::Identity();

  std::size_t
  size() const
  {
    return merged.points.size();
  }

  PointView
  points() const;

  std::vector<Eigen::Vector3f>
  sensorOrigins() const;

  SensorView
  sensors() const;

  ColorView
  colors() const;
};

/** \brief One view in its camera frame. */
SimulatedCloud
makeViewCloud(const SimulatedScene& scene, std::size_t view);

/** \brief All views of a scene in the frame of the first. */
SimulatedCloud
makeSceneCloud(const SimulatedScene& scene);

/** \brief A seeded random subset of a cloud, in the same order. */
SimulatedCloud
makeRandomPart(const SimulatedCloud& cloud, std::size_t size, std::uint64_t seed);

/** \brief The first \a size points along z of the scene, in the order of the cloud: a
 * crop with the density of the whole cloud.
 * \param[in] size at least 1 */
SimulatedCloud
makeCrop(const SimulatedCloud& cloud, std::size_t size);

/** \brief The kernel of VoxelConsolidation on one thread.
 * \param[in] voxel metres, 0 for automatic */
Consolidation
consolidate(const SimulatedCloud& cloud, double voxel, ConsolidationReport& report);

/** \brief Such as "5 cm", or "automatic" for 0. */
std::string
voxelName(double voxel);

/** \brief A scene with all its points and the truth of all its views, which are
 * computed when first requested and then cached. */
class SceneData {
public:
  explicit SceneData(const std::string& standard_scene);

  const SimulatedScene&
  scene() const
  {
    return scene_;
  }

  const SimulatedCloud&
  whole();

  const SceneTruth&
  wholeTruth();

  SceneTruth
  truthOfView(std::size_t view) const;

private:
  SimulatedScene scene_;
  std::unique_ptr<SimulatedCloud> whole_;
  std::unique_ptr<SceneTruth> truth_;
};

/** \brief The corridor of most benchmarks. */
SceneData&
corridor();

/** \brief Only the coordinates, as a PCL cloud. */
PointCloud<PointXYZ>::Ptr
plainPoints(const SimulatedCloud& cloud);

/** \brief Points with colour and view, as in a map. */
PointCloud<PointXYZRGBNormalView>::Ptr
mapPoints(const SimulatedCloud& cloud);

} // namespace pcl::acmap::bench
