#pragma once

#include <pcl/core/point_types.h>
#include <pcl/core/random.h>
#include <pcl/point_cloud.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::acmap::test {

/** \brief A room of 6 x 2.6 x 5 m around the origin, with a recess of 10 cm in the wall
 * at z = 2.5 m, |x| < 1 m. Metres. */
struct AdjustmentRoom {
  static constexpr double half_x = 3, half_y = 1.3, half_z = 2.5;
  static constexpr double recess = 0.1, recess_half = 1;

  /** Distance from a place in the room to its surface. */
  static double
  distanceAlong(const Eigen::Vector3d& from, const Eigen::Vector3d& ray)
  {
    const Eigen::Vector3d half(half_x, half_y, half_z);
    double distance = std::numeric_limits<double>::infinity();
    int axis = 0;
    for (int i = 0; i < 3; ++i)
      if (std::abs(ray[i]) > 1e-12) {
        const double here = ((ray[i] > 0 ? half[i] : -half[i]) - from[i]) / ray[i];
        if (here < distance) {
          distance = here;
          axis = i;
        }
      }
    const double x = from.x() + distance * ray.x();
    if (axis != 2 || ray.z() < 0 || std::abs(x) >= recess_half)
      return distance;
    double deeper = (half_z + recess - from.z()) / ray.z();
    if (std::abs(from.x() + deeper * ray.x()) > recess_half)
      deeper = ((ray.x() > 0 ? recess_half : -recess_half) - from.x()) / ray.x();
    return deeper;
  }

  /** An organized view, sensor's frame; sigma is the noise along the ray, metres. */
  static PointCloud<PointXYZRGBSigma>::Ptr
  view(const Eigen::Isometry3d& pose, double sigma, std::uint64_t seed)
  {
    constexpr unsigned width = 320, height = 240;
    constexpr double focal =
        140; // pixels: each view sees side walls, floor and ceiling
    Random random(seed);
    const auto cloud = std::make_shared<PointCloud<PointXYZRGBSigma>>(width, height);
    for (unsigned row = 0; row < height; ++row)
      for (unsigned column = 0; column < width; ++column) {
        const Eigen::Vector3d ray =
            Eigen::Vector3d((column - 0.5 * (width - 1)) / focal,
                            (row - 0.5 * (height - 1)) / focal,
                            1)
                .normalized();
        const double distance = distanceAlong(pose.translation(), pose.linear() * ray) +
                                sigma * random.normal();
        PointXYZRGBSigma& point = (*cloud)(column, row);
        point.getVector3fMap() = (distance * ray).cast<float>();
        point.sigma = static_cast<float>(sigma);
      }
    return cloud;
  }

  /** Poses on a closed path, each of which looks across the room, so that it sees floor
   * and ceiling. */
  static std::vector<Eigen::Isometry3d>
  path(std::size_t views)
  {
    std::vector<Eigen::Isometry3d> poses;
    for (std::size_t i = 0; i < views; ++i) {
      const double angle =
          2 * M_PI * static_cast<double>(i) / static_cast<double>(views);
      Eigen::Isometry3d pose(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()));
      pose.translation() << -std::sin(angle), 0.1 * std::sin(3 * angle),
          -std::cos(angle);
      poses.push_back(pose);
    }
    return poses;
  }

  /** The same path by an odometry with errors in six degrees of freedom. */
  static std::vector<Eigen::Isometry3d>
  drifted(const std::vector<Eigen::Isometry3d>& truth,
          double turn,
          double length,
          std::uint64_t seed)
  {
    Random random(seed);
    std::vector<Eigen::Isometry3d> poses{truth.front()};
    for (std::size_t i = 1; i < truth.size(); ++i) {
      Eigen::Isometry3d motion = truth[i - 1].inverse() * truth[i];
      Eigen::Vector3d axis, way;
      for (int k = 0; k < 3; ++k) {
        axis[k] = turn * random.normal();
        way[k] = length * random.normal();
      }
      motion.rotate(Eigen::AngleAxisd(axis.norm(), axis.normalized()));
      motion.translation() += way;
      Eigen::Isometry3d pose = poses.back() * motion;
      pose.linear() = Eigen::Quaterniond(pose.linear()).normalized().toRotationMatrix();
      poses.push_back(pose);
    }
    return poses;
  }
};

} // namespace pcl::acmap::test
