#pragma once

#include <pcl/Vertices.h>
#include <pcl/core/build_config.h>
#include <pcl/core/export.h>
#include <pcl/core/point_types.h>
#include <pcl/core/stage_controls.h>
#include <pcl/core/triangle_mesh.h>
#include <pcl/features/feature.h>
#include <pcl/features/voting_types.h>
#include <pcl/point_types.h>

#include <utility>
#include <vector>

namespace pcl {

/** \brief Normals at the vertices of a triangle mesh, each voted for by the triangles
 * around it, and the creases between walls.
 *
 * Normal vector voting of Page et al., the step of "Active Stereo Based Compact Mapping"
 * from the mesh to plane hypotheses (II-C.2). A triangle i with normal n_i and centre c_i,
 * within the geodesic distance g_max of vertex v, votes for the normal of the circular arc
 * through v and c_i, N_i = n_i - 2 (n_i u) u, u = (c_i - v) / |c_i - v|. The votes are
 * summed as V_v = sum w_i N_i N_i^T, w_i = A_i exp (-g_i / (g_max / 3)) (1 - (n_i u)^2);
 * its eigenvalues l1 >= l2 >= l3 tell what is there: a surface (l1 - l2 prevails), a crease
 * (eps (l2 - l3)) or a corner (eps eta l3), and e1 is the normal. The last factor of the
 * weight is ours: a triangle that is seen from the vertex edge-on would vote backwards.
 *
 * Any triangle or polygon mesh will do; polygons are split into fans. On noisy points put
 * VoxelConsolidation and DeWallTriangulation before it. Normals look where the sensor
 * stood that saw the vertex, where the points have a field `view` and the viewpoints are
 * set; else to the side from which the faces are counter-clockwise.
 *
 * Output: unit normals, `curvature` = 1 - (l1 - l2) / (l1 + l2 + l3), 0 on a plane; NaN
 * at vertices that less than three triangles around could vote for. Metres. Time O(n) by
 * the triangles in a disc; the same bytes for every number of threads.
 * \code
 * pcl::NormalVectorVoting<pcl::PointXYZ> voting;
 * voting.setInputCloud (cloud);
 * voting.setTriangles (mesh.polygons);
 * pcl::PointCloud<pcl::Normal> normals;
 * voting.compute (normals);
 * \endcode
 * \ingroup features
 */
template <typename PointInT>
class NormalVectorVoting : public Feature<PointInT, Normal>,
                           public StageControls<VotingReport> {
public:
  using Ptr = shared_ptr<NormalVectorVoting<PointInT>>;
  using ConstPtr = shared_ptr<const NormalVectorVoting<PointInT>>;
  using PointCloudOut = typename Feature<PointInT, Normal>::PointCloudOut;

  NormalVectorVoting();

  /** \brief Sets the mesh: polygons with corners in the input cloud, as in a
   * pcl::PolygonMesh. Its corners are checked by \ref compute. */
  void
  setTriangles(const std::vector<Vertices>& polygons);

  /** \brief Sets the mesh as flat triples. */
  void
  setTriangles(TriangleMesh mesh)
  {
    triangles_ = std::move(mesh.triangles);
  }

  const std::vector<TriangleMesh::Triangle>&
  getTriangles() const
  {
    return triangles_;
  }

  /** \brief Sets g_max, how far along the surface the votes come from.
   * \param[in] radius metres; 0 (default): automatic, 2.5 mean edges, and 8 times the
   * noise where that is more, up to 8 edges
   * \throws BadArgumentException when negative or not finite */
  void
  setRadiusSearch(double radius);

  /** \brief Sets eps, how much a crease counts against a surface: two equal faces whose
   * normals are 2 phi apart are a crease from sin^2 phi = 1 / (2 + eps) on. The default of
   * 12 finds edges of walls within a voxel; Page et al. name 2.
   * \throws BadArgumentException unless it is above 0 and finite */
  void
  setCreaseWeight(double eps);

  double
  getCreaseWeight() const
  {
    return crease_weight_;
  }

  /** \brief Sets eta, how much a corner counts against a crease (default 0.3).
   * \throws BadArgumentException unless it is above 0 and finite */
  void
  setCornerWeight(double eta);

  double
  getCornerWeight() const
  {
    return corner_weight_;
  }

  /** \brief Sets where the observations stood that the points' field `view` names, in
   * metres, in the frame of the cloud. \throws BadArgumentException when one is not finite
   */
  void
  setViewpoints(std::vector<Eigen::Vector3f> viewpoints);

  const std::vector<Eigen::Vector3f>&
  getViewpoints() const
  {
    return viewpoints_;
  }

  /** \brief Asks for \ref getPrincipalCurvatures (default false), Page's second pass: the
   * vertices around vote for the curvature along their direction, by arcs between normals;
   * the least squares of these are solved. */
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

  /** \brief Votes at each vertex (at the indices, where set; all triangles vote).
   * \param[out] output one normal a vertex, in the order of the cloud (or indices)
   * \throws InitFailedException without an input cloud, with indices or corners outside
   * of it
   * \throws CancelledException when the progress callback stopped it */
  void
  compute(PointCloudOut& output);

  /** \brief The VertexClass of each output point of the last run, as label. */
  void
  getVertexClasses(PointCloud<Label>& classes) const
  {
    classes = classes_;
  }

  /** \brief The principal curvatures at each output point of the last run, 1/m, pc1 the
   * larger by magnitude; positive where the surface bends away from the normal, as a ball
   * seen from outside; NaN off surfaces. Empty unless asked for. */
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
  std::vector<TriangleMesh::Triangle> triangles_;
  double crease_weight_ = 12;
  double corner_weight_ = 0.3;
  std::vector<Eigen::Vector3f> viewpoints_;
  bool compute_curvatures_ = false;
  PointCloud<Label> classes_;
  PointCloud<PrincipalCurvatures> curvatures_;
};

// PCL has no search trees compiled for our point types, and Feature names them
extern template class ACMAP_EXPORT Feature<PointXYZRGBNormalView, Normal>;
extern template class ACMAP_EXPORT Feature<PointXYZRGBSigma, Normal>;

} // namespace pcl
