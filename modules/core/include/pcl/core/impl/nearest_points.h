#pragma once

#include <pcl/core/export.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <vector>

namespace pcl::acmap {

/** \brief Finds the nearest points of a place by FLANN's tree, in floats. Points that are
 * not finite, or more than 1e18 m from 0, are left out. Several threads may ask at once. */
class ACMAP_EXPORT NearestPoints {
public:
  explicit NearestPoints(const LargeVector<Eigen::Vector3d>& points);
  explicit NearestPoints(const std::vector<Eigen::Vector3f>& points);
  ~NearestPoints();
  NearestPoints(NearestPoints&&) noexcept;
  NearestPoints&
  operator=(NearestPoints&&) = delete;

  /** \param[out] found the nearest points in ascending order of distance; fewer than
   * \a count if there are no more, none if the place is none of a point */
  void
  find(const Eigen::Vector3f& place, std::size_t count, Indices& found) const;

private:
  struct Tree;
  std::unique_ptr<Tree> tree_; ///< none if no point is finite
};

} // namespace pcl::acmap
