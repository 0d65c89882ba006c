#pragma once

#include "drawing.h"

#include <Eigen/Geometry>

#include <vector>

namespace pcl::acmap {

/** \brief What of the XZ plane a plan shows, x to the right and z upwards. */
struct PlanExtent {
  Eigen::Vector2d least = Eigen::Vector2d::Zero(); ///< x, z; metres
  double pixel = 1;                                ///< metres
  int width = 1, height = 1;                       ///< pixels

  /** \brief Column and row of a place. */
  Eigen::Vector2d
  pixelOf(const Eigen::Vector3d& in_map) const
  {
    return {(in_map.x() - least.x()) / pixel,
            height - 1 - (in_map.z() - least.y()) / pixel};
  }
};

/** \brief What plans that are to be compared show. */
class PlanContents {
public:
  /** \brief Adds points, of which the extent leaves out the few outermost ones. */
  void
  addPoint(const Eigen::Vector3d& in_map);

  /** \brief Adds a place that is always shown, unless it is 1e9 m off or not finite. */
  void
  addPlace(const Eigen::Vector3d& in_map);

  PlanExtent
  extent() const;

private:
  std::vector<float> x_, z_;
  Eigen::AlignedBox2d places_; ///< x, z
};

/** \brief Draws a bar of a round length into the lower left corner, with its metres.
 * \param[in] pixel metres */
void
drawScaleBar(RgbImage& image, double pixel);

} // namespace pcl::acmap
