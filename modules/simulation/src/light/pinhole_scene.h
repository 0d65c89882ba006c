#pragma once

#include "../cast_target.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::acmap {

/** \brief A scene as seen from a pinhole, for rays in any order: surfaces are sorted
 * into tiles of the image, and a ray is intersected with those of its tile. */
class PinholeScene {
public:
  /** \brief The first intersection of a ray. */
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

  /** \brief Returns true if there is no surface between the pinhole and a point.
   * \param[in] point in the pinhole's frame, in front of it and within its image */
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
  std::vector<std::vector<std::uint32_t>> tiles_; // target indices, ascending
};

} // namespace pcl::acmap
