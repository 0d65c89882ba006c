#pragma once

#include "../cast_target.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::acmap {

/** \brief A scene as a pinhole sees it, for rays in any order: surfaces are sorted into
 * tiles of its image, and a ray tries those of its tile. */
class PinholeScene {
public:
  /** \brief The surface a ray meets first. */
  struct Hit {
    double depth = std::numeric_limits<double>::infinity(); ///< metres along z
    std::int32_t surface = -1;                              ///< -1 for nothing
  };

  PinholeScene(const SceneGeometry& scene,
               const TrinocularRig& pinhole,
               const Eigen::Isometry3d& T_scene_pinhole);

  /** \param[in] ray from the pinhole through its image, with z = 1 */
  Hit
  hit(const Eigen::Vector3d& ray) const;

  /** \brief Whether nothing stands between the pinhole and a point.
   * \param[in] point before the pinhole, within its image; its frame */
  bool
  sees(const Eigen::Vector3d& point) const;

private:
  const std::vector<std::uint32_t>&
  tileOf(const Eigen::Vector3d& ray) const;

  TrinocularRig pinhole_;
  DepthRange range_;
  std::vector<CastTarget> targets_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::vector<std::uint32_t>> tiles_; // targets of each, in order
};

} // namespace pcl::acmap
