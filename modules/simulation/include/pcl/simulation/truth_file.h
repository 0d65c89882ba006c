#pragma once

#include <pcl/core/export.h>
#include <pcl/simulation/simulated_light.h>
#include <pcl/simulation/simulated_scene.h>
#include <pcl/simulation/simulated_truth.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

/** \brief Number of points that observations have, or could have, on the true planes of a
 * scene. \ingroup simulation */
struct TruthPoints {
  /** \param[in] planes number of the true planes */
  explicit TruthPoints(std::size_t planes)
  : of_label(planes + 1)
  {}

  std::size_t all = 0;
  /** \brief Index: label, the plane of the scene + 1; 0 is on no plane. */
  std::vector<std::size_t> of_label;
};

/** \brief Adds the pixels of an observation that active stereo can measure: visible to two
 * cameras, lit by the projector, at a depth in the range of the search.
 * \param[in] nearest,farthest depths, metres
 * \param[in,out] points of the true planes of the scene \ingroup simulation */
ACMAP_EXPORT void
addMeasurable(const SimulatedScene& scene,
              const SimulatedTruth& truth,
              double nearest,
              double farthest,
              TruthPoints& points);

/** \brief How frames were simulated. \ingroup simulation */
struct FramesOfTruth {
  std::uint64_t seed = 1;
  std::size_t observations = 0;
  std::uint32_t patterns = 0;
  int lines = 0;        ///< of a pattern
  bool are_raw = false; ///< of cameras as they are built
  SimulatedLight light;
};

/** \brief Writes the truth of a session, truth.json: scene, light, and the true planes in
 * the map frame with their points (\ref loadSessionTruth reads it).
 * \throws OutputFileException when it could not be written completely \ingroup simulation */
ACMAP_EXPORT void
saveFrameTruth(const std::string& path,
               const SimulatedScene& scene,
               const FramesOfTruth& frames,
               const TruthPoints& points);

/** \brief The same of observations as clouds.
 * \param[in] scene with its sensor
 * \param[in] building all copies of the scene (\ref repeatedScene), whose planes these are
 * \throws as above \ingroup simulation */
ACMAP_EXPORT void
saveCloudTruth(const std::string& path,
               const SimulatedScene& scene,
               const SimulatedScene& building,
               std::uint64_t seed,
               std::size_t observations,
               const TruthPoints& points);

} // namespace pcl
