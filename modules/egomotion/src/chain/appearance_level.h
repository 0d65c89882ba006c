#pragma once

#include "chain/view_levels.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief A view at a part of its size: brightness, how it changes, and a point where a
 * surface fills the pixel. */
struct AppearanceLevel {
  int width = 0, height = 0; ///< pixels of this level
  double scale = 1;          ///< pixels of the view across one of these
  float noise = 1;           ///< grey levels, standard deviation of a value
  std::vector<float> values; ///< grey levels
  std::vector<Eigen::Vector2f> gradients; ///< grey levels a pixel of this level
  std::vector<Eigen::Vector3f> points;    ///< metres; NaN where there is none

  /** \brief Where a pixel of the view lies in this level. */
  Eigen::Vector2d
  fromView(const Eigen::Vector2d& pixel) const
  {
    return (pixel.array() + 0.5) / scale - 0.5;
  }
};

AppearanceLevel
appearanceLevel(const ViewLevel& view);

} // namespace pcl::acmap
