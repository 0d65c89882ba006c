#pragma once

#include <pcl/core/export.h>
#include <pcl/egomotion/keypoint_kernel.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::acmap {

/** \brief How log-polar patches are taken and matched; see
 * registration::CorrespondenceEstimationLogPolar. */
struct LogPolarSettings {
  int rings = 12, sectors = 24; ///< samples of a patch
  float inner = 1, outer = 20;  ///< pixels, radius of the first and of the last ring
  float least_contrast = 0.3F;  ///< grey levels, standard deviation in a patch
  float least_score = 0.8F;     ///< Pearson coefficient of a match: its strength
  float most_ambiguity = 0.7F;  ///< see PatchMatch: its distinctiveness
  float second_distance = 3;    ///< pixels between best and second best, at least
  int ring_shifts = 0;          ///< scales tried on either side
  int sector_shifts = 0;        ///< turns tried on either side
  unsigned threads = 0;         ///< 0 = all
};

/** \brief Patches around keypoints, each of mean 0 and length 1, on rings of growing
 * radius: a turn of the image shifts the sectors, a change of scale the rings. Those of
 * a keypoint too near the border, or of too little contrast, are missing. */
struct LogPolarPatches {
  int width = 0;                      ///< pixels, of the image
  std::vector<std::int32_t> pixels;   ///< of each patch
  std::vector<std::int32_t> keypoint; ///< of each patch: position in what was asked for
  std::vector<float> samples; ///< ring after ring, the patches one behind another
};

/** \brief A match of two patches. */
struct PatchMatch {
  std::int32_t source = 0, target = 0; ///< position among the keypoints asked for
  float score = 0;                     ///< Pearson coefficient
  float ambiguity = 0; ///< 1.003 - score, by that of the second best of either
};

/** \brief Which pairs may be matched. A pair is left out where it fails one. */
struct MatchGate {
  float image_distance = std::numeric_limits<float>::infinity(); ///< pixels
  float distance = std::numeric_limits<float>::infinity();       ///< metres
  float distance_per_metre = 0; ///< added for each metre of the target from its sensor
};

/** \brief What \ref matchPatches left out, and why. */
struct MatchCounts {
  std::size_t weak = 0; ///< sources whose best score is too small, or without any pair
  std::size_t ambiguous = 0; ///< whose second best is too near the best
  std::size_t one_sided = 0; ///< not the best of their best
};

ACMAP_EXPORT LogPolarPatches
logPolarPatches(const GreyImage& image,
                const std::vector<std::int32_t>& pixels,
                const LogPolarSettings& settings);

/** \brief Matches of patches, by source; the whole matching is one matrix product a
 * shift.
 * \param[in] source_points, target_points metres, one for each keypoint that was asked
 * for */
ACMAP_EXPORT std::vector<PatchMatch>
matchPatches(const LogPolarPatches& source,
             const LogPolarPatches& target,
             const std::vector<Eigen::Vector3f>& source_points,
             const std::vector<Eigen::Vector3f>& target_points,
             const MatchGate& gate,
             const LogPolarSettings& settings,
             MatchCounts& counts);

} // namespace pcl::acmap
