#pragma once

#include "planes/plane_growth.h"

namespace pcl::acmap::planes {

/** Grows planes as in the paper (II-C.2): a point supports a plane if it is within W_d
 * of one of its points, within W_n of its normal and within W_t of the plane, which is
 * fitted again after every supporter, from the twelfth on. A plane with more than W_h
 * supporters is accepted.
 * \param[in] progress reported from 0 to 0.85 from time to time
 * \throws CancelledException when the progress callback requested to stop */
std::vector<GrownPlane>
growAsPaper(const CellGraph& graph,
            const std::vector<std::int32_t>& seeds,
            const PlaneLimits& limits,
            double member_distance,
            std::size_t min_support,
            const Progress& progress,
            PlaneClusteringReport& report);

} // namespace pcl::acmap::planes
