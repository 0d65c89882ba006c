#include "remap_table.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

RemapTable::RemapTable(const RigCalibration& calibration,
                       const CameraCalibration& camera,
                       const CommonView& view)
: width_(static_cast<std::size_t>(calibration.width))
, height_(static_cast<std::size_t>(calibration.height))
{
  const TrinocularRig& rig = view.rig;
  const Eigen::Matrix3d R_camera_common = view.rotationOf(camera).transpose();
  sources_.resize(width_ * height_);
  parallelForChunks(sources_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto column = static_cast<double>(i % width_);
      const auto row = static_cast<double>(i / width_);
      const Eigen::Vector3d ray((column - rig.center_x) / rig.focal_length,
                                (row - rig.center_y) / rig.focal_length,
                                1.0);
      const Eigen::Vector2d from = projectPoint(camera, R_camera_common * ray);
      // The common view is inside all images, up to rounding errors.
      const Place x = placeOf(from.x(), width_);
      const Place y = placeOf(from.y(), height_);
      sources_[i] = {static_cast<std::uint32_t>(y.pixel * width_ + x.pixel),
                     static_cast<std::uint16_t>(x.rest),
                     static_cast<std::uint16_t>(y.rest)};
    }
  });
}

RemapTable::Place
RemapTable::placeOf(double value, std::size_t size)
{
  const auto last = static_cast<double>(size - 1);
  const auto place = static_cast<std::size_t>(
      std::clamp(std::round(value * steps), 0.0, last * steps));
  // The last position belongs to the interval between the last two pixels.
  const std::size_t pixel = std::min(place / steps, std::max<std::size_t>(size, 2) - 2);
  return {pixel, place - pixel * steps};
}

template <std::size_t channels>
void
RemapTable::fill(const std::uint8_t* from,
                 std::size_t begin,
                 std::size_t end,
                 std::uint8_t* to) const
{
  // With a single row or column there is no such neighbour, and its weight is 0.
  const std::size_t right = width_ > 1 ? channels : 0;
  const std::size_t below = height_ > 1 ? channels * width_ : 0;
  const Source* const sources = sources_.data();
  to += channels * begin;
  for (std::size_t i = begin; i < end; ++i) {
    const Source source = sources[i]; // a copy, because written bytes may alias it
    const std::uint8_t* const a = from + channels * source.pixel;
    const std::uint8_t* const b = a + below;
    for (std::size_t k = 0; k < channels; ++k) {
      const int upper = a[k] * steps + (a[k + right] - a[k]) * source.right;
      const int lower = b[k] * steps + (b[k + right] - b[k]) * source.right;
      const int sum = upper * steps + (lower - upper) * source.below;
      const auto rounded = static_cast<unsigned>(sum + steps * steps / 2);
      *to++ = static_cast<std::uint8_t>(rounded / (steps * steps));
    }
  }
}

CameraImage
RemapTable::apply(const CameraImage& image) const
{
  CameraImage remapped{image.width, image.height, image.channels, {}};
  remapped.values.resize(image.values.size());
  parallelForChunks(sources_.size(), [&](std::size_t begin, std::size_t end) {
    if (image.channels == 1)
      fill<1>(image.values.data(), begin, end, remapped.values.data());
    else
      fill<3>(image.values.data(), begin, end, remapped.values.data());
  });
  return remapped;
}

} // namespace pcl::acmap
