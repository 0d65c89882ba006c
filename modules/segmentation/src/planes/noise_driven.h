#pragma once

#include "planes/plane_growth.h"

namespace pcl::acmap::planes {

/** Regions over the mesh within the noise. First the large planes; then what remains is
 * grown again and kept as small ones and strips, which only the points can make planes.
 * Curved surfaces are taken out and counted. */
std::vector<GrownPlane>
growNoiseDriven(const CellGraph& graph,
                const std::vector<std::int32_t>& seeds,
                const PlaneLimits& limits,
                double least_area,
                PlaneClusteringReport& report);

} // namespace pcl::acmap::planes
