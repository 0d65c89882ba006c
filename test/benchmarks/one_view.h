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
  PointCloud<PointXYZ>::Ptr organized; ///< NaN where nothing was measured
  PlaneInput finite;                   ///< its finite points, in their order
  Indices finite_of_pixel;             ///< for each pixel its place there, -1 for none
};

/** \brief The tolerance of the peers, metres: that of PCL's tutorials for a Kinect. */
inline constexpr double view_tolerance = 0.02;

OneView
makeOneView(const std::string& name, const PointCloud<PointXYZ>::Ptr& organized);

/** \brief Reads an organized PCD. */
OneView
loadOneView(const std::string& name, const std::string& path);

/** \brief A view of a simulated scene, with the planes that really are in it. */
struct TrueView {
  OneView view;
  PlaneTruth truth; ///< labels of the finite points
};

TrueView
makeTrueView(const SimulatedScene& scene, std::size_t view);

/** \brief What lies between the distinct depths of a view: median difference of their
 * inverses, 1/m. */
double
inverseDepthStep(const OneView& view);

} // namespace pcl::acmap::bench
