#pragma once

#include "chain/view_levels.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief A view at reduced size: brightness, its gradient, and a point if a single
 * surface fills the pixel. */
struct AppearanceLevel {
  int width = 0, height = 0; ///< pixels of this level
  double scale = 1;          ///< size of a pixel of this level in pixels of the view
  float noise = 1;           ///< standard deviation of a value, grey levels
  std::vector<float> values; ///< grey levels
  std::vector<Eigen::Vector2f> gradients; ///< grey levels per pixel of this level
  std::vector<Eigen::Vector3f> points;    ///< metres; NaN if there is none

  /** \brief Position of a pixel of the view in this level. */
  Eigen::Vector2d
  fromView(const Eigen::Vector2d& pixel) const
  {
    return (pixel.array() + 0.5) / scale - 0.5;
  }
};

AppearanceLevel
appearanceLevel(const ViewLevel& view);

} // namespace pcl::acmap
