#pragma once

#include <pcl/core/impl/up_direction.h>

#include <vector>

namespace pcl::acmap {

/** \brief Combines normals of similar direction, regardless of their sign, so that a map
 * of any size has a limited number of them. */
class FacingTable {
public:
  FacingTable();

  /** \brief Adds a surface; normals that are not finite or have no length are skipped. */
  void
  add(const Eigen::Vector3d& normal, double area);

  /** \brief Mean normal and area of each combination. */
  std::vector<FacingArea>
  facings() const;

private:
  struct Sum {
    Eigen::Vector3d normals = Eigen::Vector3d::Zero();
    double area = 0;
  };
  std::vector<Sum> sums_;
};

} // namespace pcl::acmap
