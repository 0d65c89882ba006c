#pragma once

#include <pcl/core/impl/depth_planes.h>
#include <pcl/core/impl/depth_view.h>
#include <pcl/core/progress.h>
#include <pcl/filters/depth_refinement_types.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief A refined view, pixel by pixel. */
struct RefinedDepth {
  std::vector<Eigen::Vector3f> points;  ///< metres; NaN for pixels without a point
  std::vector<Eigen::Vector3f> normals; ///< unit, towards the sensor; NaN if no point
};

/** \brief Implementation of DepthRefinement, independent of PCL's point types.
 * \param[in] noise of the view
 * \param[in] known planes of the view with a label for each of its pixels; nullptr:
 * they are searched
 * \param[out] report counts, seconds; reset at the start
 * \throws CancelledException when the progress callback requested it \ingroup filters
 */
ACMAP_EXPORT RefinedDepth
refineDepth(const DepthView& view,
            const NoiseScale::InverseDepth& noise,
            const DepthPlanes* known,
            unsigned threads,
            const Progress& progress,
            DepthRefinementReport& report);

} // namespace pcl::acmap
