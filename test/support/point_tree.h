#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::acmap::test {

using Points = std::vector<Eigen::Vector3d>;

/** \brief k-d tree in double precision, independent of the kernels that are checked
 * with it. Points that are not finite are ignored. */
class ReferenceTree {
public:
  explicit ReferenceTree(Points points);

  /** \brief Index of a point closer to \a center than \a radius, or -1. */
  std::int32_t
  findWithin(const Eigen::Vector3d& center, double radius) const;

  /** \brief The \a count nearest points as (squared distance, index), nearest first. */
  std::vector<std::pair<double, std::int32_t>>
  nearest(const Eigen::Vector3d& query, std::size_t count) const;

  /** \brief Indices of all points within \a radius of \a center. */
  std::vector<std::int32_t>
  within(const Eigen::Vector3d& center, double radius) const;

private:
  using Heap = std::vector<std::pair<double, std::int32_t>>;

  void
  build(std::size_t begin, std::size_t end);

  std::int32_t
  findWithin(std::size_t begin,
             std::size_t end,
             const Eigen::Vector3d& center,
             double squared) const;

  void
  within(std::size_t begin,
         std::size_t end,
         const Eigen::Vector3d& center,
         double squared,
         std::vector<std::int32_t>& found) const;

  void
  nearest(std::size_t begin,
          std::size_t end,
          const Eigen::Vector3d& query,
          std::size_t count,
          Heap& heap) const;

  static constexpr std::size_t leaf_size = 8;

  Points points_;
  std::vector<std::int32_t> order_;
  std::vector<std::uint8_t> axis_; ///< of the node whose median is at this index
};

/** \brief Median distance of finite points to their nearest point at a different
 * position. */
double
medianSpacing(const Points& points);

} // namespace pcl::acmap::test
