#pragma once

#include <pcl/core/plane_patch.h>

#include <vector>

namespace pcl::acmap {

/** \brief A boundary of a polygon with the edge that follows each of its points. */
struct Boundary {
  std::vector<Eigen::Vector3f> points;
  std::vector<PolygonEdge> edges;
};

/** \brief The outer boundary first, then the holes. Edges of polygons that tell none are
 * open. */
std::vector<Boundary>
boundariesOf(const PlanePolygon& polygon);

PlanePolygon
polygonOf(const std::vector<Boundary>& boundaries);

/** \brief Square metres, with a sign: positive if counter-clockwise about the normal, holes
 * negative. */
double
areaOf(const std::vector<Boundary>& boundaries, const Eigen::Vector3d& normal);

/** \brief May changed boundaries take the place of those before? Each keeps its sense, and no
 * edge at a cylinder crosses another one. */
bool
mayReplace(const std::vector<Boundary>& before,
           const std::vector<Boundary>& after,
           const PlanePatch& plane);

/** \brief Is the edge shared with another plane? */
inline bool
isShared(const PolygonEdge& edge)
{
  return edge.kind == EdgeKind::Crease || edge.kind == EdgeKind::Contact;
}

} // namespace pcl::acmap
