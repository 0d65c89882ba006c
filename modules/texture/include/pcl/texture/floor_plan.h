#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/surface_label.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace pcl {

namespace acmap {

/** \brief Planes whose normal has at least this cosine with up or down are level, those with less
 * than the other are upright. */
inline constexpr double level_cosine = 0.98, upright_cosine = 0.2; // 11 degrees each

} // namespace acmap

/** \brief A straight piece of a wall in a floor plan, metres, in the frame of the plan.
 * \ingroup texture */
struct PlanWall {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero(); ///< the seen side is on the left
  std::size_t plane = 0;                        ///< index in the map
  /** \brief Wall, or Furniture or DoorLeaf for what is no wall but as high. */
  SurfaceRole role = SurfaceRole::Wall;
};

/** \brief An opening of a wall, metres. \ingroup texture */
struct PlanOpening {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero(); ///< the wall's seen side is on the left
  std::size_t plane = 0;                        ///< of the wall, index in the map
  bool is_window = false; ///< the wall continues below it; else a door or a passage
  double bottom = 0;      ///< above the floor, in its middle; 0 for a door
  double top = std::numeric_limits<double>::quiet_NaN(); ///< NaN: no wall above it
  /** \brief Distance from the seen side back to a leaf that closes it; NaN: none was seen. */
  double leaf = std::numeric_limits<double>::quiet_NaN();
  /** \brief Index of the room in front of the wall, and of the one behind it, or -1. */
  std::array<std::int32_t, 2> rooms{-1, -1};
};

/** \brief Furniture below the section, seen from above, metres. \ingroup texture */
struct PlanFurniture {
  std::vector<Eigen::Vector2d> outline;
  double top = 0; ///< above the floor
};

/** \brief A column or a curved wall where the section cuts it, metres. \ingroup texture */
struct PlanColumn {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0;
  double begin = 0;       ///< of the part that was seen, radians from the x axis
  double end = 0;         ///< counter-clockwise from begin
  bool is_hollow = false; ///< seen from inside
};

/** \brief Space between walls and openings. \ingroup texture */
struct PlanRoom {
  std::string name; ///< of the room of the map; empty: not named
  Eigen::Vector2d center = Eigen::Vector2d::Zero(); ///< inside, far from its border

  /** \brief Square metres, with what is enclosed by its floor and its walls, such as
   * the floor below furniture. */
  double area = 0;
  double seen_area = 0; ///< square metres, of the map's floor

  /** \brief Its border without what is inside of it, counter-clockwise; from cells of 2 cm,
   * or 4000 along the longer side of the floor, with corners within 1.5 of these. */
  std::vector<Eigen::Vector2d> outline;

  /** \brief Indices in the map of the planes that enclose it, ascending: walls whose
   * seen side is towards it along 10 cm, floors and ceilings with 0.3 square metres in it,
   * seen from above. */
  std::vector<std::size_t> planes;
};

/** \brief A section of a map above its floor, seen from above. Metres.
 *
 * A point p of the map is at (p . x_axis, p . y_axis) of the plan, at the height p . up.
 * \ingroup texture */
struct FloorPlan {
  Eigen::Vector3d x_axis = Eigen::Vector3d::UnitX();
  Eigen::Vector3d y_axis = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d up = -Eigen::Vector3d::UnitY();
  /** \brief CompactMap::shift of the map: files have the coordinates of its input. */
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  double floor = 0; ///< height of the floor
  double cut = 0;   ///< height of the section
  std::vector<PlanWall> walls;
  /** \brief Where walls continue that were not seen at the section, but above or below it, or
   * where their plane is probably (PlanePatch::proposed). */
  std::vector<PlanWall> unseen_walls;
  std::vector<PlanOpening> openings;
  std::vector<PlanRoom> rooms; ///< by decreasing area
  std::vector<PlanFurniture> furniture;
  std::vector<PlanColumn> columns;

  /** \brief Loops of the floor's polygons; a point is on the floor if it is inside of an
   * odd number of the loops of one polygon. */
  std::vector<std::vector<std::vector<Eigen::Vector2d>>> floors;

  /** \brief Where a point, or a direction, of the map is in the plan. */
  Eigen::Vector2d
  placeOf(const Eigen::Vector3d& point) const
  {
    return {point.dot(x_axis), point.dot(y_axis)};
  }

  /** \brief Height of a point of the map above the floor, metres. */
  double
  heightOf(const Eigen::Vector3d& point) const
  {
    return point.dot(up) - floor;
  }

  /** \brief The point of the map above a place of the plan.
   * \param[in] height above the floor, metres */
  Eigen::Vector3d
  pointAt(const Eigen::Vector2d& place, double height) const
  {
    return place.x() * x_axis + place.y() * y_axis + (floor + height) * up;
  }
};

/** \brief Makes a floor plan from the polygons of a map.
 *
 * The x axis is that of the map, projected; if most walls are at right angles, both axes
 * are turned by up to 45 degrees, so that walls are along them. The axes of a map with a
 * shift are not turned, and are those of its input, so that a file can have coordinates of
 * a national grid.
 *
 * The floor is the lowest level plane that faces up and has at least half of the largest
 * area of these, with all such planes within 30 cm. The section is 1.5 m above it, or at 60 % of the height to the ceiling if
 * this is less: above tables, below the heads of doors. Walls are where the section cuts
 * polygons of upright planes. A gap in the section of a plane from 0.4 to 4 m wide, between
 * two pieces of it or from its end to the next wall, is an opening if the plane continues
 * above or below it, and no other wall is within a metre in front of it: that would be a
 * piece of furniture that hides the wall. A window is level: its sill, and its head if it has
 * one, change by at most 10 cm along it, which the end of what was seen does not. Rooms are the parts
 * of the floor between walls and openings of which at least a square metre was seen. The
 * room beside a wall or an opening is the first within 0.6 m from its middle, unless a
 * wall is before it. Ceilings are planes that face down and reach above the section.
 * Without a floor there are no rooms, and the lowest corner of a wall is the floor's
 * height.
 *
 * Takes the time of filling the floor with cells of 2 cm, or 4000 along its longer side.
 * \param[in] map its planes and trajectory; see \ref upDirection. Polygons that are not
 * finite are left out.
 * \return an empty plan for a map without upright and level planes \ingroup texture */
ACMAP_EXPORT FloorPlan
makeFloorPlan(const CompactMap& map);

/** \brief Gives a map the graph of rooms of its floor plan, CompactMap::rooms and
 * CompactMap::openings, instead of the one it has. Openings of the two faces of a wall, up
 * to 0.6 m apart, become one.
 * \param[in] plan from \ref makeFloorPlan for this map \ingroup texture */
ACMAP_EXPORT void
setRooms(const FloorPlan& plan, CompactMap& map);

/** \brief Writes a floor plan.
 *
 * The ending of the path chooses the format. `.svg`, `.png` and `.dxf` are the same drawing:
 * walls, filled between faces of both sides up to 0.6 m apart; doors with what their leaf
 * sweeps, whose side is assumed; windows, furniture, names and areas of rooms, dimensions
 * between the seen faces, a legend, a scale bar, and the direction of a horizontal axis of the
 * map (z, or y where z is up). It is made for the largest scale of 1 : 50, 100, 200, 500 and so
 * on that fits A3. `.svg`: SVG 1.1 in millimetres of the paper. `.png`: 6 pixels for each of
 * these, drawn without a display. `.dxf`: ASCII DXF of release 12, metres, layers FLOOR,
 * FURNITURE, WALLS, WINDOWS, DOORS, ROOMS, DIMENSIONS, NORTH and TITLE. `.geojson`: GeoJSON of
 * the plan itself, whose coordinates are metres in the frame of the plan, and no longitudes;
 * each feature has a property `kind`, and walls and openings the number of their plane. The
 * shift of the plan is added to the coordinates in DXF and GeoJSON; SVG names it.
 * \throws BadArgumentException for another ending
 * \throws OutputFileException when the file could not be written \ingroup texture */
ACMAP_EXPORT void
saveFloorPlan(const std::string& path, const FloorPlan& plan);

} // namespace pcl
