#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/export.h>
#include <pcl/core/point_types.h>
#include <pcl/core/stage_controls.h>
#include <pcl/core/triangle_mesh.h>
#include <pcl/surface/dewall_kernel.h>
#include <pcl/surface/dewall_types.h>
#include <pcl/surface/reconstruction.h>

namespace pcl {

/** \brief Open, manifold triangle mesh of a point cloud by a Delaunay wall of
 * triangles.
 *
 * Implements II-C.1 of "Active Stereo Based Compact Mapping" (Fig. 5, Fig. 6). A
 * splitting plane alpha divides the points; the triangles that cross it, the wall, are
 * built first, side by side, each new apex being the Delaunay-nearest point in the
 * half-space beyond the side's plane beta; then each half is treated alike with points
 * of its own. The mesh is open: it ends where the size constraint ends it. Vertices are
 * the input points, in their order. No normals are needed; where the points have unit
 * normals that mostly agree with their neighbours', the mesh is oriented by them.
 *
 * Every result of rules \c Paper and \c Dense has at most two triangles an edge, one
 * fan a vertex, no degenerate or doubled face, one orientation a component (towards
 * `sensor_origin_` of the cloud), and no edge beyond the size constraint; with \c Paper
 * no input point lies inside the smallest sphere through a triangle's corners by more
 * than the relative tolerance 1e-6 of its radius. The same input gives the same bytes
 * for every number of threads.
 *
 * Coordinates in metres. Time O(n log n), memory at most 170 bytes a point.
 * \code
 * pcl::DeWallTriangulation<pcl::PointXYZ> dewall;
 * dewall.setInputCloud (cloud);
 * pcl::PolygonMesh mesh;
 * dewall.reconstruct (mesh);
 * \endcode
 * \ingroup surface
 */
template <typename PointInT>
class DeWallTriangulation : public MeshConstruction<PointInT>,
                            public StageControls<DeWallReport> {
public:
  using Ptr = shared_ptr<DeWallTriangulation<PointInT>>;
  using ConstPtr = shared_ptr<const DeWallTriangulation<PointInT>>;

  DeWallTriangulation();

  /** \brief Sets the acceptance rule (default \ref DeWallRule::Paper). */
  void
  setAcceptanceRule(DeWallRule rule);

  DeWallRule
  getAcceptanceRule() const
  {
    return rule_;
  }

  /** \brief Sets the size constraint L: no edge is longer.
   * \param[in] length metres; 0 (default): automatic, for each point a multiple of the
   * spacing around it, and an edge obeys the smaller one of its two ends. Who is around it
   * is up to PCL's \c setSearchMethod, where one was set; the search for triangles has
   * cells of its own.
   * \throws BadArgumentException when negative or not finite */
  void
  setMaximumEdgeLength(double length);

  double
  getMaximumEdgeLength() const
  {
    return maximum_edge_length_;
  }

  /** \brief Sets the number of points up to which a part is triangulated without a further
   * wall (default 65536). The mesh depends on it.
   * \throws BadArgumentException unless within [3, 2^31 - 1] */
  void
  setLeafSize(int points);

  int
  getLeafSize() const
  {
    return leaf_size_;
  }

  /** \brief Asks for \ref TriangleMesh::wall_depth (default false). */
  void
  setComputeWallDepth(bool compute)
  {
    compute_wall_depth_ = compute;
  }

  bool
  getComputeWallDepth() const
  {
    return compute_wall_depth_;
  }

  /** \brief Sets how much memory reconstruct () may take beside its input, in bytes (0 =
   * no limit, default); a cloud for which the estimate exceeds it is refused. */
  void
  setMemoryLimit(std::size_t bytes)
  {
    memory_limit_ = bytes;
  }

  std::size_t
  getMemoryLimit() const
  {
    return memory_limit_;
  }

  /** \brief Triangulates the input cloud (its indices, where set).
   * \param[out] mesh index triples into the whole input cloud; empty, with the reason
   * in the report, where no triangle is possible \throws InitFailedException without an
   * input cloud, or with indices outside of it \throws MemoryLimitException when it
   * would exceed the memory limit \throws CancelledException when the progress callback
   * stopped it */
  void
  reconstruct(TriangleMesh& mesh);

  /** \brief As above, as PCL's mesh: the whole input cloud and its polygons. */
  void
  reconstruct(PolygonMesh& output) override;

  /** \brief As above, polygons alone. */
  void
  reconstruct(std::vector<Vertices>& polygons) override;

protected:
  using MeshConstruction<PointInT>::input_;
  using MeshConstruction<PointInT>::indices_;
  using MeshConstruction<PointInT>::check_tree_;
  using MeshConstruction<PointInT>::tree_;

  std::string
  getClassName() const override
  {
    return "DeWallTriangulation";
  }

private:
  void
  performReconstruction(PolygonMesh& output) override;

  void
  performReconstruction(std::vector<Vertices>& polygons) override;

  acmap::NeighbourDistances
  givenSearch();

  DeWallRule rule_ = DeWallRule::Paper;
  double maximum_edge_length_ = 0;
  int leaf_size_ = 65536;
  bool compute_wall_depth_ = false;
  std::size_t memory_limit_ = 0;
};

// PCL has no search trees compiled for our point types, and MeshConstruction names them
extern template class ACMAP_EXPORT MeshConstruction<PointXYZRGBNormalView>;
extern template class ACMAP_EXPORT MeshConstruction<PointXYZRGBSigma>;

} // namespace pcl
