#pragma once

#include "entropy_grid.h"
#include "planar_motion.h"

#include <pcl/mapping/map_entropy_types.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief Tells whether points of the map lie in one place, on a line, or apart. */
class MapExtent {
public:
  void
  add(const Eigen::Vector2d& place, double weight);

  /** \brief Adds an observation, moved into the map. */
  void
  add(const MapExtent& observation, const PlanarMotion& motion);

  /** \brief Sum over all that was added. */
  double
  weight() const
  {
    return weight_;
  }

  /** \param[in] bin_size a ten thousandth of it counts as none */
  int
  dimensions(double bin_size) const;

private:
  double weight_ = 0;
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d sum_ = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares_ = Eigen::Matrix2d::Zero();
};

/** \brief Can the map have a grid? If not a remark says why.
 * \param[in] ranges of the observations, without margins
 * \param[in] weight of all points together */
bool
canHaveGrid(const std::vector<BinRange>& ranges,
            double weight,
            const MapEntropySettings& settings,
            MapEntropyReport& report);

/** \brief Remarks on maps whose poses the entropy does not determine, and on directions
 * that were asked for and are not to be had. */
void
remarkOnMap(const MapEntropyTerms& terms,
            const MapEntropySettings& settings,
            MapEntropyReport& report);

/** \throws BadArgumentException when the smoothing is wider than 100 bins */
void
requireSmoothing(const MapEntropySettings& settings);

} // namespace pcl::acmap
