#pragma once

#include "clouds.h"

#include <pcl/core/triangle_mesh.h>

#include <functional>

namespace pcl::acmap::test {

/** \brief Vertices and triangles with known truth. Metres. */
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

/** \brief Maps the point (u, v) of a sheet to space. */
using Place = std::function<Eigen::Vector3d(double u, double v)>;

/** \brief A grid centred at u = v = 0 with its columns along u and two triangles per
 * square. The normals of a horizontal plane point up. */
VotingMesh
makeSheetMesh(int columns, int rows, double spacing, const Place& place);

/** \brief The plane z = 0. */
VotingMesh
makePlaneMesh(int columns, int rows, double spacing);

/** \brief A roof of 41 by 21 vertices, 1 m apart, with its ridge on the y axis.
 * \param[in] angle between its two sides, radians; pi for a plane */
VotingMesh
makeRoofMesh(double angle);

/** \brief Half a cylinder about the y axis, oriented outwards, with 33 vertices
 * around. */
VotingMesh
makeHalfCylinderMesh(int rows, double radius);

/** \brief A grid with random heights: creases of all kinds. */
VotingMesh
makeRoughMesh(int side, double height, std::uint64_t seed);

/** \brief The mesh with opposite orientation. */
VotingMesh
turnedOver(VotingMesh mesh);

/** \brief For each vertex, is it surrounded by triangles? Counts the uses of its
 * edges. */
std::vector<bool>
innerVertices(const VotingMesh& mesh);

} // namespace pcl::acmap::test
