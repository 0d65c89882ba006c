#pragma once

#include <pcl/core/random.h>

#include <Eigen/Geometry>

#include <vector>

namespace pcl::acmap::test {

/** \brief Points on a facade with rows of windows that lie behind its wall, on their reveals,
 * and on the pavement before it. Its sizes and its direction are drawn.
 * \param[in] sigma noise across all surfaces, metres */
inline std::vector<Eigen::Vector3f>
makeFacade(double sigma, Random& random)
{
  using Eigen::Vector2d;
  using Eigen::Vector3d;
  const double width = random.uniform(10, 25), height = random.uniform(7, 16);
  const double depth = random.uniform(0.08, 0.35);
  const double spacing = random.uniform(0.03, 0.08);
  const Vector2d window(random.uniform(0.7, 1.6), random.uniform(0.9, 1.9));
  const Vector2d wall(random.uniform(0.4, 1.5), random.uniform(0.6, 1.6));
  const Eigen::AngleAxisd turn(random.uniform(0, 3), Vector3d::UnitZ());
  const Vector3d x = turn * Vector3d::UnitX(), y = turn * Vector3d::UnitY(),
                 z = Vector3d::UnitZ();
  std::vector<Eigen::Vector3f> points;
  const auto add = [&](const Vector3d& corner, const Vector3d& u, const Vector3d& v) {
    const Vector3d normal = u.cross(v).normalized();
    const auto count =
        static_cast<std::size_t>(u.norm() * v.norm() / (spacing * spacing));
    for (std::size_t i = 0; i < count; ++i) {
      const double along_u = random.uniform(), along_v = random.uniform();
      points.push_back(
          (corner + along_u * u + along_v * v + sigma * random.normal() * normal)
              .cast<float>());
    }
  };
  add(-4 * y, width * x, 4 * y);
  double bottom = 0;
  for (; bottom + wall.y() + window.y() < height; bottom += wall.y() + window.y()) {
    add(bottom * z, width * x, wall.y() * z);
    const Vector3d sill = (bottom + wall.y()) * z;
    double left = 0;
    for (; left + wall.x() + window.x() < width; left += wall.x() + window.x()) {
      add(sill + left * x, wall.x() * x, window.y() * z);
      const Vector3d corner = sill + (left + wall.x()) * x;
      add(corner + depth * y, window.x() * x, window.y() * z);
      add(corner, depth * y, window.y() * z);
      add(corner + window.x() * x, depth * y, window.y() * z);
      add(corner, window.x() * x, depth * y);
      add(corner + window.y() * z, window.x() * x, depth * y);
    }
    add(sill + left * x, (width - left) * x, window.y() * z);
  }
  add(bottom * z, width * x, (height - bottom) * z);
  return points;
}

} // namespace pcl::acmap::test
