#include "pinhole_scene.h"

#include <algorithm>

namespace pcl::acmap {

namespace {

constexpr int tile_size = 32; // px

int
tileAt(double pixel, int tiles)
{
  return std::clamp(static_cast<int>(pixel + 0.5) / tile_size, 0, tiles - 1);
}

double
depthOf(const CastTarget& target, const Eigen::Vector3d& ray, const DepthRange& range)
{
  return std::visit([&](const auto& shape) { return shape.depth(ray, range); },
                    target.shape);
}

} // namespace

PinholeScene::PinholeScene(const SceneGeometry& scene,
                           const TrinocularRig& pinhole,
                           const Eigen::Isometry3d& T_scene_pinhole)
: pinhole_(pinhole)
, columns_((pinhole.width + tile_size - 1) / tile_size)
, rows_((pinhole.height + tile_size - 1) / tile_size)
, tiles_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_))
{
  range_.maximum = std::numeric_limits<double>::infinity();
  const Eigen::Isometry3d T_pinhole_scene = T_scene_pinhole.inverse();
  for (std::size_t i = 0; i < scene.surfaces().size(); ++i)
    if (auto target = targetOf(scene.surfaces()[i],
                               static_cast<std::int32_t>(i),
                               pinhole,
                               T_pinhole_scene,
                               range_))
      targets_.push_back(std::move(*target));
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const PixelBox& box = targets_[i].box;
    for (int row = box.first_row / tile_size; row <= box.last_row / tile_size; ++row)
      for (int column = box.first_column / tile_size;
           column <= box.last_column / tile_size;
           ++column)
        tiles_[static_cast<std::size_t>(row * columns_ + column)].push_back(
            static_cast<std::uint32_t>(i));
  }
}

const std::vector<std::uint32_t>&
PinholeScene::tileOf(const Eigen::Vector3d& ray) const
{
  const int column =
      tileAt(pinhole_.focal_length * ray.x() + pinhole_.center_x, columns_);
  const int row = tileAt(pinhole_.focal_length * ray.y() + pinhole_.center_y, rows_);
  return tiles_[static_cast<std::size_t>(row * columns_ + column)];
}

PinholeScene::Hit
PinholeScene::hit(const Eigen::Vector3d& ray) const
{
  Hit nearest;
  for (const std::uint32_t i : tileOf(ray)) {
    const double depth = depthOf(targets_[i], ray, range_);
    if (range_.contains(depth) && depth < nearest.depth)
      nearest = {depth, targets_[i].surface};
  }
  return nearest;
}

bool
PinholeScene::sees(const Eigen::Vector3d& point) const
{
  constexpr double slack = 1e-5; // metres, avoids that a surface occludes itself
  const Eigen::Vector3d ray = point / point.z();
  const double limit = point.z() - slack;
  for (const std::uint32_t i : tileOf(ray)) {
    const double depth = depthOf(targets_[i], ray, range_);
    if (depth >= range_.minimum && depth < limit)
      return false;
  }
  return true;
}

} // namespace pcl::acmap
