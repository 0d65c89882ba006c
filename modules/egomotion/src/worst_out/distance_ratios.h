#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Upper limit of the ratio of two distances. */
constexpr float max_ratio = 1000;

/** \brief Points of the matches in both clouds, coordinate by coordinate. */
struct MatchPlaces {
  std::vector<float> coordinates[6]; ///< source x y z, target x y z
  std::vector<std::int32_t> matches; ///< indices in the input, ascending

  std::size_t
  size() const
  {
    return matches.size();
  }

  void
  push_back(std::int32_t match,
            const Eigen::Vector3f& source,
            const Eigen::Vector3f& target);

  void
  erase(std::size_t place);
};

/** \brief Sums of the ratios of each match to the others. Floats from 1 to max_ratio
 * are multiples of 2^-23, so that sums of a million of them are exact in double
 * precision, in any order and after subtractions. */
struct RatioSums {
  std::vector<double> sums;
  std::vector<std::int32_t> counts; ///< number of valid pairs

  /** \brief D_ij of Eq. 1; infinite if there is no valid pair. */
  double
  distortion(std::size_t place) const;
};

/** \brief Adds the ratios of the pairs of each match with one other match (sign 1), or
 * subtracts them (-1).
 *
 * The ratio is the larger distance divided by the smaller one, both at least the
 * minimum distance. A pair that is near in both clouds is skipped, or counted with a
 * fixed ratio; a pair that is near in only one of them is counted.
 * \param[in] one source x y z, target x y z of the other match
 * \param[in] near_ratio of pairs that are near in both clouds; 0: they are skipped
 * \param[in,out] sums one entry per match of \a places */
void
addRatios(const MatchPlaces& places,
          const float (&one)[6],
          float min_distance,
          float near_ratio,
          int sign,
          RatioSums& sums);

} // namespace pcl::acmap
