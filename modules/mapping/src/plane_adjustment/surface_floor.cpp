#include "surface_floor.h"

#include "landmark_solver.h"

#include <pcl/core/impl/quantile.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::acmap {
namespace {

/** Distances from planes in one bin of distance from the sensor. */
struct FloorBin {
  std::vector<double> excess; ///< squared distances, minus the variance of the noise
  double range = 0;           ///< sum of the distances from the sensor
};

} // namespace

SurfaceFloor
measureFloor(const std::vector<Landmark>& landmarks,
             const Poses& poses,
             const SurfaceFloor& before)
{
  constexpr std::size_t min_views = 3, min_values = 30;
  constexpr double largest = 0.05;           // metres, at 1 m
  constexpr double median_of_square = 0.455; // of a standard normal variable
  std::array<FloorBin, RangeNoise::bins> bins;
  for (const Landmark& landmark : landmarks) {
    if (landmark.views.size() < min_views)
      continue;
    double sum = 0;
    for (const LandmarkView& view : landmark.views)
      sum += view.cluster(3, 3);
    for (const LandmarkView& view : landmark.views) {
      // the plane follows a view with a large weight
      const double free = 1 - view.cluster(3, 3) / sum;
      if (free < 0.3)
        continue;
      const double distance = distanceOfView(landmark, view, poses);
      FloorBin& bin = bins[RangeNoise::binOf(view.distance)];
      bin.excess.push_back(distance * distance / free -
                           median_of_square * view.variance);
      bin.range += view.distance;
    }
  }
  // Least squares of variance = constant^2 + per_square^2 range^4.
  double ones = 0, fourth = 0, eighth = 0, right = 0, right_fourth = 0;
  for (FloorBin& bin : bins) {
    if (bin.excess.size() < min_values)
      continue;
    const auto count = static_cast<double>(bin.excess.size());
    const double variance = std::max(0.0, medianOf(bin.excess) / median_of_square);
    const double power = std::pow(bin.range / count, 4);
    const double weight = count / std::pow(1 + power, 2); // errors grow with the range
    ones += weight;
    fourth += weight * power;
    eighth += weight * power * power;
    right += weight * variance;
    right_fourth += weight * variance * power;
  }
  if (!(ones > 0))
    return before;
  const double determinant = ones * eighth - fourth * fourth;
  double constant = right / ones, growth = 0;
  if (determinant > 1e-9 * ones * eighth) {
    constant = (right * eighth - right_fourth * fourth) / determinant;
    growth = (right_fourth * ones - right * fourth) / determinant;
    if (growth < 0) {
      constant = right / ones;
      growth = 0;
    }
    else if (constant < 0) {
      constant = 0;
      growth = right_fourth / eighth;
    }
  }
  SurfaceFloor floor = before;
  floor.constant = std::clamp(
      std::sqrt(std::max(constant, 0.0)), SurfaceFloor::min_constant, largest);
  floor.per_square = std::min(std::sqrt(growth), largest);
  return floor;
}

} // namespace pcl::acmap
