#include "point_weights.h"

#include <pcl/core/arguments.h>
#include <pcl/mapping/map_entropy_kernel.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace pcl::acmap {

PointWeights::PointWeights(const float* weights, float largest)
: weights_(weights)
{
  int exponent = 0;
  std::frexp(largest, &exponent); // largest < 2^exponent
  scale_ = std::ldexp(1.0, 15 - exponent);
  unit_ = 1 / scale_;
  one_ = static_cast<std::uint64_t>(scale_);
}

float
largestWeight(const float* weights, std::size_t size)
{
  if (!weights)
    return 1;
  requirePointWeights(weights, size);
  return size > 0 ? *std::max_element(weights, weights + size) : 0;
}

void
requirePointWeights(const float* weights, std::size_t size)
{
  constexpr float most = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < size; ++i)
    if (!(weights[i] >= 0 && weights[i] <= most))
      refuseArgument("weight of point " + std::to_string(i),
                     static_cast<double>(weights[i]),
                     "finite and not negative");
}

} // namespace pcl::acmap
