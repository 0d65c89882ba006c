#pragma once

#include <pcl/Vertices.h>
#include <pcl/core/build_config.h>
#include <pcl/core/cloud_rows.h>
#include <pcl/core/export.h>
#include <pcl/core/point_types.h>
#include <pcl/core/stage_controls.h>
#include <pcl/core/triangle_mesh.h>
#include <pcl/features/feature.h>
#include <pcl/features/impl/voting_kernel.h>
#include <pcl/features/voting_types.h>
#include <pcl/point_types.h>

#include <optional>
#include <utility>
#include <vector>

namespace pcl {

/** \brief Settings of \ref NormalVectorVoting, for clouds of points and of rows.
 * \ingroup features */
class ACMAP_EXPORT VotingParameters : public StageControls<VotingReport> {
public:
  /** \brief Sets the mesh: polygons with corners in the input cloud, as in a
   * pcl::PolygonMesh. The corners are checked by \c compute. */
  void
  setTriangles(const std::vector<Vertices>& polygons);

  /** \brief Sets the mesh as index triples. */
  void
  setTriangles(TriangleMesh mesh)
  {
    triangles_ = std::move(mesh.triangles);
  }

  const TriangleMesh::Triangles&
  getTriangles() const
  {
    return triangles_;
  }

  /** \brief Uses the weights of Page et al. as they are (default false):
   * w_i = A_i exp (-g_i / (g_max / 3)), without the factor (1 - (n_i u)^2), eps = 2 and
   * eta = 2. All triangles within g_max vote, however near they are, and only those:
   * the radius is not doubled where few vote, and one vote is enough for a normal. */
  void
  setPaperMode(bool paper_mode)
  {
    settings_.paper = paper_mode;
  }

  bool
  getPaperMode() const
  {
    return settings_.paper;
  }

  /** \brief Sets g_max, the maximum geodesic distance of the votes.
   * \param[in] radius metres; 0 (default) for automatic: 2.5 mean edges, or 8 times the
   * noise if that is more, up to 8 mean edges
   * \throws BadArgumentException when negative or not finite */
  void
  setRadiusSearch(double radius);

  double
  getRadiusSearch() const
  {
    return settings_.radius;
  }

  /** \brief Sets eps, the weight of a crease relative to a surface: two equal faces
   * whose normals differ by 2 phi are a crease if sin^2 phi >= 1 / (2 + eps). The
   * default of 12 detects the edges of walls within a voxel; Page et al. use 2, the
   * default in paper mode.
   * \throws BadArgumentException unless it is above 0 and finite */
  void
  setCreaseWeight(double eps);

  double
  getCreaseWeight() const
  {
    return settings_.creaseWeight();
  }

  /** \brief Sets eta, the weight of a corner relative to a crease (default 0.3; in
   * paper mode 2).
   * \throws BadArgumentException unless it is above 0 and finite */
  void
  setCornerWeight(double eta);

  double
  getCornerWeight() const
  {
    return settings_.cornerWeight();
  }

  /** \brief Sets the sensor positions of the observations given by the field `view` of
   * the points, in metres, in the frame of the cloud.
   * \throws BadArgumentException when one is not finite */
  void
  setViewpoints(std::vector<Eigen::Vector3f> viewpoints);

  const std::vector<Eigen::Vector3f>&
  getViewpoints() const
  {
    return viewpoints_;
  }

  /** \brief All settings. */
  acmap::VotingSettings
  settings() const;

protected:
  VotingParameters() = default;

  TriangleMesh::Triangles triangles_;
  std::vector<Eigen::Vector3f> viewpoints_;

private:
  acmap::VotingSettings settings_;
};

/** \brief Estimates the normals at the vertices of a triangle mesh by votes of the
 * surrounding triangles, and detects the creases between walls.
 *
 * This is the normal vector voting of Page et al., the step of
 * "Active Stereo Based Compact Mapping" from the mesh to plane hypotheses (II-C.2). A
 * triangle i with normal n_i and centre c_i, within the geodesic distance g_max of
 * vertex v, votes for the normal of the circular arc through v and c_i,
 * N_i = n_i - 2 (n_i u) u, u = (c_i - v) / |c_i - v|, summed as V_v = sum w_i N_i N_i^T,
 * w_i = A_i exp (-g_i / (g_max / 3)) (1 - (n_i u)^2); the eigenvector e1 of the largest
 * eigenvalue is the normal. With the eigenvalues l1 >= l2 >= l3, the largest of l1 - l2
 * (surface), eps (l2 - l3) (crease) and eps eta l3 (corner) gives the class of the
 * vertex. The last factor of the weight is an addition to the method: it suppresses
 * triangles that are seen edge-on from the vertex, whose votes would point backwards.
 * \ref VotingParameters::setPaperMode takes this and all other additions back.
 *
 * Any triangle or polygon mesh can be used; polygons are split into fans. For noisy
 * points apply VoxelConsolidation and DeWallTriangulation first. If the points have a
 * field `view` and the viewpoints are set, the normals point towards the sensor that
 * saw the vertex, otherwise to the side from which the faces are counter-clockwise.
 *
 * Output: unit normals, `curvature` = 1 - (l1 - l2) / (l1 + l2 + l3), 0 on a plane; NaN
 * at vertices with fewer than three votes, in paper mode without a vote. Metres. Takes O(n) times the number of
 * triangles per disc; the result is bitwise identical for every number of threads.
 * \code
 * pcl::NormalVectorVoting<pcl::PointXYZ> voting;
 * voting.setInputCloud (cloud);
 * voting.setTriangles (mesh.polygons);
 * pcl::PointCloud<pcl::Normal> normals;
 * voting.compute (normals);
 * \endcode
 * \ingroup features */
template <typename PointInT>
class NormalVectorVoting : public Feature<PointInT, Normal>, public VotingParameters {
public:
  using Ptr = shared_ptr<NormalVectorVoting<PointInT>>;
  using ConstPtr = shared_ptr<const NormalVectorVoting<PointInT>>;
  using PointCloudOut = typename Feature<PointInT, Normal>::PointCloudOut;

  NormalVectorVoting();

  /** \brief See \ref VotingParameters. */
  void
  setRadiusSearch(double radius)
  {
    VotingParameters::setRadiusSearch(radius);
    search_radius_ = radius;
  }

  using Feature<PointInT, Normal>::getRadiusSearch;

  /** \brief Enables \ref getPrincipalCurvatures (default false), the second pass of
   * Page et al.: the surrounding vertices vote for the curvature along their direction,
   * by arcs between normals; the votes are combined by least squares. */
  void
  setComputeCurvatures(bool compute)
  {
    compute_curvatures_ = compute;
  }

  bool
  getComputeCurvatures() const
  {
    return compute_curvatures_;
  }

  /** \brief Computes the normals at all vertices, or at the indices if they are set;
   * all triangles vote.
   * \param[out] output one normal per vertex, in the order of the cloud (or indices)
   * \throws InitFailedException without an input cloud, or if indices or corners are
   * out of range
   * \throws CancelledException when the progress callback stopped it */
  void
  compute(PointCloudOut& output);

  /** \brief Returns the VertexClass of each output point of the last run as label. */
  void
  getVertexClasses(PointCloud<Label>& classes) const
  {
    classes = classes_;
  }

  /** \brief Returns the principal curvatures at each output point of the last run, 1/m;
   * pc1 has the larger magnitude. They are positive if the surface bends away from the
   * normal, such as a sphere seen from outside, and NaN at vertices that are not of
   * class Surface. Empty unless enabled by \ref setComputeCurvatures. */
  void
  getPrincipalCurvatures(PointCloud<PrincipalCurvatures>& curvatures) const
  {
    curvatures = curvatures_;
  }

protected:
  using Feature<PointInT, Normal>::input_;
  using Feature<PointInT, Normal>::indices_;
  using Feature<PointInT, Normal>::search_radius_;
  using Feature<PointInT, Normal>::feature_name_;

  bool
  initCompute() override;

  void
  computeFeature(PointCloudOut& output) override;

private:
  bool compute_curvatures_ = false;
  PointCloud<Label> classes_;
  PointCloud<PrincipalCurvatures> curvatures_;
};

/** \brief The same for clouds of any fields, as files have them, and for rows that are
 * larger than the memory. \ingroup features */
template <>
class ACMAP_EXPORT NormalVectorVoting<PCLPointCloud2> : public VotingParameters {
public:
  using Ptr = shared_ptr<NormalVectorVoting<PCLPointCloud2>>;
  using ConstPtr = shared_ptr<const NormalVectorVoting<PCLPointCloud2>>;

  /** \brief Sets the cloud, all of whose points are vertices. */
  void
  setInputCloud(const CloudRows& cloud)
  {
    rows_ = cloud;
  }

  /** \brief Sets the position of the one sensor that saw all points, in metres; used
   * without viewpoints (default: unknown).
   * \throws BadArgumentException when it is not finite */
  void
  setSensorOrigin(const Eigen::Vector3f& origin);

  /** \brief Computes the normals at all vertices.
   * \param[out] output one row per vertex: float32 normal_x, normal_y, normal_z,
   * curvature, and uint8 vertex_class, which is a \ref VertexClass; in a file while a
   * \ref ScratchMemory exists
   * \throws InitFailedException if there is no cloud, it has no float32 fields x, y, z
   * side by side or fewer bytes than it states, or if corners are out of range
   * \throws CancelledException when the progress callback stopped it */
  void
  compute(CloudRows& output);

private:
  acmap::SensorView
  sensors() const;

  CloudRows rows_;
  std::optional<Eigen::Vector3f> sensor_origin_;
};

// PCL's search trees are not instantiated for our point types, but Feature uses them
extern template class ACMAP_EXPORT Feature<PointXYZRGBNormalView, Normal>;
extern template class ACMAP_EXPORT Feature<PointXYZRGBSigma, Normal>;

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/features/impl/normal_vector_voting.hpp>
#endif
