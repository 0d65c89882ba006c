#pragma once

#include "clouds.h"

#include <pcl/core/triangle_mesh.h>

#include <functional>

namespace pcl::acmap::test {

/** \brief Vertices and triangles of which the truth is known. Metres. */
struct VotingMesh {
  Cloud cloud;
  TriangleMesh faces;
};

inline PointXYZ
toPoint(const Eigen::Vector3d& place)
{
  const Eigen::Vector3f p = place.cast<float>();
  return {p.x(), p.y(), p.z()};
}

/** \brief Where the point (u, v) of a sheet lies in space. */
using Place = std::function<Eigen::Vector3d(double u, double v)>;

/** \brief A grid about u = v = 0, its columns along u, two triangles a square; of a level
 * plane they look up. */
VotingMesh
makeSheetMesh(int columns, int rows, double spacing, const Place& place);

/** \brief z = 0. */
VotingMesh
makePlaneMesh(int columns, int rows, double spacing);

/** \brief A roof of 41 by 21 vertices, 1 m apart, with its ridge on the y axis.
 * \param[in] angle radians between its two sides, pi for a plane */
VotingMesh
makeRoofMesh(double angle);

/** \brief Half a cylinder about the y axis, seen from outside, 33 vertices around. */
VotingMesh
makeHalfCylinderMesh(int rows, double radius);

/** \brief A plane of random heights: creases of all kinds. */
VotingMesh
makeRoughMesh(int side, double height, std::uint64_t seed);

/** \brief The same seen from the other side. */
VotingMesh
turnedOver(VotingMesh mesh);

/** \brief Whether a vertex has neighbours all round, by the number of times its edges are
 * met. */
std::vector<bool>
innerVertices(const VotingMesh& mesh);

} // namespace pcl::acmap::test
