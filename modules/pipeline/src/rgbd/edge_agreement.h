#pragma once

#include <pcl/PCLPointCloud2.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief Compares the edges of the colours of organized clouds with the edges of their
 * depths. */
class EdgeAgreement {
public:
  /** \brief Adds a cloud of x y z rgb sigma; those of other sizes than the first are left
   * out. O(pixels) */
  void
  add(const PCLPointCloud2& cloud);

  /** \brief Shift of the colours in pixels at which both have their edges in the same places;
   * nothing if no shift is clearly better than all that are far from it. */
  std::optional<Eigen::Vector2d>
  bestShift() const;

private:
  int width_ = 0, height_ = 0;
  int step_ = 1;             ///< pixels between two shifts
  int reach_ = 0;            ///< shifts in each direction
  std::vector<double> sums_; ///< of the gradients of the colours at edges, by shift
  double edges_ = 0;
};

} // namespace pcl::acmap
