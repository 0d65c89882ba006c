#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/surface_label.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {

/** \brief What is beyond an edge of a polygon. \ingroup core */
enum class EdgeKind : std::uint8_t {
  Open,     ///< not told: the sensors are unknown
  Crease,   ///< another plane begins, and its polygon has the same edge
  Contact,  ///< the plane ends on another one that continues on both sides
  Rim,      ///< nothing: sensors looked past it (an occluding edge)
  Frontier, ///< not seen
  Arc       ///< a cylinder begins
};

namespace acmap {

/** \brief The names of \ref EdgeKind in files and in Python. */
inline constexpr std::array<const char*, 6> edge_kind_names{
    "open", "crease", "contact", "rim", "frontier", "arc"};

} // namespace acmap

/** \brief An edge of a polygon. \ingroup core */
struct PolygonEdge {
  EdgeKind kind = EdgeKind::Open;
  /** \brief Plane of a crease or contact, cylinder of an arc; otherwise -1. */
  std::int32_t neighbour = -1;
};

/** \brief A polygon in space, metres. Its outer boundary is counter-clockwise and its
 * holes are clockwise, as seen from the side to which the normal of the plane points.
 * \ingroup core */
struct PlanePolygon {
  std::vector<Eigen::Vector3f> outer;
  std::vector<std::vector<Eigen::Vector3f>> holes;
  /** \brief One for each point, of the outer boundary first, then of each hole: that to
   * the next point. Empty if the polygon has no known neighbours. */
  std::vector<PolygonEdge> edges{};
};

/** \brief A plane of a building with its attributes. \ingroup core */
struct PlanePatch {
  /** \brief Unit normal, towards the side from which it was seen, and offset:
   * a x + b y + c z + d = 0, metres. */
  Eigen::Vector4d coefficients = Eigen::Vector4d::Zero();

  /** \brief Centroid of the support, on the plane, and two axes in the plane: the frame
   * of the covariance. axis_u, axis_v and the normal are a right-handed basis. */
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_u = Eigen::Vector3d::UnitX();
  Eigen::Vector3d axis_v = Eigen::Vector3d::UnitY();

  /** \brief Covariance of (slope along axis_u, slope along axis_v, offset along the
   * normal at the centre); radians and metres. NaN if the support is too small to
   * estimate it. */
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

  std::size_t support = 0; ///< number of points
  double effective_support =
      0; ///< number of independent points; NaN like the covariance
  /** \brief Root mean square distance of the support to the plane, metres. */
  double rms = 0;
  double area = 0; ///< square metres, of the polygons
  std::vector<PlanePolygon> polygons;

  /** \brief Where the plane probably continues, although it was not seen there: behind
   * furniture, enclosed by its own outline and its creases. No sensor looked through.
   * Without edges; part of no area. */
  std::vector<PlanePolygon> proposed{};

  /** \brief What the poses add to its errors, in common with other planes: entry k of each plane is
   * by how much (slope along axis_u, slope along axis_v, offset) change together, by one standard
   * deviation of the k-th independent error. The covariance includes them. Empty: not known, as
   * for a single cloud. */
  std::vector<Eigen::Vector3d> pose_modes{};

  SurfaceLabel label; ///< what it is in its building, once the map has rooms
};

} // namespace pcl
