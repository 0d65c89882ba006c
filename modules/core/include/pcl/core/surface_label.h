#pragma once

#include <pcl/core/build_config.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <limits>
#include <string>

namespace pcl {

/** \brief What a surface is in a building. \ingroup core */
enum class SurfaceRole : std::uint8_t {
  Other,     ///< none of these, or not known
  Floor,     ///< a level surface on which one stands
  Ceiling,   ///< a level surface that closes a room above
  Wall,      ///< an upright surface that bounds a room
  DoorLeaf,  ///< a closed door in its recess
  Furniture, ///< a side of what stands in a room
};

namespace acmap {

/** \brief The names of \ref SurfaceRole in files and in Python. */
inline constexpr std::array<const char*, 6> surface_role_names{
    "other", "floor", "ceiling", "wall", "door leaf", "furniture"};

} // namespace acmap

/** \brief What people call a part of a map. \ingroup core */
struct SurfaceLabel {
  std::string name; ///< such as "Wall of room 2", UTF-8; empty: not named
  SurfaceRole role = SurfaceRole::Other;

  /** \brief Width and height of what is upright, otherwise the longer and the shorter side
   * of the smallest rectangle around it; diameter and length of a cylinder. Metres; NaN: not
   * known. */
  Eigen::Vector2d size =
      Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
};

} // namespace pcl
