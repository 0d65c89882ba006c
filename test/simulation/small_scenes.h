#pragma once

#include <pcl/simulation/simulated_scene.h>

#include <string>

namespace pcl::acmap::test {

/** \brief A rig with fewer pixels and the field of view of the standard one. */
TrinocularRig
smallRig(int width = 80);

/** \brief A standard scene seen by a small rig, with a proportional number of
 * points. */
SimulatedScene
smallScene(const std::string& name, int width = 80);

/** \brief A frontal wall at a depth, seen from the origin. */
SimulatedScene
wallAt(double depth);

/** \brief Random rectangles, boxes and cylinders with caps in all directions. */
SceneGeometry
clutter(std::uint64_t seed);

} // namespace pcl::acmap::test
