#include "worst_out/distance_ratios.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap {

namespace {

constexpr std::size_t block = 256;

/** Computes the ratios of a block. NaN, which results from overflowing squares, is
 * counted as the largest ratio.
 * \param[in] near_ratio of pairs that are near in both clouds; 0: they are skipped */
void
ratiosOf(const float* const (&at)[6],
         std::size_t size,
         const float (&one)[6],
         float floor,
         float near_ratio,
         float* ratios)
{
  for (std::size_t k = 0; k < size; ++k) {
    float squares[2];
    for (int cloud = 0; cloud < 2; ++cloud) {
      const float x = at[3 * cloud][k] - one[3 * cloud];
      const float y = at[3 * cloud + 1][k] - one[3 * cloud + 1];
      const float z = at[3 * cloud + 2][k] - one[3 * cloud + 2];
      squares[cloud] = x * x + y * y + z * z;
    }
    const float larger = squares[0] > squares[1] ? squares[0] : squares[1];
    const float smaller = squares[0] > squares[1] ? squares[1] : squares[0];
    const float ratio = std::sqrt(larger / (smaller > floor ? smaller : floor));
    const float capped = ratio < max_ratio ? ratio : max_ratio;
    ratios[k] = larger <= floor ? near_ratio : capped;
  }
}

} // namespace

void
MatchPlaces::push_back(std::int32_t match,
                       const Eigen::Vector3f& source,
                       const Eigen::Vector3f& target)
{
  for (int axis = 0; axis < 3; ++axis) {
    coordinates[axis].push_back(source[axis]);
    coordinates[3 + axis].push_back(target[axis]);
  }
  matches.push_back(match);
}

void
MatchPlaces::erase(std::size_t place)
{
  const auto offset = static_cast<std::ptrdiff_t>(place);
  for (std::vector<float>& values : coordinates)
    values.erase(values.begin() + offset);
  matches.erase(matches.begin() + offset);
}

double
RatioSums::distortion(std::size_t place) const
{
  return counts[place] == 0 ? std::numeric_limits<double>::infinity()
                            : sums[place] / counts[place];
}

void
addRatios(const MatchPlaces& places,
          const float (&one)[6],
          float min_distance,
          float near_ratio,
          int sign,
          RatioSums& sums)
{
  float ratios[block];
  for (std::size_t begin = 0; begin < places.size(); begin += block) {
    const std::size_t size = std::min(block, places.size() - begin);
    const float* at[6];
    for (int axis = 0; axis < 6; ++axis)
      at[axis] = places.coordinates[axis].data() + begin;
    ratiosOf(at, size, one, min_distance * min_distance, near_ratio, ratios);
    double* const sum = sums.sums.data() + begin;
    std::int32_t* const count = sums.counts.data() + begin;
    for (std::size_t k = 0; k < size; ++k) {
      sum[k] += sign * static_cast<double>(ratios[k]);
      count[k] += ratios[k] > 0 ? sign : 0;
    }
  }
}

} // namespace pcl::acmap
