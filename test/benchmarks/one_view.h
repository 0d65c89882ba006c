#pragma once

#include "plane_matches.h"

#include <pcl/pipeline/plane_mapping.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/simulation/simulated_scene.h>

#include <functional>
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

/** \brief A view of a simulated scene, with its true planes. */
struct TrueView {
  OneView view;
  PlaneTruth truth; ///< labels of the finite points
};

/** \brief A plane detection method for organized views. */
struct OneViewFinder {
  std::string name;
  std::function<FoundPlanes(const OneView&)> find;
  bool is_slow = false; ///< takes several seconds for a view
};

/** \brief Reads an organized PCD. */
OneView
loadOneView(const std::string& name, const std::string& path);

/** \brief Lets the range sensor of a scene measure at every pixel, as `pcl_simulated_rig
 * --all-points`. */
void
useAllPixels(SimulatedScene& scene);

/** \brief Measures a view of a scene. */
TrueView
makeTrueView(const SimulatedScene& scene, std::size_t view);

/** \brief The planes that the tools find in a view, on one thread. This is the only
 * place to change if they use another method. */
FoundPlanes
ourPlanes(const OneView& view, DepthSensor sensor = DepthSensor::Automatic);

/** \brief The planes of OrganizedMultiPlaneSegmentation with refinement, on normals of
 * IntegralImageNormalEstimation, as pixels of each plane. */
std::vector<Indices>
segmentOrganized(const OneView& view);

/** \brief acmap, then PCL's for organized clouds. */
std::vector<OneViewFinder>
pictureFinders();

/** \brief The same, then the peers for unorganized points. */
std::vector<OneViewFinder>
oneViewFinders();

/** \brief Runs a method as \ref findPlanes does. */
FoundPlanes
findInView(const OneViewFinder& finder, const OneView& view);

} // namespace pcl::acmap::bench
