#pragma once

#include <pcl/core/box_patch.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap::boxes {

/** A side of a box that is being fitted. */
struct Side {
  BoxFaceKind kind = BoxFaceKind::Free;
  std::vector<std::size_t> pieces; ///< of a side that was seen
  std::int32_t plane = -1;
  double position = 0;  ///< outward from the origin of the box, metres
  double deviation = 0; ///< standard deviation of a side that was not seen, metres
};

/** A box that is being fitted. Sides are in the order of BoxPatch::faces. */
struct Box {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); ///< a place inside
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  std::array<Side, 6> sides;
  Eigen::Vector4d slant = Eigen::Vector4d::Zero(); ///< as that of BoxPatch

  /** As that of BoxPatch. */
  Eigen::Matrix<double, 9, 9> covariance = Eigen::Matrix<double, 9, 9>::Zero();
  /** Standard deviation of the turn about the last axis if no plane tells it, radians;
   * otherwise 0. */
  double turn_deviation = 0;

  double misfit = 0; ///< chi squared of the planes of its faces
  double saved_bits = 0;
  double bits_of_planes = 0;
  std::int32_t template_id = 0;

  static int
  axisOf(std::size_t side)
  {
    return static_cast<int>(side / 2);
  }

  Eigen::Vector3d
  outward(std::size_t side) const
  {
    return (side % 2 == 0 ? 1 : -1) * axes.col(axisOf(side));
  }

  /** Coordinate along outward (side) of a place on the side. */
  double
  coordinate(std::size_t side) const
  {
    return outward(side).dot(origin) + sides[side].position;
  }

  Eigen::Vector3d
  size() const
  {
    return {sides[0].position + sides[1].position,
            sides[2].position + sides[3].position,
            sides[4].position + sides[5].position};
  }

  Eigen::Vector3d
  center() const
  {
    const Eigen::Vector3d twice(sides[0].position - sides[1].position,
                                sides[2].position - sides[3].position,
                                sides[4].position - sides[5].position);
    return origin + axes * twice / 2;
  }

  bool
  isSlanted() const
  {
    return count(BoxFaceKind::Slanted) > 0;
  }

  std::size_t
  count(BoxFaceKind kind) const
  {
    std::size_t sum = 0;
    for (const Side& side : sides)
      sum += side.kind == kind ? 1 : 0;
    return sum;
  }
};

} // namespace pcl::acmap::boxes
