#pragma once

#include "planes/plane_growth.h"

namespace pcl::acmap::planes {

/** Grows regions over the mesh within the noise. First the large planes are grown; then
 * the remaining hypotheses are grown again and kept as small regions and strips, which
 * have to be verified with the points. Curved surfaces are removed and counted. */
std::vector<GrownPlane>
growNoiseDriven(const CellGraph& graph,
                const std::vector<std::int32_t>& seeds,
                const PlaneLimits& limits,
                double min_area,
                PlaneClusteringReport& report);

} // namespace pcl::acmap::planes
