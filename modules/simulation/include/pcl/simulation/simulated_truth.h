#pragma once

#include <pcl/core/disparity_image.h>
#include <pcl/core/export.h>
#include <pcl/simulation/simulated_light.h>
#include <pcl/simulation/simulated_scene.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {

/** \brief Ground truth for the stereo matching of one observation, for the rectified
 * reference view; all images have its size. \ingroup simulation */
struct SimulatedTruth {
  /** \brief Flags of a pixel in \ref visible. */
  static constexpr std::uint8_t in_horizontal = 1; ///< seen by the horizontal neighbour
  static constexpr std::uint8_t in_vertical = 2;   ///< seen by the vertical neighbour
  static constexpr std::uint8_t in_light = 4;      ///< lit by the projector

  /** \brief Disparities to the horizontal neighbour in px, focal length * |baseline| /
   * z, exact; NaN where the reference sees nothing; empty if there is no such
   * camera. */
  DisparityImage horizontal;
  DisparityImage vertical; ///< the same for the vertical neighbour

  std::vector<std::uint8_t> visible;  ///< flags, row by row
  std::vector<std::int32_t> surfaces; ///< index in the scene, -1 for nothing
};

/** \brief Casts the rectified reference view of an observation and determines exactly
 * whether each visible point is also seen by the neighbours and lit by the projector.
 * Runs in all threads of the caller's arena.
 * \param[in] scene that is seen
 * \param[in] view index of its pose in the scene
 * \param[in] projector on the rig
 * \throws BadArgumentException when the scene has no such view, or its rig or the
 * projector is invalid
 * \ingroup simulation */
ACMAP_EXPORT SimulatedTruth
truthOf(const SimulatedScene& scene,
        std::size_t view,
        const SimulatedProjector& projector = {});

} // namespace pcl
