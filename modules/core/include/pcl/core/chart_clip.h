#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Texels that a chart may have, and all charts of a map together. \ingroup core */
constexpr std::int64_t maximum_texels = std::int64_t{1} << 28;

/** \brief What is wrong with the rectangle of a chart; empty for nothing. Sound ones have
 * 1 to 2^28 texels, a finite origin, texels with sides of 1e-6 m to 1e3 m, and an area above
 * a thousandth of the product of the sides. \ingroup core */
ACMAP_EXPORT std::string
faultOfFrame(const TextureChart& chart);

/** \brief A point of a plane and where it lies in a chart. \ingroup core */
struct ChartCorner {
  Eigen::Vector3d point; ///< metres
  Eigen::Vector2d
      place; ///< texels: column and row from the outer corner of texel (0, 0)
};

/** \brief Cuts triangles off at the rectangle of a chart. \ingroup core */
class ACMAP_EXPORT ChartClip {
public:
  /** \param[in] chart without a \ref faultOfFrame; its colours do not matter */
  explicit ChartClip(const TextureChart& chart);

  /** \brief What of a triangle lies in the chart: a convex polygon that turns the same
   * way; empty for nothing. Edges that two triangles share are cut at the same points; what
   * lies out by less than 0.01 texels stays. */
  std::vector<ChartCorner>
  clipped(const std::array<Eigen::Vector3d, 3>& triangle) const;

private:
  Eigen::Vector3d origin_;
  Eigen::Matrix<double, 2, 3> to_place_; ///< metres to texels
  Eigen::Vector2d size_;                 ///< texels
};

} // namespace pcl::acmap
