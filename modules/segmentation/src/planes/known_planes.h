#pragma once

#include <pcl/core/impl/point_view.h>
#include <pcl/core/plane_patch.h>
#include <pcl/segmentation/impl/plane_clustering_kernel.h>

#include <limits>
#include <vector>

namespace pcl::acmap {

/** Reliability of a grown region. */
enum class PlaneTrust : std::uint8_t {
  Sure,  ///< large and wide
  Small, ///< below the minimum area: valid only as a part of another plane
  Strip  ///< narrow, with a guessed tilt, see raiseStrips
};

/** A plane that was grown over the hypotheses. */
struct KnownPlane {
  PlanePatch patch;
  PlaneTrust trust = PlaneTrust::Sure;

  /** Deviation of the surface from the plane beyond noise, root mean square, metres; 0
   * for most. */
  double warp = 0;

  /** Half the sides of the rectangle along the patch's axes that has the same variances
   * as its points, metres. */
  Eigen::Vector2d half_size = Eigen::Vector2d::Zero();
};

/** The hypotheses and the planes grown over them. */
struct KnownPlanes {
  PointView points;
  PointLabels labels; ///< plane of each point; -1 for none
  double spacing = 0; ///< metres, between neighbours

  /** Largest noise, and largest warp, that are measured on the planes, metres: points beyond
   * are beside a plane, not on it. */
  double max_sigma = std::numeric_limits<double>::infinity();
  double max_warp = std::numeric_limits<double>::infinity();
  std::vector<KnownPlane> planes;
};

namespace planes {

/** Result of \ref makeRegular. */
struct Regularity {
  std::size_t turned = 0;
  double largest_turn = 0; ///< radians
};

/** Rotates planes about their centres to be exactly parallel or perpendicular to larger
 * ones, by at most three standard deviations of their tilt and at most one degree. */
Regularity
makeRegular(std::vector<KnownPlane>& planes);

/** Sorts the patches by decreasing area and updates the labels. */
void
sortByArea(PlaneClusters& clusters);

} // namespace planes

} // namespace pcl::acmap
