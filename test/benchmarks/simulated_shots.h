#pragma once

#include "stereo_input.h"

#include <pcl/simulation/simulated_scene.h>
#include <pcl/simulation/simulated_truth.h>

#include <cstddef>

namespace pcl::acmap::bench {

/** \brief An observation of a simulated scene: ten shots with a pattern, the one without,
 * and all of the truth. */
struct SimulatedShots {
  StereoShots shots; ///< with a pattern; the truth into the horizontal neighbour
  TrinocularFrame::ConstPtr off;
  SimulatedTruth truth;
};

/** \brief The standard rig before a blank wall at 3 m, with a box at 1.5 m that hides some
 * of it; two views from askew, so that the wall has many disparities. */
SimulatedScene
wallWithBox();

/** \brief The wall alone, from further askew. */
SimulatedScene
slantedWall();

/** \brief Takes the shots of a view, under ten patterns of random lines. */
SimulatedShots
takeShots(const SimulatedScene& scene, std::size_t view);

/** \brief The same without the vertical neighbour. */
StereoShots
withoutVertical(const StereoShots& shots);

} // namespace pcl::acmap::bench
