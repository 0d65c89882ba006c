#pragma once

#include <pcl/core/planar_pose.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/simulation/simulated_scene.h>

#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Observations with known true poses. */
struct RectificationMap {
  std::string name;
  std::vector<PointCloud<PointNormal>::Ptr> clouds; ///< metres, sensor frames
  std::vector<std::vector<float>> weights;          ///< one per point
  std::vector<PlanarPose> truth;
  double bin_size = 0.1; ///< metres, the tool's default for such observations
  double consolidation_seconds = 0; ///< CPU time for all observations
};

/** \brief The laser logs for which there are targets, about 200 scans of each; missing
 * ones are reported on stderr and skipped. */
std::vector<RectificationMap>
makeLogMaps();

/** \brief A long corridor that was not used during the development of the search. */
std::vector<RectificationMap>
makeLongLogMaps();

/** \brief All views of a scene, consolidated one by one; poses in the scene frame. */
RectificationMap
makeSceneMap(const SimulatedScene& scene);

/** \brief 40 views of an endless uniform corridor: the position along it is not
 * observable. */
SimulatedScene
bareCorridor();

} // namespace pcl::acmap::bench
