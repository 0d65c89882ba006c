#pragma once

#include "labeling/range_noise.h"
#include "labeling/ray_fit.h"

namespace pcl::acmap::labeling {

/** Points beyond three standard deviations of a plane may be of another one. */
constexpr double squared_gate = 9;

/** What the points of a plane sum up to. */
struct PlaneSums {
  FitSums fit;                   ///< over all points within the gate
  FitSums clean;                 ///< over those of them far from points of no plane
  std::vector<FitSums> clusters; ///< parts of the fit in use, by place
  std::size_t points = 0;
  std::size_t clean_points = 0;
  std::size_t points_at_home = 0; ///< of any plane, where its hypotheses are
  double squares = 0;             ///< of distances along the normal
  double chi = 0;                 ///< of the same in standard deviations

  /** A plane with enough of it is fitted to its clean points: others may be of surfaces
   * that nobody knows of. */
  bool
  isClean() const
  {
    constexpr std::size_t least_points = 1000;
    return clean_points >= least_points && 2 * clean_points >= points;
  }

  const FitSums&
  best() const
  {
    return isClean() ? clean : fit;
  }
};

/** Sums for each plane over its points. */
std::vector<PlaneSums>
sumPlanes(const Survey& survey,
          const std::vector<std::int32_t>& labels,
          const CandidateGrid& grid,
          const RangeNoise& noise,
          const std::vector<KnownPlane>& planes);

/** For each plane the one before it that would have most of its points, -1 for none: they
 * are within its noise, and where their rays meet it there is hypothesis upon hypothesis
 * of it. What a noisy wall scatters is such a shadow; a door that lies back is none. */
std::vector<std::int32_t>
findShadows(const Survey& survey,
            const std::vector<std::int32_t>& labels,
            const CandidateGrid& grid,
            const RangeNoise& noise,
            const std::vector<KnownPlane>& planes);

/** Adds the clusters of the fits in use: points of a voxel of the grid, or of several,
 * and of one plane.
 * \param[in] coarseness voxels a cluster along each axis */
void
sumClusters(const Survey& survey,
            const std::vector<std::int32_t>& labels,
            const CandidateGrid& grid,
            const RangeNoise& noise,
            const std::vector<KnownPlane>& planes,
            int coarseness,
            std::vector<PlaneSums>& sums);

} // namespace pcl::acmap::labeling
