#pragma once

#include "entropy_grid.h"
#include "map_extent.h"
#include "planar_motion.h"

#include <pcl/mapping/impl/map_entropy_kernel.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace pcl::acmap {

/** \brief The cells of an observation as arrays, prepared for transformation.
 *
 * They are stored as floats relative to a reference cell; transformations are computed
 * in double precision. Neighbours in an array are far apart in the map, because a
 * processor stalls when it adds to a bin that it has just written. */
class MovingCells {
public:
  /** \param[in] unit factor of the weights
   * \throws BadArgumentException when a cell is not finite, has a negative weight or is
   * farther away than 2e9 m */
  MovingCells(const EntropyCells& observation,
              const MapEntropySettings& settings,
              double unit);

  /** \brief Sum of the weights of the cells, times the unit. */
  double
  weight() const
  {
    return extent_.weight();
  }

  /** \brief Extent in the sensor's frame, metres. */
  const MapExtent&
  extent() const
  {
    return extent_;
  }

  /** \brief A tight range of the bins of the cells under a pose. */
  BinRange
  rangeUnder(const PlanarPose& pose) const;

  void
  fill(const EntropyGrid& grid, const PlanarPose& pose) const;

  /** \brief Derivatives by x, z and theta in the field that the grid contains, per
   * metre and per radian. */
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
  std::array<Eigen::Vector2d, 8> outline_; ///< octagon in bins from the reference
};

} // namespace pcl::acmap
