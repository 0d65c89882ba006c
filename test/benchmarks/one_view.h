#pragma once

#include "plane_truth.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief An organized view of a depth sensor, camera frame, metres. */
struct OneView {
  std::string name;
  PointCloud<PointXYZ>::Ptr organized; ///< NaN if nothing was measured
  PlaneInput finite;                   ///< its finite points, in the same order
  Indices finite_of_pixel;             ///< index in finite of each pixel, -1 for none
};

/** \brief Tolerance of the peers in metres, from PCL's tutorials for a Kinect. */
inline constexpr double view_tolerance = 0.02;

OneView
makeOneView(const std::string& name, const PointCloud<PointXYZ>::Ptr& organized);

/** \brief Reads an organized PCD. */
OneView
loadOneView(const std::string& name, const std::string& path);

/** \brief A view of a simulated scene, with its true planes. */
struct TrueView {
  OneView view;
  PlaneTruth truth; ///< labels of the finite points
};

TrueView
makeTrueView(const SimulatedScene& scene, std::size_t view);

/** \brief Distance between the distinct depths of a view: median difference of their
 * inverses, 1/m. */
double
inverseDepthStep(const OneView& view);

} // namespace pcl::acmap::bench
