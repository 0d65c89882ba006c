#pragma once

#include "stereo_input.h"

#include <pcl/simulation/simulated_scene.h>
#include <pcl/simulation/simulated_truth.h>

#include <cstddef>

namespace pcl::acmap::bench {

/** \brief An observation of a simulated scene: ten shots with patterns, one without,
 * and the complete truth. */
struct SimulatedShots {
  StereoShots shots; ///< with patterns; the truth for the horizontal neighbour
  TrinocularFrame::ConstPtr off;
  SimulatedTruth truth;
};

/** \brief The standard rig in front of a blank wall at 3 m, with a box at 1.5 m that
 * occludes a part of it; two oblique views, so that the wall has many disparities. */
SimulatedScene
wallWithBox();

/** \brief The wall alone, from more oblique views. */
SimulatedScene
slantedWall();

/** \brief Simulates the shots of a view, under ten patterns of random lines. */
SimulatedShots
takeShots(const SimulatedScene& scene, std::size_t view);

/** \brief The same shots without the vertical neighbour. */
StereoShots
withoutVertical(const StereoShots& shots);

} // namespace pcl::acmap::bench
