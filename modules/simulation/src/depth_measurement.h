#pragma once

#include <pcl/simulation/simulated_observation.h>

namespace pcl::acmap {

/** \brief Measures a view with the scene's depth camera.
 * \param[in] image of this view, already checked
 * \throws BadArgumentException when the depth camera is invalid */
SimulatedObservation
measureDepths(const SimulatedScene& scene,
              const SurfaceImage& image,
              std::size_t view,
              std::uint64_t seed);

} // namespace pcl::acmap
