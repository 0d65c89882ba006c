#pragma once

#include "voting_meshes.h"

namespace pcl::acmap::test {

/** \brief Vertex spacing of the meshes below, metres. */
inline constexpr double grid = 0.05;

/** \brief The plane z = 0, centred at the origin, seen from above; size in metres. */
VotingMesh
makeWall(double width, double height);

/** \brief The mesh after a translation. */
VotingMesh
placedAt(const VotingMesh& mesh, double x, double y, double z);

/** \brief Combines two meshes without connecting them. */
VotingMesh
together(VotingMesh mesh, const VotingMesh& other);

/** \brief The mesh with Gaussian noise of each point along an axis; sigma in metres. */
VotingMesh
withNoise(VotingMesh mesh, const Eigen::Vector3f& axis, double sigma);

/** \brief The mesh without points for which a function is true, and without their
 * triangles. */
VotingMesh
without(const VotingMesh& mesh, const std::function<bool(const PointXYZ&)>& is_out);

/** \brief Two boards of 2 m by 1.5 m, one behind the other. */
VotingMesh
makeBoards(double distance);

/** \brief A wall of 2 m by 2 m with its back side. */
VotingMesh
makeThinWall(double thickness);

/** \brief A wall of 1.5 m, a door of 0.9 m that is recessed by \a depth, and a wall
 * again: along x, seen from above, 2 m along y. One connected mesh that includes the
 * reveals. */
VotingMesh
makeDoor(double depth);

/** \brief A wall of 4 m by 2.5 m that is curved about the y axis, with noise along its
 * normal. */
VotingMesh
makeCurvedWall(double radius, double sigma, double spacing = grid);

/** \brief Three walls of 2 m by 2 m that meet at right angles at the origin, seen from
 * where x, y and z are positive. They are not connected by triangles; the vertices
 * next to the edges are half a spacing away from them. */
VotingMesh
makeCornerMesh();

} // namespace pcl::acmap::test
