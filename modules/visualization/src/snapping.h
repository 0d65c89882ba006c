#pragma once

#include "map_lines.h"

#include <functional>
#include <vector>

namespace pcl::acmap {

/** \brief A corner or a place on an edge next to a pixel. */
struct SnapPlace {
  Eigen::Vector3d point; ///< metres
  std::size_t surface;   ///< as the plane in MapLine
};

/** \brief A pixel of a picture, and what is seen in it. */
struct PixelRay {
  Eigen::Vector2d pixel; ///< column and row
  Eigen::Vector3d eye;
  Eigen::Vector3d direction;
};

/** \brief The corners near a pixel, the nearest first, and then the places on edges. A
 * corner turns by more than 30 degrees.
 * \param[in] outlines closed ones
 * \param[in] pixel_of column, row and depth of a place: 0 at the near plane to 1 */
std::vector<SnapPlace>
snapPlaces(const std::vector<MapLine>& outlines,
           const PixelRay& ray,
           const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& pixel_of);

} // namespace pcl::acmap
