#pragma once

#include "entropy_grid.h"
#include "planar_motion.h"

#include <pcl/mapping/map_entropy_types.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief Determines whether the points of the map are at one position, on a line, or
 * spread in the plane. */
class MapExtent {
public:
  void
  add(const Eigen::Vector2d& place, double weight);

  /** \brief Adds an observation, transformed to the map. */
  void
  add(const MapExtent& observation, const PlanarMotion& motion);

  /** \brief Sum of all added weights. */
  double
  weight() const
  {
    return weight_;
  }

  /** \param[in] bin_size spreads below a ten-thousandth of it are considered zero */
  int
  dimensions(double bin_size) const;

private:
  double weight_ = 0;
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d sum_ = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares_ = Eigen::Matrix2d::Zero();
};

/** \brief Can the map have a grid? If not, a remark contains the reason.
 * \param[in] ranges of the observations, without margins
 * \param[in] weight of all points */
bool
canHaveGrid(const std::vector<BinRange>& ranges,
            double weight,
            const MapEntropySettings& settings,
            MapEntropyReport& report);

/** \brief Adds remarks if the entropy does not determine the poses of a map, or if
 * directions were requested but are not available. */
void
remarkOnMap(const MapEntropyTerms& terms,
            const MapEntropySettings& settings,
            MapEntropyReport& report);

/** \brief Returns the settings.
 * \throws BadArgumentException when the smoothing is wider than 100 bins */
const MapEntropySettings&
requireSmoothing(const MapEntropySettings& settings);

/** \brief Adds the numbers of observations, points and cells. */
void
addCounts(const MapEntropyReport& counts, MapEntropyReport& report);

} // namespace pcl::acmap
