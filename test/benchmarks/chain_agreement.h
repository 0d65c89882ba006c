#pragma once

#include "chain_runs.h"

#include <cstddef>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Where the same points of the same views lie by other poses, after the rigid
 * motion that fits them best. */
struct PointAgreement {
  Eigen::Isometry3d T_given_found = Eigen::Isometry3d::Identity();
  double median = 0, most = 0; ///< metres apart; 95 % are nearer than \a most
};

PointAgreement
comparePoints(const std::vector<ChainView>& views);

/** \brief Planes of a map beside those of a reference. */
struct PlaneAgreement {
  std::size_t planes = 0;           ///< of the reference, that have a partner
  double area = 0;                  ///< share of the reference's area that is near one
  double angle = 0, angle_most = 0; ///< degrees, median and largest over partners

  /** Metres, the same, in the middle of what both have. */
  double offset = 0, offset_most = 0;
};

/** \brief A place of the reference is near a plane of the map when its polygons come within
 * 5 cm and its normal within 5 degrees; partners are the pairs that are near in most
 * places. Angles and offsets are of planes of at least a quarter of a square metre. */
PlaneAgreement
comparePlanes(const std::vector<PlanePatch>& reference,
              const std::vector<PlanePatch>& planes,
              const Eigen::Isometry3d& T_reference_map);

/** \brief How far apart the same surface lies in two views. */
struct SurfaceAgreement {
  std::size_t pieces = 0;      ///< that were found in both
  double median = 0, most = 0; ///< metres; 90 % are nearer than \a most
};

/** \brief Lays views over each other and measures across what both see: plane pieces in
 * cubes of 10 cm, partners within 5 cm along the surface, 10 cm across and 15 degrees. It
 * needs no truth: of several poses those are better that bring surfaces together.
 * \param[in] step from a view to its partner
 * \param[in] pose which one of a view's */
SurfaceAgreement
compareSurfaces(const std::vector<ChainView>& views,
                std::size_t step,
                Eigen::Isometry3d ChainView::*pose);

} // namespace pcl::acmap::bench
