#pragma once

#include <pcl/core/planar_pose.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/simulation/simulated_scene.h>

#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Observations whose true poses are known. */
struct RectificationMap {
  std::string name;
  std::vector<PointCloud<PointNormal>::Ptr> clouds; ///< metres, sensors' frames
  std::vector<std::vector<float>> weights;          ///< one a point
  std::vector<PlanarPose> truth;
  double bin_size = 0.1; ///< metres, as the tool has it for such observations
  double consolidation_seconds = 0; ///< CPU, of all observations
};

/** \brief The laser logs for which figures were set, about 200 scans of each; those that
 * are not there are left out, with a word on stderr. */
std::vector<RectificationMap>
makeLogMaps();

/** \brief A long corridor, of which no figure was known when the search was made. */
std::vector<RectificationMap>
makeLongLogMaps();

/** \brief All views of a scene, each consolidated for itself; poses in the scene's frame. */
RectificationMap
makeSceneMap(const SimulatedScene& scene);

/** \brief 40 views of a corridor that is the same everywhere and has no end: nothing tells
 * how far along it the camera is. */
SimulatedScene
bareCorridor();

} // namespace pcl::acmap::bench
