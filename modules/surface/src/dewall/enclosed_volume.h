#pragma once

#include "point_tree.h"

#include <array>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief The volume that triangles of a cloud enclose, which tells their outer side. */
class EnclosedVolume {
public:
  explicit EnclosedVolume(const PointTree& tree);

  /** \brief Volume between a triangle and the middle of the points, times 6; negative if its
   * front faces the middle. The sum over a closed surface does not depend on the middle. */
  double
  under(const std::array<std::int32_t, 3>& corners) const
  {
    const Eigen::Vector3d a = tree_.position(corners[0]) - middle_,
                          b = tree_.position(corners[1]) - middle_,
                          c = tree_.position(corners[2]) - middle_;
    return a.dot(b.cross(c));
  }

  /** \brief Volume of the convex hull of the points, times 6; at most 1 % too large. */
  double
  ofHull() const;

  /** \brief Of the box around the points, metres. */
  double
  diagonal() const
  {
    return box_.diagonal().norm();
  }

private:
  const PointTree& tree_;
  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();
  Eigen::AlignedBox3d box_;
};

} // namespace pcl::acmap::ACMAP_DEWALL
