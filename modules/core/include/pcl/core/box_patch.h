#pragma once

#include <pcl/core/build_config.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>

namespace pcl {

/** \brief How the position of a side of a box is known. \ingroup core */
enum class BoxFaceKind : std::uint8_t {
  Free,    ///< not seen: it is where the seen faces end
  Seen,    ///< a plane of the map lies in it
  Snapped, ///< not seen: the box stands on a plane of the map, or leans against it
  Slanted ///< a plane of the map cuts the box there, at another angle; one side at most
};

namespace acmap {

/** \brief The names of \ref BoxFaceKind in files and in Python. */
inline constexpr std::array<const char*, 4> box_face_kind_names{
    "free", "seen", "snapped", "slanted"};

} // namespace acmap

/** \brief A side of a box. \ingroup core */
struct BoxFace {
  BoxFaceKind kind = BoxFaceKind::Free;
  std::int32_t plane = -1; ///< number of the plane; -1 for a free side
};

/** \brief A box that stands for planes at right angles: furniture, a crate, a pillar.
 * \ingroup core */
struct BoxPatch {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< metres

  /** \brief Unit directions of the edges, in the columns; right-handed. */
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();

  /** \brief Lengths along the axes, metres. They decrease, except that all boxes of one
   * template have the order of its first box. */
  Eigen::Vector3d size = Eigen::Vector3d::Zero();

  /** \brief The sides at the ends of the axes, in the order +x, -x, +y, -y, +z, -z. */
  std::array<BoxFace, 6> faces;

  /** \brief The plane of the slanted side as (unit normal, offset), metres: of the
   * cuboid, the box is the part where normal * x + offset <= 0. The cuboid ends where
   * this part reaches furthest. 0 without a slanted side. */
  Eigen::Vector4d slant = Eigen::Vector4d::Zero();

  /** \brief Covariance of (turn about each of the axes, shift of the center along each
   * of them, size), radians and metres. It includes what a map does not tell of its
   * planes: a millimetre and a milliradian. */
  Eigen::Matrix<double, 9, 9> covariance = Eigen::Matrix<double, 9, 9>::Zero();

  /** \brief Boxes of the same number have the same size: it was fitted to all of them.
   */
  std::int32_t template_id = 0;

  /** \brief Bits by which it shortens the description of its planes. */
  double saved_bits = 0;

  std::string name; ///< such as "Box in room 1"; empty: not named
};

} // namespace pcl
