#pragma once

#include "voting_meshes.h"

namespace pcl::acmap::test {

/** \brief Metres between neighbouring vertices of the meshes below. */
inline constexpr double grid = 0.05;

/** \brief The plane z = 0 about the origin, seen from above; so many metres. */
VotingMesh
makeWall(double width, double height);

/** \brief The same mesh elsewhere. */
VotingMesh
placedAt(const VotingMesh& mesh, double x, double y, double z);

/** \brief Two meshes as one, not joined by a triangle. */
VotingMesh
together(VotingMesh mesh, const VotingMesh& other);

/** \brief The same with each point moved at random along an axis; sigma in metres. */
VotingMesh
withNoise(VotingMesh mesh, const Eigen::Vector3f& axis, double sigma);

/** \brief Without the points for which a function is true, and their triangles. */
VotingMesh
without(const VotingMesh& mesh, const std::function<bool(const PointXYZ&)>& is_out);

/** \brief Two boards of 2 m by 1.5 m, one behind the other. */
VotingMesh
makeBoards(double distance);

/** \brief A wall of 2 m by 2 m and its back side. */
VotingMesh
makeThinWall(double thickness);

/** \brief Wall for 1.5 m, a door of 0.9 m that lies \a depth behind it, wall again: along x,
 * seen from above, 2 m along y. One mesh with its reveals. */
VotingMesh
makeDoor(double depth);

/** \brief A wall of 4 m by 2.5 m that bends round the y axis, with noise across it. */
VotingMesh
makeCurvedWall(double radius, double sigma, double spacing = grid);

/** \brief Three walls of 2 m by 2 m that meet at right angles in the origin, seen from
 * where x, y and z are positive. No triangle joins them, the vertices next to the edges
 * are half a spacing off. */
VotingMesh
makeCornerMesh();

} // namespace pcl::acmap::test
