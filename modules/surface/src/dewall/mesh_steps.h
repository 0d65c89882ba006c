#pragma once

#include "growing_mesh.h"
#include "point_tree.h"
#include "poll_pace.h"
#include "range.h"
#include "size_constraint.h"
#include "triangle_builder.h"

#include <pcl/core/impl/disjoint_sets.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/triangle_mesh.h>
#include <pcl/surface/dewall_types.h>
#include <pcl/surface/impl/dewall_kernel.h>

namespace pcl::acmap::ACMAP_DEWALL {

using PointSets = DisjointSets<std::int32_t>;

/** \brief Returns the finite points of a view without repetitions, in any order: the
 * first of equal points is kept. The report's counts of skipped points are set. */
SourcePoints
distinctPoints(const PointView& view, DeWallReport& report);

/** \brief Removes the triangles that are not in the largest fan of a pinched vertex,
 * and repeats this for vertices that are pinched by the removal.
 *
 * \param[in] lists all triangles at the tested vertices; the removed ones are erased
 * from them
 * \param[in] are_walls_known if false, vertices that are used by walls are skipped
 * \return the removed triangles */
std::vector<GrownTriangle>
keepLargestFans(GrowingMesh& mesh,
                const std::vector<GrownTriangles*>& lists,
                bool are_walls_known);

/** \brief Closes holes with few edges by the triangles with the smallest turns, under
 * the guard and the size constraint; a hole that needs too large a turn remains open.
 *
 * In the range of all points, only holes at vertices of walls are considered, as the
 * parts have closed the others. */
void
closeSmallHoles(const SizeConstraint& size, GrowingMesh& mesh, const Range& range);

/** \brief Numbers the components of all parts consecutively, in their triangles and in
 * the arrays, and joins them with their orientations.
 *
 * Two halves together may form a Moebius strip, which none of them can detect. Then the
 * triangles that contradict previous ones, in the order of the parts, are removed.
 * \param[out] removed these triangles
 * \return the mesh of all points, for the last passes; the triangles remain in the
 * parts */
GrowingMesh
joinParts(MeshArrays& arrays,
          std::vector<Part>& parts,
          std::vector<GrownTriangle>& removed);

/** \brief Completes what the parts left open, in one thread: edges whose apex is
 * outside of their half, fans at the walls, and the surroundings of such changes.
 *
 * \param[in] mesh of all points
 * \param[in] removed triangles that were removed before
 * \return number of triangles removed to keep one fan per vertex */
std::size_t
finishMesh(GrowingMesh& mesh,
           const SizeConstraint& size,
           DeWallRule rule,
           std::vector<Part>& parts,
           std::vector<GrownTriangle> removed,
           const std::function<void()>& tick);

/** \brief Returns the connected clusters ([P] II-C.1): two points are connected if there
 * is a chain of edges between them that satisfies the size constraint. No triangle
 * connects two clusters.
 * \param[in] connected points that are known to be connected */
PointSets
findClusters(const PointTree& tree, const SizeConstraint& size, PointSets connected);

/** \brief Points of the smallest cluster that may have a triangle. */
constexpr std::int32_t min_cluster = 3;

/** \brief Number of points of each cluster, at the index of its representative; 0 for
 * all other points. */
LargeVector<std::int32_t>
clusterSizes(PointSets& clusters, std::int32_t points);

/** \brief Returns the number of clusters of at least three points. The front is seeded
 * again in each cluster, so the clusters need not be known before. */
std::size_t
countClusters(const PointTree& tree, const SizeConstraint& size, PointSets connected);

/** \brief Components of the mesh by vertices: as each vertex has only one fan,
 * triangles that share a vertex are also connected by edges. An unused point is a set of
 * its own. */
PointSets
findComponents(const PointTree& tree, const std::vector<TriangleList>& lists);

/** \brief Sets the report's counts of used points and boundary edges. */
void
countVertices(const MeshArrays& arrays, DeWallReport& report);

/** \brief Converts the grown triangles to a mesh of source indices. Each component is
 * oriented as a whole, by the facing directions if known, otherwise towards the sensor
 * (by projected area). If the report's sides are Outward, or they become so because no
 * sensor is known and the mesh is closed, it is by the volume that it encloses. The report's
 * other counts of the mesh are set.
 * \param[in] grown its vertices are not needed any more */
TriangleMesh
orientedMesh(GrowingMesh& grown,
             const std::vector<TriangleList>& lists,
             PointSets components,
             const Eigen::Vector3d& sensor_origin,
             bool compute_wall_depth,
             DeWallReport& report);

/** \brief The mesh of the rule Strict, [P] II-C.1 as printed: clusters first, then each
 * one is meshed as \ref buildLiterally describes. Each triangle faces the sensor. The
 * report's counts of the mesh and the seconds of the steps are set.
 * \param[in] leaf_size maximum number of points of a part without a splitting plane */
TriangleMesh
literalMesh(const PointTree& tree,
            const SizeConstraint& size,
            const Facing& facing,
            const Eigen::Vector3d& sensor_origin,
            const DeWallSettings& settings,
            std::int32_t leaf_size,
            const std::function<void()>& tick,
            StepTimer& timer,
            DeWallReport& report);

} // namespace pcl::acmap::ACMAP_DEWALL
