#include "remap_table.h"

#include <pcl/core/parallel.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

RemapTable::RemapTable(const RigCalibration& calibration,
                       const CameraCalibration& camera,
                       const CommonView& view)
: width_(calibration.width)
, height_(calibration.height)
{
  const TrinocularRig& rig = view.rig;
  const Eigen::Matrix3d R_camera_common = view.rotationOf(camera).transpose();
  const auto width = static_cast<std::size_t>(width_);
  sources_.resize(width * static_cast<std::size_t>(height_));
  parallelForChunks(sources_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto column = static_cast<double>(i % width);
      const auto row = static_cast<double>(i / width);
      const Eigen::Vector3d ray((column - rig.center_x) / rig.focal_length,
                                (row - rig.center_y) / rig.focal_length,
                                1.0);
      const Eigen::Vector2d from = projectPoint(camera, R_camera_common * ray);
      // The view was chosen so that only rounding leads over the edge.
      const auto place = [](double value, std::int32_t size) {
        const double most = static_cast<double>(size - 1) * steps;
        return static_cast<std::int32_t>(
            std::clamp(std::round(value * steps), 0.0, most));
      };
      const std::int32_t x = place(from.x(), width_);
      const std::int32_t y = place(from.y(), height_);
      sources_[i] = {x / steps, y / steps, x % steps, y % steps};
    }
  });
}

CameraImage
RemapTable::apply(const CameraImage& image) const
{
  CameraImage remapped = image;
  const std::int32_t channels = image.channels;
  const auto at = [&](std::int32_t column, std::int32_t row) {
    // A neighbour over the edge has no weight.
    const auto x = static_cast<std::size_t>(std::min(column, width_ - 1));
    const auto y = static_cast<std::size_t>(std::min(row, height_ - 1));
    const std::size_t pixel = y * static_cast<std::size_t>(width_) + x;
    return &image.values[pixel * static_cast<std::size_t>(channels)];
  };
  parallelForChunks(sources_.size(), [&](std::size_t begin, std::size_t end) {
    std::uint8_t* out = &remapped.values[begin * static_cast<std::size_t>(channels)];
    for (std::size_t i = begin; i < end; ++i) {
      const Source& from = sources_[i];
      const std::uint8_t* const a = at(from.column, from.row);
      const std::uint8_t* const b = at(from.column + 1, from.row);
      const std::uint8_t* const c = at(from.column, from.row + 1);
      const std::uint8_t* const d = at(from.column + 1, from.row + 1);
      for (std::int32_t k = 0; k < channels; ++k) {
        const std::int32_t upper = a[k] * (steps - from.right) + b[k] * from.right;
        const std::int32_t lower = c[k] * (steps - from.right) + d[k] * from.right;
        const std::int32_t sum = upper * (steps - from.below) + lower * from.below;
        *out++ = static_cast<std::uint8_t>((sum + steps * steps / 2) / (steps * steps));
      }
    }
  });
  return remapped;
}

} // namespace pcl::acmap
