#pragma once

#include "chain_runs.h"

#include <cstddef>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Distances between the same points under different poses, after the rigid
 * motion that aligns them best. */
struct PointAgreement {
  Eigen::Isometry3d T_given_found = Eigen::Isometry3d::Identity();
  double median = 0, maximum = 0; ///< metres; \a maximum is the 95 % quantile
};

PointAgreement
comparePoints(const std::vector<ChainView>& views);

/** \brief Comparison of the planes of a map with those of a reference. */
struct PlaneAgreement {
  std::size_t planes = 0; ///< planes of the reference that have a partner
  double area = 0;        ///< fraction of the reference's area that is near a
                          ///< partner
  double angle = 0,
         angle_maximum = 0; ///< degrees, median and maximum over all partners

  /** Metres, as above, at the centre of the common area. */
  double offset = 0, offset_maximum = 0;
};

/** \brief A sample of the reference is near a plane of the map if the distance to its
 * polygons is at most 5 cm and the angle between the normals at most 5 degrees.
 * Partners are the pairs with most of such samples. Angles and offsets are evaluated
 * for planes of at least a quarter of a square metre. */
PlaneAgreement
comparePlanes(const std::vector<PlanePatch>& reference,
              const std::vector<PlanePatch>& planes,
              const Eigen::Isometry3d& T_reference_map);

/** \brief Distance between the same surface in two views. */
struct SurfaceAgreement {
  std::size_t pieces = 0;         ///< found in both views
  double median = 0, maximum = 0; ///< metres; \a maximum is the 90 % quantile
};

/** \brief Registers views with each other and measures distances across the surfaces
 * that both see: planar pieces in cubes of 10 cm, with partners within 5 cm along the
 * surface, 10 cm across and 15 degrees. No ground truth is needed: better poses bring
 * surfaces closer together.
 * \param[in] step from a view to its partner
 * \param[in] pose selects one of the poses of a view */
SurfaceAgreement
compareSurfaces(const std::vector<ChainView>& views,
                std::size_t step,
                Eigen::Isometry3d ChainView::*pose);

} // namespace pcl::acmap::bench
