#pragma once

#include <pcl/core/plane_patch.h>
#include <pcl/core/point_view.h>

#include <vector>

namespace pcl::acmap {

/** How far a grown region may be believed. */
enum class PlaneTrust : std::uint8_t {
  Sure,  ///< large and wide
  Small, ///< below the least area: a plane only as part of another one
  Strip  ///< narrow: its tilt was guessed, see raiseStrips
};

/** A plane that was grown over the hypotheses. */
struct KnownPlane {
  PlanePatch patch;
  PlaneTrust trust = PlaneTrust::Sure;

  /** What its surface is off the plane beyond noise, root mean square, metres; 0 for most. */
  double warp = 0;

  /** Half the sides of the rectangle along the patch's axes that spreads as its points do,
   * metres. */
  Eigen::Vector2d half_size = Eigen::Vector2d::Zero();
};

/** The hypotheses and the planes grown over them. */
struct KnownPlanes {
  PointView points;
  std::vector<std::int32_t> labels; ///< of the points; -1 for none
  double spacing = 0;               ///< metres, between neighbours
  std::vector<KnownPlane> planes;
};

} // namespace pcl::acmap
