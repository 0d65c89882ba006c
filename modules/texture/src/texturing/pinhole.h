#pragma once

#include <pcl/texture/texturing_kernel.h>

#include <optional>

namespace pcl::acmap::texturing {

/** How a camera maps points to pixels: column = fx x / z + cx, row = fy y / z + cy. */
struct Pinhole {
  double fx = 0, fy = 0, cx = 0, cy = 0;
  int width = 0, height = 0;

  Eigen::Vector2d
  pixelOf(const Eigen::Vector3d& point) const
  {
    return {fx * point.x() / point.z() + cx, fy * point.y() / point.z() + cy};
  }
};

/** The camera that saw an organized cloud, from where its points lie; nothing where they
 * are too few or do not lie as a pinhole camera sees them. */
std::optional<Pinhole>
pinholeOf(const ColoredView& view);

} // namespace pcl::acmap::texturing
