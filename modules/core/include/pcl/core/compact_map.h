#pragma once

#include <pcl/core/box_patch.h>
#include <pcl/core/cylinder_patch.h>
#include <pcl/core/image_file.h>

#include <pcl/core/map_details.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/recess_patch.h>
#include <pcl/core/surface_label.h>
#include <pcl/core/trajectory.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief Origin of the colour of a texel. \ingroup core */
enum class TexelKind : std::uint8_t {
  None = 0,  ///< not seen by any observation
  Seen = 1,  ///< coloured by observations
  Filled = 2 ///< filled in from its neighbours
};

/** \brief Value of all three channels of a texel without a colour. \ingroup core */
inline constexpr std::uint8_t unknown_grey = 128;

/** \brief The colours of a part of a surface, and where they are in the files of a map.
 * \ingroup core */
struct TexturePicture {
  RgbImage colors;
  std::vector<TexelKind> kinds; ///< one per texel, rows from the top

  /** \brief Name of the file beside the map with its colours; empty if there is none. */
  std::string image;
  /** \brief Column and row in this file of its first texel; nothing if the file has no
   * other texels. */
  std::optional<Eigen::Vector2i> image_place;
  /** \brief How often width and height are halved in this file, rounded up. */
  std::int32_t halvings = 0;
  /** \brief Name of the file of the kinds; empty if all are Seen. */
  std::string kinds_image;
  std::optional<Eigen::Vector2i> kinds_place; ///< as image_place; never halved
};

/** \brief The texture of a rectangle on a plane that covers one of its polygons, or a
 * part of it if the polygon is larger than the maximum size of a texture.
 *
 * Texel (i, j), column i of row j, covers the parallelogram that begins at
 * origin + i * texel_u + j * texel_v and is spanned by texel_u and texel_v.
 * \ingroup core */
struct TextureChart : TexturePicture {
  std::size_t plane = 0;   ///< index in the map
  std::size_t polygon = 0; ///< index in the plane
  /** \brief Outer corner of texel (0, 0), in the map frame. */
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d texel_u = Eigen::Vector3d::Zero(); ///< step of one column, metres
  Eigen::Vector3d texel_v = Eigen::Vector3d::Zero(); ///< step of one row, metres
};

/** \brief Kind of an opening in a wall. \ingroup core */
enum class OpeningKind : std::uint8_t {
  Door = 0,  ///< a door or a passage
  Window = 1 ///< the wall continues below it
};

namespace acmap {

/** \brief The names of \ref OpeningKind in files and in Python. */
inline constexpr std::array<const char*, 2> opening_kind_names{"door", "window"};

} // namespace acmap

/** \brief An opening of a wall, from floor to floor of the rooms that it joins. Metres.
 * \ingroup core */
struct MapOpening {
  /** \brief Its sides on the floor, in the map frame. The wall is seen from the left. */
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  double bottom = 0;                                     ///< above the floor
  double top = std::numeric_limits<double>::quiet_NaN(); ///< NaN: not seen
  OpeningKind kind = OpeningKind::Door;
  /** \brief The wall, and the other face of a wall seen from both sides, or -1. */
  std::array<std::int32_t, 2> planes{-1, -1};
  /** \brief In front of the first plane and behind it; -1: outside, or not seen. */
  std::array<std::int32_t, 2> rooms{-1, -1};
  SurfaceLabel label{}; ///< its size: width and height
};

/** \brief Free space that planes and openings enclose. \ingroup core */
struct MapRoom {
  /** \brief On the floor, far from the walls, metres in the map frame. */
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double area = 0;      ///< square metres of floor, with what walls and floor enclose
  double seen_area = 0; ///< square metres of the map's floor
  /** \brief Floors, walls and ceilings that enclose it, ascending. */
  std::vector<std::int32_t> planes;
  std::vector<std::int32_t> openings; ///< those that lead into it, ascending
  SurfaceLabel label{}; ///< its size: sides of the smallest rectangle around it
};

/** \brief A map of textured planes that replaces a point cloud. \ingroup core */
struct CompactMap {
  std::vector<PlanePatch> planes;
  std::vector<TextureChart> charts;

  /** \brief Columns, pipes and curved walls, by decreasing area. The planes for which they
   * stand are not in the map. Empty unless cylinders were searched
   * (\ref PlaneMapping::setComputeCylinders). */
  std::vector<CylinderPatch> cylinders;

  /** \brief The texture of each cylinder, unrolled: the columns divide its arc, from left
   * to right as it was seen with axis_direction upwards, and the rows divide its extent
   * from high to low (\ref unrolledCorners). One for each cylinder, without texels if it
   * has no colours; or empty. */
  std::vector<TexturePicture> cylinder_pictures;

  /** \brief Furniture, crates and pillars, by decreasing volume. Their sides stay among
   * the planes, with their charts. Empty unless boxes were searched
   * (\ref PlaneMapping::setComputeBoxes). */
  std::vector<BoxPatch> boxes;

  /** \brief Closed doors, windows and niches, by decreasing volume. Wall and leaf stay
   * among the planes. Empty unless boxes were searched. */
  std::vector<RecessPatch> recesses;

  /** \brief For each plane the observations that saw it, in ascending order; empty if
   * unknown. An observation is given by the index of its pose. */
  std::vector<std::vector<std::int32_t>> observations;
  Trajectory trajectory; ///< T_map_camera of the observations; may be empty

  /** \brief The up direction in the map frame, of length 1; zero if unknown: then
   * \ref upAxis and \ref upDirection estimate it. */
  Eigen::Vector3d up = Eigen::Vector3d::Zero();

  /** \brief What is taken for the up direction where it is unknown, of length 1; zero:
   * \ref upAxis guesses. */
  Eigen::Vector3d assumed_up = Eigen::Vector3d::Zero();

  /** \brief What was subtracted from the coordinates of the input, metres: added to those of
   * the map, it gives coordinates in the frame of the input, such as a national grid
   * (\ref PointCloudFile::shift). */
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();

  /** \brief Factor of the colours in files and pictures of the map, so that these are
   * neither dark nor overexposed; the colours of the charts are those of the input. */
  double exposure = 1;

  /** \brief The graph of rooms: rooms by decreasing area, and what joins them. Empty
   * unless setRooms was called. */
  std::vector<MapRoom> rooms;
  std::vector<MapOpening> openings;

  /** \brief What is on none of its surfaces; written to map.glb, and not read again. */
  MapDetails details;
};

} // namespace pcl
