#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/egomotion/impl/keypoint_kernel.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::acmap {

/** \brief Settings for computing and matching log-polar patches; see
 * registration::CorrespondenceEstimationLogPolar. */
struct LogPolarSettings {
  int rings = 12, sectors = 24; ///< samples of a patch
  float inner = 1, outer = 20;  ///< radius of the first and of the last ring, pixels
  float min_contrast = 0.3F;    ///< minimum standard deviation in a patch, grey levels
  float min_score = 0.8F;       ///< minimum Pearson coefficient of a match (strength)
  float max_ambiguity = 0.7F;   ///< maximum, see PatchMatch (distinctiveness)
  float second_distance = 3;    ///< minimum distance of best and second best, pixels
  int ring_shifts = 0;          ///< scales tried in either direction
  int sector_shifts = 0;        ///< rotations tried in either direction
  unsigned threads = 0;         ///< 0 = all
};

/** \brief Calls visit (field, value) for each field but the threads; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const LogPolarSettings& settings, Visitor&& visit)
{
  visit({"rings"}, settings.rings);
  visit({"sectors"}, settings.sectors);
  visit({"inner", "px"}, settings.inner);
  visit({"outer", "px"}, settings.outer);
  visit({"min_contrast"}, settings.min_contrast);
  visit({"min_score"}, settings.min_score);
  visit({"max_ambiguity"}, settings.max_ambiguity);
  visit({"second_distance", "px"}, settings.second_distance);
  visit({"ring_shifts"}, settings.ring_shifts);
  visit({"sector_shifts"}, settings.sector_shifts);
}

/** \brief Patches around keypoints, each with mean 0 and length 1, on rings of
 * increasing radius: a rotation of the image shifts the sectors, a change of scale the
 * rings. Keypoints too close to the border, or with too little contrast, have no patch.
 */
struct LogPolarPatches {
  int width = 0;                      ///< of the image, pixels
  std::vector<std::int32_t> pixels;   ///< of each patch
  std::vector<std::int32_t> keypoint; ///< index of each patch's keypoint in the input
  std::vector<float> samples;         ///< of all patches in sequence, ring by ring
};

/** \brief A match of two patches. */
struct PatchMatch {
  std::int32_t source = 0, target = 0; ///< indices of the keypoints in the input
  float score = 0;                     ///< Pearson coefficient
  float ambiguity = 0; ///< 1.003 - score, divided by 1.003 - second best of either; a
                       ///< second best that is too low to matter is not told apart
};

/** \brief Conditions for pairs that may be matched; all of them must be satisfied. */
struct MatchGate {
  float image_distance = std::numeric_limits<float>::infinity(); ///< maximum, pixels
  float distance = std::numeric_limits<float>::infinity();       ///< maximum, metres
  float distance_per_metre = 0; ///< added per metre between the target and its sensor
};

/** \brief Why \ref matchPatches rejected sources. */
struct MatchCounts {
  std::size_t weak = 0;      ///< the best score is too small, or there is no pair
  std::size_t ambiguous = 0; ///< the second best score is too similar
  std::size_t one_sided = 0; ///< the source is not the best of its best target
};

ACMAP_EXPORT LogPolarPatches
logPolarPatches(const GreyImage& image,
                const std::vector<std::int32_t>& pixels,
                const LogPolarSettings& settings);

/** \brief Matches patches and orders the matches by source. All pairs are compared under
 * all shifts; a bound from above spares most of them the sum over all samples.
 * \param[in] source_points, target_points metres, one for each keypoint in the input of
 * \ref logPolarPatches */
ACMAP_EXPORT std::vector<PatchMatch>
matchPatches(const LogPolarPatches& source,
             const LogPolarPatches& target,
             const std::vector<Eigen::Vector3f>& source_points,
             const std::vector<Eigen::Vector3f>& target_points,
             const MatchGate& gate,
             const LogPolarSettings& settings,
             MatchCounts& counts);

} // namespace pcl::acmap
