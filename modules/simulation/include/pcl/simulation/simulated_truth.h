#pragma once

#include <pcl/core/disparity_image.h>
#include <pcl/core/export.h>
#include <pcl/simulation/simulated_light.h>
#include <pcl/simulation/simulated_scene.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {

/** \brief What stereo should find in one observation, for the rectified reference view;
 * images are of its size. \ingroup simulation */
struct SimulatedTruth {
  /** \brief Flags of a pixel in \ref visible. */
  static constexpr std::uint8_t in_horizontal = 1; ///< the horizontal neighbour sees it
  static constexpr std::uint8_t in_vertical = 2;   ///< the vertical neighbour sees it
  static constexpr std::uint8_t in_light = 4;      ///< the projector lights it

  /** \brief px into the horizontal neighbour, focal length * |baseline| / z, exact; NaN
   * where the reference sees nothing; empty when there is no such camera. */
  DisparityImage horizontal;
  DisparityImage vertical; ///< the same into the vertical neighbour

  std::vector<std::uint8_t> visible;  ///< flags, row by row
  std::vector<std::int32_t> surfaces; ///< index in the scene, -1 for nothing
};

/** \brief Casts the rectified reference view of an observation and asks of each place it
 * sees whether the neighbours and the projector see it too, exactly. Runs in all threads
 * of the caller's arena.
 * \param[in] scene what is seen
 * \param[in] view index of its pose in the scene
 * \param[in] projector on the rig
 * \throws BadArgumentException when the scene has no such view, or its rig cannot be
 * \ingroup simulation */
ACMAP_EXPORT SimulatedTruth
truthOf(const SimulatedScene& scene,
        std::size_t view,
        const SimulatedProjector& projector = {});

} // namespace pcl
