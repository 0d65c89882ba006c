#pragma once

#include "drawing.h"

#include <Eigen/Geometry>

#include <vector>

namespace pcl::acmap {

/** \brief The part of the xz plane that a plan shows, x to the right and z upwards. */
struct PlanExtent {
  Eigen::Vector2d least = Eigen::Vector2d::Zero(); ///< x, z; metres
  double pixel = 1;                                ///< metres
  int width = 1, height = 1;                       ///< pixels

  /** \brief Column and row of a point. */
  Eigen::Vector2d
  pixelOf(const Eigen::Vector3d& in_map) const
  {
    return {(in_map.x() - least.x()) / pixel,
            height - 1 - (in_map.z() - least.y()) / pixel};
  }
};

/** \brief Collects the contents of plans, so that plans with the same extent can be
 * compared. */
class PlanContents {
public:
  /** \brief Adds a point. The extent ignores the outermost points. */
  void
  addPoint(const Eigen::Vector3d& in_map);

  /** \brief Adds a position that is always in the extent, unless it is farther than 1e9
   * m or not finite. */
  void
  addPlace(const Eigen::Vector3d& in_map);

  PlanExtent
  extent() const;

private:
  std::vector<float> x_, z_;
  Eigen::AlignedBox2d places_; ///< x, z
};

/** \brief Draws a scale bar of a round length into the lower left corner, labelled in
 * metres.
 * \param[in] pixel metres */
void
drawScaleBar(RgbImage& image, double pixel);

} // namespace pcl::acmap
