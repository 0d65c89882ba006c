#pragma once

#include <pcl/core/impl/nearest_points.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief The surface about a place, by its nearest points. Metres. */
struct NoiseWindow {
  std::size_t points = 0; ///< 0: there are not enough
  Eigen::Vector3d mean = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
  Eigen::Vector3d variances = Eigen::Vector3d::Zero(); ///< ascending
  double thickness = 0; ///< of the points from their plane, standard deviation
  double rough = 0;     ///< the same from a quadric; of few points from the plane
  /** \brief Share of the variance across the plane that is left within the two parts of
   * its best split: 0.36 for noise, 0 for two sheets. */
  double split = 0;
  double radius = 0;
};

/** \brief Finds the nearest points of a place. */
class WindowTree {
public:
  explicit WindowTree(std::vector<Eigen::Vector3f> points);

  /** \brief Distance of the farthest of some nearest points. */
  double
  radius(const Eigen::Vector3f& place, std::size_t points) const;

  /** \brief Places of the nearest points. */
  std::vector<Eigen::Vector3f>
  nearest(const Eigen::Vector3f& place, std::size_t points) const;

private:
  std::vector<Eigen::Vector3f> points_;
  NearestPoints tree_;
};

NoiseWindow
windowOf(const WindowTree& tree, const Eigen::Vector3f& place, std::size_t points);

} // namespace pcl::acmap
