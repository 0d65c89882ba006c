#pragma once

#include <pcl/core/image_file.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/trajectory.h>

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

/** \brief What is known of a texel. \ingroup core */
enum class TexelKind : std::uint8_t {
  None = 0,  ///< no observation saw it
  Seen = 1,  ///< coloured by observations
  Filled = 2 ///< coloured after its neighbours
};

/** \brief All three channels of a texel of which nothing is known. \ingroup core */
inline constexpr std::uint8_t unknown_grey = 128;

/** \brief The texture of a rectangle on a plane that covers one of its polygons, or a part
 * of it where the polygon is larger than a texture may be.
 *
 * Texel (i, j), column i of row j, covers origin + i * texel_u + j * texel_v and one step
 * further each way. \ingroup core */
struct TextureChart {
  std::size_t plane = 0;   ///< of the map
  std::size_t polygon = 0; ///< of the plane
  Eigen::Vector3d origin =
      Eigen::Vector3d::Zero(); ///< outer corner of texel (0, 0), map
  Eigen::Vector3d texel_u = Eigen::Vector3d::Zero(); ///< one column further, metres
  Eigen::Vector3d texel_v = Eigen::Vector3d::Zero(); ///< one row further, metres
  RgbImage colors;
  std::vector<TexelKind> kinds; ///< one a texel, rows from the top
  std::string image;            ///< name of its file beside the map; empty for none
  std::string kinds_image;      ///< the same of the kinds; empty where all are seen
};

/** \brief What is left of millions of points: a few textured planes. \ingroup core */
struct CompactMap {
  std::vector<PlanePatch> planes;
  std::vector<TextureChart> charts;

  /** \brief For each plane the observations that saw it, ascending; empty where that is
   * not known. Their numbers are those of the poses. */
  std::vector<std::vector<std::int32_t>> observations;
  Trajectory trajectory; ///< T_map_camera of the observations; may be empty
};

} // namespace pcl
