#pragma once

#include "mesh_checker.h"
#include "one_view.h"
#include "plane_finders.h"

namespace pcl::acmap::bench {

/** \brief A plane detection method for organized views. */
struct OneViewFinder {
  std::string name;
  std::function<FoundPlanes(const OneView&)> find;
  bool is_slow = false; ///< takes several seconds for a view
};

/** \brief The planes that the tools find in a view, on one thread. This is the only
 * place to change if they use another method. */
FoundPlanes
ourPlanes(const OneView& view);

/** \brief PCL's OrganizedMultiPlaneSegmentation with refinement, on normals of
 * IntegralImageNormalEstimation; each plane is fitted by least squares to its
 * inliers. */
FoundPlanes
organizedPlanes(const OneView& view);

/** \brief acmap, then PCL's for organized clouds, then the peers for unorganized
 * points. */
std::vector<OneViewFinder>
oneViewFinders();

/** \brief Runs a method as \ref findPlanes does. */
FoundPlanes
findInView(const OneViewFinder& finder, const OneView& view);

/** \brief A mesh of a view in the camera frame. */
struct OneViewMesh {
  test::Points points;
  test::Triangles triangles;
  double seconds = 0; ///< CPU of the calling thread
};

/** \brief The mesh that the tools make of a view, on one thread. As for \ref ourPlanes,
 * this is the only place to change. */
OneViewMesh
ourMesh(const OneView& view);

/** \brief PCL's OrganizedFastMesh with adaptive cut, one triangle per pixel. */
OneViewMesh
organizedMesh(const OneView& view);

/** \brief PCL's greedy projection with its normals: see \ref greedyProjection. */
OneViewMesh
greedyMesh(const OneView& view);

} // namespace pcl::acmap::bench
