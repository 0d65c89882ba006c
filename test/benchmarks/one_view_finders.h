#pragma once

#include "mesh_checker.h"
#include "one_view.h"
#include "plane_finders.h"

namespace pcl::acmap::bench {

/** \brief A finder of planes in an organized view. */
struct OneViewFinder {
  std::string name;
  std::function<FoundPlanes(const OneView&)> find;
  bool is_slow = false; ///< takes several seconds for a view
};

/** \brief What the tools find in a view, on one thread: the one place to change when they
 * find planes by other means. */
FoundPlanes
ourPlanes(const OneView& view);

/** \brief PCL's OrganizedMultiPlaneSegmentation with its refinement, on the normals of
 * IntegralImageNormalEstimation; each plane is fitted by least squares to its inliers. */
FoundPlanes
organizedPlanes(const OneView& view);

/** \brief Ours, then PCL's for organized clouds, then the peers for any points. */
std::vector<OneViewFinder>
oneViewFinders();

/** \brief Runs a finder as \ref findPlanes does. */
FoundPlanes
findInView(const OneViewFinder& finder, const OneView& view);

/** \brief A mesh of a view, in the camera's frame. */
struct OneViewMesh {
  test::Points points;
  test::Triangles triangles;
  double seconds = 0; ///< CPU of the calling thread
};

/** \brief The mesh that the tools make of a view, on one thread: as \ref ourPlanes the one
 * place to change. */
OneViewMesh
ourMesh(const OneView& view);

/** \brief PCL's OrganizedFastMesh with adaptive cuts, a triangle a pixel. */
OneViewMesh
organizedMesh(const OneView& view);

/** \brief PCL's greedy projection with its normals: \ref greedyProjection. */
OneViewMesh
greedyMesh(const OneView& view);

} // namespace pcl::acmap::bench
