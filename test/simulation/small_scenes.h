#pragma once

#include <pcl/simulation/simulated_scene.h>

#include <string>

namespace pcl::acmap::test {

/** \brief A rig with fewer pixels that sees as much as the standard one. */
TrinocularRig
smallRig(int width = 80);

/** \brief A standard scene seen by a small rig, with points in proportion. */
SimulatedScene
smallScene(const std::string& name, int width = 80);

/** \brief One wall across the view at a depth, seen from the origin. */
SimulatedScene
wallAt(double depth);

/** \brief Rectangles, boxes and cylinders with caps, in all directions, from a seed. */
SceneGeometry
clutter(std::uint64_t seed);

} // namespace pcl::acmap::test
