#pragma once

#include "entropy_grid.h"
#include "map_extent.h"
#include "planar_motion.h"

#include <pcl/mapping/map_entropy_kernel.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace pcl::acmap {

/** \brief The cells of an observation as arrays, ready to be moved.
 *
 * They stand in float relative to a reference among them; all that moves is in double.
 * Neighbours in an array are far apart in the map, as a processor waits where it adds to
 * a bin that it has just written. */
class MovingCells {
public:
  /** \param[in] unit what weights are multiplied by
   * \throws BadArgumentException where a cell is not finite, has a negative weight or is
   * farther than 2e9 m */
  MovingCells(const EntropyCells& observation,
              const MapEntropySettings& settings,
              double unit);

  /** \brief Sum over the cells, times the unit. */
  double
  weight() const
  {
    return extent_.weight();
  }

  /** \brief In the sensor's frame, metres. */
  const MapExtent&
  extent() const
  {
    return extent_;
  }

  /** \brief The bins that the cells take under a pose, hardly more. */
  BinRange
  rangeUnder(const PlanarPose& pose) const;

  void
  fill(const EntropyGrid& grid, const PlanarPose& pose) const;

  /** \brief Derivatives by x, z, theta in the field that the grid holds: a metre, a
   * radian. */
  Eigen::Vector3d
  forces(const EntropyGrid& grid, const PlanarPose& pose) const;

private:
  struct Arrays {
    std::vector<float> x, z, weight, direction;

    CellArrays
    view() const;
  };

  void
  add(const EntropyCell& cell, Arrays& arrays);

  void
  setOutline();

  CellMotion
  motionUnder(const PlanarPose& pose) const;

  double bin_size_;
  double unit_;
  bool direction_aware_;
  Eigen::Vector2d reference_ = Eigen::Vector2d::Zero(); ///< metres
  Arrays plain_, directed_;
  MapExtent extent_;
  std::array<Eigen::Vector2d, 8> outline_; ///< octagon around, bins from the reference
};

} // namespace pcl::acmap
