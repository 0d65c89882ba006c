#pragma once

#include "labeling/plane_members.h"
#include "labeling/range_noise.h"
#include "labeling/ray_fit.h"

namespace pcl::acmap::labeling {

/** Squared gate: points beyond three standard deviations may belong to another
 * plane. */
constexpr double squared_gate = 9;

/** Sums over the points of a plane. */
struct PlaneSums {
  FitSums fit;   ///< over all points within the gate
  FitSums clean; ///< over those of them that are not near points without a plane
  LargeVector<FitSums> clusters; ///< parts of best (), one per cluster
  std::size_t points = 0;
  std::size_t clean_points = 0;
  std::size_t points_at_home = 0; ///< with any label, in voxels of its hypotheses
  double squares = 0;             ///< sum of squared distances along the normal
  double chi = 0;                 ///< sum of squared distances in standard deviations

  /** A plane with enough clean points is fitted to them only: other points may belong
   * to unknown surfaces. */
  bool
  isClean() const
  {
    constexpr std::size_t min_points = 1000;
    return clean_points >= min_points && 2 * clean_points >= points;
  }

  const FitSums&
  best() const
  {
    return isClean() ? clean : fit;
  }
};

/** Returns the sums for each plane over its points, but for the number of those at
 * home. */
std::vector<PlaneSums>
sumPlanes(const Survey& survey,
          const PlaneMembers& members,
          const CandidateGrid& grid,
          const RangeNoise& noise,
          const std::vector<KnownPlane>& planes);

/** Sets for each plane the number of points in voxels of its hypotheses. */
void
countAtHome(const Survey& survey,
            const CandidateGrid& grid,
            std::vector<PlaneSums>& sums);

/** Returns for each plane the number of a previous plane that explains most of its
 * points, -1 for none: the points are within the noise of that plane, and the
 * intersections of their rays with it are in voxels of its hypotheses. Points scattered
 * by a noisy wall form such a shadow; a door that is set back does not, nor does the other
 * side of a thin wall. */
std::vector<std::int32_t>
findShadows(const Survey& survey,
            const PlaneMembers& members,
            const CandidateGrid& grid,
            const RangeNoise& noise,
            const std::vector<KnownPlane>& planes);

/** Adds the clusters of the fits in use. A cluster contains the points of one plane in
 * a voxel of the grid, or in a block of voxels.
 * \param[in] coarseness edge length of a cluster in voxels */
void
sumClusters(const Survey& survey,
            const PlaneMembers& members,
            const CandidateGrid& grid,
            const RangeNoise& noise,
            const std::vector<KnownPlane>& planes,
            int coarseness,
            std::vector<PlaneSums>& sums);

} // namespace pcl::acmap::labeling
