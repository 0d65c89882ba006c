#pragma once

#include <pcl/pipeline/plane_mapping_types.h>
#include <pcl/simulation/simulated_scene.h>

namespace pcl::acmap::bench {

/** \brief Is a place in the image of a view, and in reach? It may be occluded.
 * \param[in] place in the frame of the scene, metres */
bool
isInSight(const SimulatedScene& scene, const Eigen::Vector3d& place);

/** \brief The planes of all views of a scene, in the frame of the first one, by
 * PlaneMapping with the sensors of the points. */
MappedPlanes
mapScene(const SimulatedScene& scene, bool searches_cylinders);

} // namespace pcl::acmap::bench
