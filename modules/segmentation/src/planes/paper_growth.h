#pragma once

#include "planes/plane_growth.h"

#include <pcl/core/progress.h>
#include <pcl/segmentation/plane_clustering_types.h>

namespace pcl::acmap::planes {

/** The paper's thresholds (II-C.2). */
struct PaperThresholds {
  double member_distance = 0; ///< W_d, metres
  SupporterReach reach = SupporterReach::Members;
  double cosine = 0;         ///< of W_n
  double plane_distance = 0; ///< W_t, metres
  std::size_t support = 0;   ///< W_h
};

/** Finds planes as the paper does: hypothesis i is supported by each other hypothesis j
 * with p_j within W_d of p_i, or of a p_k that supports it, n_j within W_n of n_i, and p_j
 * within W_t of the plane, which is estimated again with each supporter. It is a plane if it has
 * more than W_h supporters.
 *
 * Where the paper leaves it open: the plane is the least-squares plane of p_i and its
 * supporters, once they are not on one line; candidates are visited in their order, those
 * that new supporters bring within W_d in the next round, until a round finds no other
 * supporter; what supports a plane supports no further one and is not tested.
 * \param[in] hypotheses in the order in which they are tested
 * \param[in] progress reported from 0 to 0.85 from time to time
 * \param[in,out] report counts the tests and the estimations
 * \throws CancelledException when the progress callback requested to stop */
std::vector<GrownPlane>
growAsPaper(const CellGraph& graph,
            const std::vector<std::int32_t>& hypotheses,
            const PaperThresholds& thresholds,
            const Progress& progress,
            PlaneClusteringReport& report);

/** Sets frame, residuals and covariance of a plane that was grown as in the paper, the
 * least-squares plane of its members. Their distances from it are taken as independent
 * noise. */
void
describeFit(const CellGraph& graph, const GrownPlane& grown, KnownPlane& known);

} // namespace pcl::acmap::planes
