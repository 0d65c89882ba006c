#pragma once

#include "planes/plane_growth.h"

namespace pcl::acmap::planes {

/** The paper's hypotheses (II-C.2): a point supports a plane when it is nearer than W_d to
 * one of its points, W_n to its normal and W_t to the plane, which follows with every
 * supporter; with more than W_h of them it is accepted.
 * \param[in] progress is told from 0 to 0.85, now and then
 * \throws CancelledException when it was told to stop */
std::vector<GrownPlane>
growAsPaper(const CellGraph& graph,
            const std::vector<std::int32_t>& seeds,
            const PlaneLimits& limits,
            double member_distance,
            std::size_t least_support,
            const Progress& progress,
            PlaneClusteringReport& report);

} // namespace pcl::acmap::planes
