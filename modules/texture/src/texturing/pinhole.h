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

/** Estimates the camera of an organized cloud from its points; returns nothing if there
 * are too few points or they do not fit a pinhole camera. */
std::optional<Pinhole>
pinholeOf(const ColoredView& view);

} // namespace pcl::acmap::texturing
