#include "point_weights.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/mapping/impl/map_entropy_kernel.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace pcl::acmap {
namespace {

void
requireFiniteWeights(const float* weights, std::size_t size)
{
  constexpr float maximum = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < size; ++i)
    if (!(weights[i] >= 0 && weights[i] <= maximum))
      refuseArgument("weight of point " + std::to_string(i),
                     static_cast<double>(weights[i]),
                     "finite and not negative");
}

} // namespace

PointWeights::PointWeights(const float* weights, float largest)
: weights_(weights)
{
  int exponent = 0;
  std::frexp(largest, &exponent); // largest < 2^exponent
  scale_ = std::ldexp(1.0, 15 - exponent);
  unit_ = 1 / scale_;
  one_ = weights ? 0 : static_cast<std::uint64_t>(scale_);
}

float
largestWeight(const float* weights, std::size_t size)
{
  if (!weights)
    return 1;
  requireFiniteWeights(weights, size);
  return size > 0 ? *std::max_element(weights, weights + size) : 0;
}

void
requirePointWeights(const std::vector<float>& weights, std::size_t points)
{
  if (!weights.empty() && weights.size() != points)
    throw acmap::BadArgument("a cloud of " + std::to_string(points) +
                             " points needs as many weights or none, not " +
                             std::to_string(weights.size()));
  requireFiniteWeights(weights.data(), weights.size());
}

void
requireObservation(std::size_t number, std::size_t observations)
{
  if (number >= observations)
    throw acmap::BadArgument("there is no observation " + std::to_string(number) +
                             ", only " + std::to_string(observations));
}

} // namespace pcl::acmap
