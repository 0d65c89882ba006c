#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Maximum number of texels of a chart, and of all charts of a map together.
 * \ingroup core */
constexpr std::int64_t maximum_texels = std::int64_t{1} << 28;

/** \brief Describes what is wrong with the rectangle of a chart; empty if it is valid.
 * A valid rectangle has 1 to 2^28 texels, a finite origin, texels with sides of 1e-6 m
 * to 1e3 m, and an area above a thousandth of the product of the sides. \ingroup core
 */
ACMAP_EXPORT std::string
faultOfFrame(const TextureChart& chart);

/** \brief A point of a plane and its position in a chart. \ingroup core */
struct ChartCorner {
  Eigen::Vector3d point; ///< metres
  /** \brief Column and row in texels, from the outer corner of texel (0, 0). */
  Eigen::Vector2d place;
};

/** \brief Clips triangles to the rectangle of a chart. \ingroup core */
class ACMAP_EXPORT ChartClip {
public:
  /** \param[in] chart for which \ref faultOfFrame is empty; its colours are not used */
  explicit ChartClip(const TextureChart& chart);

  /** \brief Clips a triangle to the rectangle of the chart. Returns a convex polygon
   * with the same orientation, or an empty one if they do not overlap. Edges that two
   * triangles share are cut at the same points. Parts that are outside by less than
   * 0.01 texels are kept. */
  std::vector<ChartCorner>
  clipped(const std::array<Eigen::Vector3d, 3>& triangle) const;

private:
  Eigen::Vector3d origin_;
  Eigen::Matrix<double, 2, 3> to_place_; ///< metres to texels
  Eigen::Vector2d size_;                 ///< texels
};

} // namespace pcl::acmap
