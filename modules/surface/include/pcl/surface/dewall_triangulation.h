#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/cloud_rows.h>
#include <pcl/core/export.h>
#include <pcl/core/point_types.h>
#include <pcl/core/stage_controls.h>
#include <pcl/core/triangle_mesh.h>
#include <pcl/surface/dewall_types.h>
#include <pcl/surface/impl/dewall_kernel.h>
#include <pcl/surface/reconstruction.h>

#include <optional>

namespace pcl {

/** \brief Settings of \ref DeWallTriangulation, for clouds of points and of rows.
 * \ingroup surface */
class ACMAP_EXPORT DeWallParameters : public StageControls<DeWallReport> {
public:
  /** \brief Sets the acceptance rule (default \ref DeWallRule::Guarded). */
  void
  setAcceptanceRule(DeWallRule rule);

  DeWallRule
  getAcceptanceRule() const
  {
    return settings_.rule;
  }

  /** \brief Sets the size constraint L, the maximum length of an edge.
   * \param[in] length metres; 0 (default) is automatic: the limit of each point is a
   * multiple of the spacing around it, and an edge has to respect the smaller limit of
   * its two ends. The spacing is measured with PCL's \c setSearchMethod if one was set;
   * the search for triangles always uses the internal tree.
   * \throws BadArgumentException when it is negative or not finite */
  void
  setMaximumEdgeLength(double length);

  double
  getMaximumEdgeLength() const
  {
    return settings_.maximum_edge_length;
  }

  /** \brief Sets the number of points up to which a part is triangulated without a further
   * wall. The mesh depends on it.
   * \param[in] points 0 (default) is automatic: 65536, with \ref DeWallRule::Strict 1
   * \throws BadArgumentException when it is negative */
  void
  setLeafSize(int points);

  int
  getLeafSize() const
  {
    return settings_.leaf_size;
  }

  /** \brief Sets the up direction of a cloud whose sensor is not known, such as a survey
   * from the air (default: none).
   *
   * The mesh is then oriented by the free space in front of its surfaces, instead of by the
   * sensor or by normals: a ground faces up, the walls of a room face each other. It is
   * found by rays from flat patches of the points to other points.
   * \param[in] up of any length above 0, in the frame of the cloud
   * \throws BadArgumentException if it is not finite or zero */
  void
  setUpDirection(const Eigen::Vector3d& up);

  /** \brief Orients the mesh by the sensor or by normals again (default). */
  void
  resetUpDirection()
  {
    settings_.up.reset();
  }

  /** \brief The up direction that was set, of length 1. */
  const std::optional<Eigen::Vector3d>&
  getUpDirection() const
  {
    return settings_.up;
  }

  /** \brief Requests the computation of \ref TriangleMesh::wall_depth (default
   * false). */
  void
  setComputeWallDepth(bool compute)
  {
    settings_.compute_wall_depth = compute;
  }

  bool
  getComputeWallDepth() const
  {
    return settings_.compute_wall_depth;
  }

  /** \brief Requests that surfaces face outward, off what they enclose (default false): for
   * objects that were seen from all sides. The sensor, the normals and the up direction are
   * then not used. Without it and without all of these, closed surfaces of up to 3 m do. */
  void
  setOutward(bool outward)
  {
    settings_.outward = outward;
  }

  bool
  getOutward() const
  {
    return settings_.outward;
  }

  /** \brief Sets the maximum memory of reconstruct (), without its input, in bytes (0 =
   * no limit, default). A cloud for which the estimate exceeds it is rejected. */
  void
  setMemoryLimit(std::size_t bytes)
  {
    settings_.memory_limit = bytes;
  }

  std::size_t
  getMemoryLimit() const
  {
    return settings_.memory_limit;
  }

  /** \brief All settings. */
  const acmap::DeWallSettings&
  settings() const
  {
    return settings_;
  }

protected:
  DeWallParameters() = default;

private:
  acmap::DeWallSettings settings_;
};

/** \brief Open, manifold triangle mesh of a point cloud by a Delaunay wall of
 * triangles.
 *
 * Implements II-C.1 of "Active Stereo Based Compact Mapping" (Fig. 5, Fig. 6). A
 * splitting plane alpha divides the points. The triangles that cross it, the wall, are
 * built first, one edge after the other: each new apex is the Delaunay-nearest point in
 * the half-space beyond plane beta of the edge. Then each half is triangulated in the
 * same way with its own points. The mesh is open: its boundary is determined by the
 * size constraint. The vertices are the input points, in their order. No normals are
 * needed; if the points have unit normals that mostly agree with those of their
 * neighbours, the mesh is oriented by them.
 *
 * With the rules \c Paper and \c Dense, every result has at most two triangles per
 * edge, one fan per vertex, no degenerate or duplicate faces, one orientation per
 * component (towards `sensor_origin_` of the cloud), and no edge that violates the size
 * constraint. With \c Paper and \c Strict, no input point is inside the smallest sphere
 * through the corners of a triangle by more than the relative tolerance 1e-6 of its
 * radius. The same input gives bitwise the same result for any number of threads.
 *
 * Coordinates are in metres. The time is O(n log n), the memory at most 170 bytes per
 * point, with \c Strict more (\ref acmap::estimateDeWallMemory).
 * \code
 * pcl::DeWallTriangulation<pcl::PointXYZ> dewall;
 * dewall.setInputCloud (cloud);
 * pcl::PolygonMesh mesh;
 * dewall.reconstruct (mesh);
 * \endcode
 * \ingroup surface
 */
template <typename PointInT>
class DeWallTriangulation : public MeshConstruction<PointInT>, public DeWallParameters {
public:
  using Ptr = shared_ptr<DeWallTriangulation<PointInT>>;
  using ConstPtr = shared_ptr<const DeWallTriangulation<PointInT>>;

  DeWallTriangulation();

  /** \brief Triangulates the input cloud, or its indices if they are set.
   * \param[out] mesh index triples into the whole input cloud; if no triangle is
   * possible, it is empty and the report contains the reason
   * \throws InitFailedException without an input cloud, or with indices outside of it
   * \throws MemoryLimitException when it would exceed the memory limit
   * \throws CancelledException when the progress callback requested to stop */
  void
  reconstruct(TriangleMesh& mesh);

  /** \brief As above, but returns PCL's mesh: the whole input cloud and its
   * polygons. */
  void
  reconstruct(PolygonMesh& output) override;

  /** \brief As above, but returns only the polygons. */
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
};

/** \brief The same for clouds of any fields, as files have them, and for rows that are
 * larger than the memory.
 *
 * While a \ref ScratchMemory exists, the arrays with a value for each point or triangle are
 * in files, except with \ref DeWallRule::Strict. If the cloud has float32 fields normal_x,
 * normal_y, normal_z, they are its normals. \ingroup surface */
template <>
class ACMAP_EXPORT DeWallTriangulation<PCLPointCloud2> : public DeWallParameters {
public:
  using Ptr = shared_ptr<DeWallTriangulation<PCLPointCloud2>>;
  using ConstPtr = shared_ptr<const DeWallTriangulation<PCLPointCloud2>>;

  /** \brief Sets the cloud, all of whose points are used. */
  void
  setInputCloud(const CloudRows& cloud)
  {
    rows_ = cloud;
  }

  /** \brief Sets the position of the sensor, which PCLPointCloud2 does not have, in metres
   * (default: the origin, if the points prove it, see \ref acmap::assessSensor). \throws BadArgumentException when it is not finite */
  void
  setSensorOrigin(const Eigen::Vector3f& origin);

  /** \brief Sets the scan from which the cloud was consolidated, all of whose points the sensor
   * measured. If its beams were in rings, automatic edges reach from ring to ring.
   * \param[in] scan it is kept; null: none (default)
   * \param[in] edge the longest automatic edge elsewhere, metres */
  void
  setScan(const CloudRows& scan, double edge)
  {
    scan_ = scan;
    scan_edge_ = edge;
  }

  /** \brief Triangulates the input cloud.
   * \param[out] mesh index triples into the input cloud; if no triangle is possible, it is
   * empty and the report contains the reason
   * \throws InitFailedException if there is no cloud, it has no float32 fields x, y, z side
   * by side, or fewer bytes than it states
   * \throws MemoryLimitException when it would exceed the memory limit
   * \throws CancelledException when the progress callback requested to stop */
  void
  reconstruct(TriangleMesh& mesh);

private:
  CloudRows rows_;
  Eigen::Vector3f sensor_origin_ = Eigen::Vector3f::Zero();
  bool is_sensor_stated_ = false;
  CloudRows scan_;
  double scan_edge_ = 0;
};

// PCL has no search trees compiled for our point types, and MeshConstruction names them
extern template class ACMAP_EXPORT MeshConstruction<PointXYZRGBNormalView>;
extern template class ACMAP_EXPORT MeshConstruction<PointXYZRGBSigma>;

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/surface/impl/dewall_triangulation.hpp>
#endif
