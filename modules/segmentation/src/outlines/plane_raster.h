#pragma once

#include "outlines/cell_set.h"
#include "outlines/loop.h"
#include "planes/known_planes.h"

#include <Eigen/Geometry>

namespace pcl::acmap::outlines {

class SightRays;

/** The grid of cells on a plane, and what is known about its cells. Places are in cells:
 * cell (x, y) covers [x, x + 1) x [y, y + 1). */
struct PlaneRaster {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0; ///< normal . p + offset = 0
  /** Corner of cell (0, 0), and the unit axes; u, v and the normal are right-handed. */
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_u = Eigen::Vector3d::UnitX();
  Eigen::Vector3d axis_v = Eigen::Vector3d::UnitY();
  double cell = 0;         ///< edge length of a cell, metres
  Eigen::AlignedBox3d box; ///< of the points on the plane

  CellSet seen;                            ///< covered by the surface
  std::vector<Eigen::Vector2d> rim_points; ///< corners of faces near the end of these
  bool are_rays =
      false;       ///< the rim points are places where rays meet the plane instead
  CellSet free;    ///< a sensor looked through
  CellSet barrier; ///< beyond a crease

  Eigen::Vector2d
  placeOf(const Eigen::Vector3d& point) const
  {
    const Eigen::Vector3d way = point - origin;
    return Eigen::Vector2d(way.dot(axis_u), way.dot(axis_v)) / cell;
  }

  Eigen::Vector3d
  pointAt(const Eigen::Vector2d& place) const
  {
    return origin + cell * (place.x() * axis_u + place.y() * axis_v);
  }
};

/** Adds the cells whose centres are inside of loops, by the even-odd rule. */
void
fillLoops(const std::vector<Loop>& loops, CellSet& cells);

/** The rasters of all planes, with cells of half a spacing. Each has an axis along the
 * direction in which most of its neighbours cross it.
 * \return rasters in the order of the planes; one without cells where the plane would
 * need more than 2^28 of them */
std::vector<PlaneRaster>
rastersOf(const KnownPlanes& known);

/** Marks the cells covered by the faces of the planes: those with three corners on the
 * plane, or with two where the third is on no plane and nearly on this one. Sets the
 * points near rims. */
void
addFaces(const TriangleMesh::Triangles& triangles,
         const KnownPlanes& known,
         std::vector<PlaneRaster>& rasters);

/** Marks the cells through which sensors saw points well behind the planes. */
void
addFreeRays(const KnownPlanes& known,
            const SightRays& rays,
            std::vector<PlaneRaster>& rasters);

} // namespace pcl::acmap::outlines
