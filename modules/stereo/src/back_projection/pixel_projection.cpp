#include "back_projection/pixel_projection.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/core/rig_cameras.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap {

namespace {

void
addCounts(PixelCounts& sum, const PixelCounts& more)
{
  sum.points += more.points;
  sum.invalid += more.invalid;
  sum.too_near += more.too_near;
  sum.too_far += more.too_far;
}

} // namespace

PixelProjection::PixelProjection(const TrinocularRig& rig,
                                 const DepthLimits& limits,
                                 const MatchedDisparity& matched,
                                 const CameraImage& color)
: rig_(rig)
, limits_(limits)
, matched_(matched)
, color_(color)
, focal_baseline_(rig.focal_length * disparityBaseline(rig))
, offset_(disparityOffset(rig))
{}

PixelCounts
PixelProjection::projectAll(PointXYZRGBSigma* points, std::size_t size) const
{
  const auto project = [&](std::size_t begin, std::size_t end) {
    PixelCounts counts;
    for (std::size_t pixel = begin; pixel < end; ++pixel) {
      paint(pixel, points[pixel]);
      ++(counts.*place(pixel, points[pixel]));
    }
    return counts;
  };
  return parallelReduceChunks(size, PixelCounts{}, project, addCounts);
}

void
PixelProjection::paint(std::size_t pixel, PointXYZRGBSigma& point) const
{
  if (color_.empty())
    return;
  const auto channels = static_cast<std::size_t>(color_.channels);
  const std::uint8_t* values = &color_.values[channels * pixel];
  point.r = values[0];
  point.g = values[channels / 2];
  point.b = values[channels - 1];
}

/** \return the member of \ref PixelCounts to which the pixel belongs */
std::size_t PixelCounts::*
PixelProjection::place(std::size_t pixel, PointXYZRGBSigma& point) const
{
  const double disparity = matched_.disparity.values[pixel] + offset_;
  const bool is_known = std::isfinite(disparity);
  const double z = focal_baseline_ / disparity;
  if (is_known && disparity > 0.0 && z >= limits_.minimum && z <= limits_.largest) {
    setPlace(pixel, z, point);
    return &PixelCounts::points;
  }
  point.x = point.y = point.z = point.sigma = std::numeric_limits<float>::quiet_NaN();
  if (!is_known)
    return &PixelCounts::invalid;
  return disparity > 0.0 && z < limits_.minimum ? &PixelCounts::too_near
                                                : &PixelCounts::too_far;
}

void
PixelProjection::setPlace(std::size_t pixel, double z, PointXYZRGBSigma& point) const
{
  const auto width = static_cast<std::size_t>(rig_.width);
  const double x =
      (static_cast<double>(pixel % width) - rig_.center_x) / rig_.focal_length;
  const double y =
      (static_cast<double>(pixel / width) - rig_.center_y) / rig_.focal_length;
  point.x = static_cast<float>(x * z);
  point.y = static_cast<float>(y * z);
  point.z = static_cast<float>(z);
  // From the derivative of z, along a ray of this length at z = 1.
  const double sigma =
      disparitySigma(pixel) * z * z / focal_baseline_ * std::sqrt(x * x + y * y + 1.0);
  constexpr double maximum = std::numeric_limits<float>::max();
  point.sigma = static_cast<float>(std::min(sigma, maximum));
}

double
PixelProjection::disparitySigma(std::size_t pixel) const
{
  if (matched_.sigma.empty())
    return rig_.disparity_sigma;
  const double sigma = matched_.sigma[pixel];
  return std::isfinite(sigma) && sigma >= 0.0 ? sigma : rig_.disparity_sigma;
}

} // namespace pcl::acmap
