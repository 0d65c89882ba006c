#pragma once

#include "outlines/plane_raster.h"

#include <array>

namespace pcl::acmap::outlines {

/** A part of the common line of two planes along which one of them ends. */
struct CreaseSpan {
  double from = 0, to = 0; ///< metres along the crease
  int side = 1;      ///< side of the line on which the plane is, see CreaseLine::normal
  bool joint = true; ///< does the other plane begin there too? Else it goes on alone
  bool contact = false; ///< the other plane continues on both sides
};

/** The common line of two planes as seen in the raster of one of them, in cells. */
struct CreaseLine {
  Eigen::Vector2d origin, direction; ///< place at 0 m, and unit direction
  Eigen::Vector2d normal;            ///< unit; towards side 1
  double cells_per_metre = 0;

  Eigen::Vector2d
  at(double along) const
  {
    return origin + along * cells_per_metre * direction;
  }

  double
  along(const Eigen::Vector2d& place) const
  {
    return (place - origin).dot(direction) / cells_per_metre;
  }

  double
  distance(const Eigen::Vector2d& place) const
  {
    return (place - origin).dot(normal);
  }
};

/** The common line of two planes. */
struct Crease {
  std::array<std::size_t, 2> planes; ///< ascending
  Eigen::Vector3d point, direction;  ///< position at 0 m, and unit direction
  double sine = 0;                   ///< of the angle between the planes
  std::array<CreaseLine, 2> lines;
  std::array<std::vector<CreaseSpan>, 2> spans; ///< of each plane, by their beginning

  std::size_t
  sideOf(std::size_t plane) const
  {
    return planes[0] == plane ? 0 : 1;
  }
};

/** The parts of the common lines of planes where the evidence shows that one of them, or
 * both, end there. */
struct Creases {
  std::vector<Crease> creases;
  std::vector<std::vector<std::size_t>> of_planes; ///< numbers of the creases of each
};

/** Finds the creases of planes: along the common line of two planes, the evidence beside
 * it tells on which sides each of them is. Where each is on one side only, they end in a
 * crease; where one of them is on both sides, the other ends on it. Beyond, each plane
 * goes on alone along the line while its own evidence does, unless it has another crease
 * nearby in the same direction. */
Creases
creasesOf(const KnownPlanes& known, const std::vector<PlaneRaster>& rasters);

/** Where a crease meets a third plane, metres along the crease; NaN where they are
 * nearly parallel. */
double
meetingOf(const Crease& crease, const PlaneRaster& third);

} // namespace pcl::acmap::outlines
