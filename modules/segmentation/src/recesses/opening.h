#pragma once

#include "boxes/piece.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace pcl::acmap::recesses {

/** Where a wall begins on one side of an opening. */
struct OpeningEnd {
  /** Median distance from the origin of the opening, metres. */
  double at = std::numeric_limits<double>::infinity();
  double spread = 0; ///< metres; half of the lines end within it
  double share = 0;  ///< of the lines that meet the wall
};

/** A rectangle in a wall, before a leaf. */
class Opening {
public:
  /** \param[in] leaf behind the wall
   * \param[in] up of length 1; the wall is not horizontal */
  Opening(const boxes::Piece& leaf,
          const boxes::Piece& wall,
          const Eigen::Vector3d& up);

  /** In the plane of the wall, before the middle of the leaf. */
  const Eigen::Vector3d&
  origin() const
  {
    return origin_;
  }

  /** Width, height, normal of the wall. */
  const Eigen::Matrix3d&
  axes() const
  {
    return axes_;
  }

  /** Distance of the leaf behind the wall, metres; negative if it is before it. */
  double
  depth() const
  {
    return depth_;
  }

  /** Where the wall ends on one side, on lines beside each other before the leaf.
   * \param[in] wall its pieces
   * \param[in] side as in recess_sides.h */
  OpeningEnd
  findEnd(const std::vector<boxes::Piece>& wall, std::size_t side) const;

  /** The part of a piece before, in or behind the opening.
   * \param[in] margin by which the opening is larger, metres */
  boxes::Piece
  within(boxes::Piece piece, double margin) const;

  /** Least and greatest coordinate of a piece along an axis, from the origin. */
  std::pair<double, double>
  rangeOf(const boxes::Piece& piece, Eigen::Index axis) const;

  double
  width() const;

  double
  height() const;

  std::array<double, 4> ends{}; ///< of its sides: distances from the origin, metres

private:
  Eigen::Vector3d
  outward(std::size_t side) const;

  double
  firstEdge(const std::vector<boxes::Piece>& wall,
            const Eigen::Vector3d& from,
            const Eigen::Vector3d& direction,
            const Eigen::Vector3d& across) const;

  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes_;
  Eigen::Vector2d half_leaf_ = Eigen::Vector2d::Zero(); ///< half of its extent
  double depth_ = 0;
};

} // namespace pcl::acmap::recesses
