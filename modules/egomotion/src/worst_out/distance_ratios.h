#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief The largest ratio of two distances that is told apart. */
constexpr float most_ratio = 1000;

/** \brief Places of matches in both clouds, coordinate by coordinate. */
struct MatchPlaces {
  std::vector<float> coordinates[6]; ///< source x y z, target x y z
  std::vector<std::int32_t> matches; ///< their positions among those given, rising

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

/** \brief What the ratios of a match to others sum up to. Floats from 1 to most_ratio
 * are multiples of 2^-23, so that sums of a million of them are exact in double:
 * whatever the order, and after subtractions. */
struct RatioSums {
  std::vector<double> sums;
  std::vector<std::int32_t> counts; ///< pairs that told something

  /** \brief D_ij of Eq. 1; infinite where no pair told anything. */
  double
  distortion(std::size_t place) const;
};

/** \brief Adds what the pair of each match with one other tells (sign 1), or takes it
 * away again (-1).
 *
 * The ratio is the larger distance by the smaller, both at least the least distance: a
 * pair that is near in both clouds tells nothing, one that is near in one alone does.
 * \param[in] one source x y z, target x y z of the other
 * \param[out] sums as many as there are places */
void
addRatios(const MatchPlaces& places,
          const float (&one)[6],
          float least_distance,
          int sign,
          RatioSums& sums);

} // namespace pcl::acmap
