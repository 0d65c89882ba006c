#pragma once

#include <pcl/core/cylinder_patch.h>
#include <pcl/core/plane_patch.h>

#include <vector>

namespace pcl::acmap::texturing {

constexpr double paper_texel_size = 0.02; ///< metres

/** The edge of a texel in metres, the wanted one or up to sixteen times as large, of which these
 * surfaces have at most as many as the pages of a map hold: three quarters of the largest ones
 * (AtlasLimits), for which charts with more texels would be halved. */
double
legalTexelSize(const std::vector<PlanePatch>& planes,
               const std::vector<CylinderPatch>& cylinders,
               double wanted);

/** The smallest edge that \ref automaticTexelSize can choose for them. */
double
finestTexelSize(const std::vector<PlanePatch>& planes,
                const std::vector<CylinderPatch>& cylinders);

} // namespace pcl::acmap::texturing
