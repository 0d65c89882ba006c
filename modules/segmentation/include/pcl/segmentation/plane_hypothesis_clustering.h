#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/Vertices.h>
#include <pcl/core/arguments.h>
#include <pcl/core/build_config.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/point_fields.h>
#include <pcl/core/stage_controls.h>
#include <pcl/core/triangle_mesh.h>
#include <pcl/pcl_base.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/plane_clustering_types.h>

#include <optional>
#include <utility>
#include <vector>

namespace pcl {

/** \brief All planes of a cloud with normals, in one call and without chance.
 *
 * The clustering of "Active Stereo Based Compact Mapping" (II-C.2). Each point is a
 * hypothesis (p_i, n_i). From the flattest one on (by the curvature of the normals that
 * \ref setInputNormals gives; those of PointT go in their order), a plane takes in whoever
 * is nearer than W_d to one of its points, than W_n to its normal and than W_t to the plane, and is
 * estimated again with its supporters; above W_h of them it is accepted. These are the
 * defaults.
 *
 * With \ref setNoiseDriven the mesh tells who is a neighbour, the noise of the points how
 * far they may be off, and the area what is accepted: the paper's W_t of 0.25 m swallows
 * doors. Planes that are one are joined, however far apart; curved surfaces are told apart
 * and counted. Where the cloud from which the points were consolidated is given too
 * (\ref setSourceCloud), its points judge the planes, narrow ones between larger ones
 * (reveals of doors) are found as well, and each plane is fitted to its points along the
 * rays of their sensors.
 *
 * Metres, frame of the cloud. Normals look where those of the points do. The same answer
 * at every run and for every number of threads. Time O(n) with a mesh; by W_d each point
 * looks at all within, so bring raw clouds to their noise scale first.
 * \code
 * pcl::PlaneHypothesisClustering<pcl::PointNormal> clustering;
 * clustering.setInputCloud (consolidated);
 * clustering.setTriangles (mesh.polygons);
 * clustering.setNoiseDriven (true);
 * std::vector<pcl::PlanePatch> planes;
 * clustering.segment (planes);
 * \endcode
 * \ingroup segmentation
 */
template <typename PointT>
class PlaneHypothesisClustering : public PCLBase<PointT>,
                                  public StageControls<PlaneClusteringReport> {
public:
  using Ptr = shared_ptr<PlaneHypothesisClustering<PointT>>;
  using ConstPtr = shared_ptr<const PlaneHypothesisClustering<PointT>>;
  using PointCloudConstPtr = typename PCLBase<PointT>::PointCloudConstPtr;

  /** \brief Sets the normals n_i, one a point of the cloud; unset: those of PointT. */
  void
  setInputNormals(const PointCloud<Normal>::ConstPtr& normals)
  {
    normals_ = normals;
  }

  /** \brief Sets what NormalVectorVoting says of the points: no plane starts at a crease.
   */
  void
  setVertexClasses(const PointCloud<Label>::ConstPtr& classes)
  {
    classes_ = classes;
  }

  /** \brief Sets the mesh whose corners the points are; it gives the planes their outlines,
   * and with \ref setNoiseDriven their neighbourhood. */
  void
  setTriangles(const std::vector<Vertices>& polygons);

  void
  setTriangles(TriangleMesh mesh)
  {
    triangles_ = std::move(mesh.triangles);
  }

  /** \brief Sets the cloud from which the input was consolidated; used with
   * \ref setNoiseDriven.
   * \param[in] cloud kept until another one is set
   * \param[in] viewpoints where the observations stood that its field `view` names, in
   * metres; without that field its points were seen from its sensor_origin_
   * \throws BadArgumentException when a viewpoint is not finite */
  template <typename SourceT>
  void
  setSourceCloud(const shared_ptr<const PointCloud<SourceT>>& cloud,
                 const std::vector<Eigen::Vector3f>& viewpoints = {});

  template <typename SourceT>
  void
  setSourceCloud(const shared_ptr<PointCloud<SourceT>>& cloud,
                 const std::vector<Eigen::Vector3f>& viewpoints = {})
  {
    setSourceCloud(shared_ptr<const PointCloud<SourceT>>(cloud), viewpoints);
  }

  /** \brief The same for a cloud of any fields, as files have them.
   * \param[in] viewpoints of a cloud without an int32 field `view`: the position of its
   * sensor alone, or none where that is unknown
   * \throws InitFailedException if it has no float32 fields x, y, z side by side */
  void
  setSourceCloud(const PCLPointCloud2ConstPtr& cloud,
                 const std::vector<Eigen::Vector3f>& viewpoints = {});

  /** \brief Estimates how long \ref segment will take with the paper's thresholds, which
   * compare each point with all others within W_d.
   * \return seconds on a processor of 2020; 0 without a cloud, with \ref setNoiseDriven,
   * and if no point has a normal */
  double
  estimateSeconds() const;

  /** \brief Lets noise and mesh decide instead of the paper's thresholds (default false).
   */
  void
  setNoiseDriven(bool noise_driven)
  {
    noise_driven_ = noise_driven;
  }

  bool
  getNoiseDriven() const
  {
    return noise_driven_;
  }

  /** \brief Sets W_d, metres (default 0.8): how near a supporter is to one of the others.
   * \throws BadArgumentException unless it is above 0 and finite, here and below */
  void
  setClusterTolerance(double distance);

  double
  getClusterTolerance() const
  {
    return member_distance_;
  }

  /** \brief Sets W_n, radians (default pi / 8), up to pi / 2. */
  void
  setSmoothnessThreshold(double angle);

  double
  getSmoothnessThreshold() const
  {
    return normal_angle_;
  }

  /** \brief Sets W_t, metres (default 0.25; by the noise, where that decides). */
  void
  setDistanceThreshold(double distance);

  double
  getDistanceThreshold() const
  {
    return plane_distance_.value_or(noise_driven_ ? 0 : paper_distance);
  }

  /** \brief Sets W_h (default 50): a plane has more supporters; unless noise decides. */
  void
  setMinClusterSize(std::size_t support)
  {
    least_support_ = support;
  }

  std::size_t
  getMinClusterSize() const
  {
    return least_support_;
  }

  /** \brief Sets the least area of a plane; where noise decides.
   * \param[in] area square metres; 0 (default): automatic, 0.1, or 0.3 % of all the surface
   * where that is less
   * \throws BadArgumentException when negative or not finite */
  void
  setMinArea(double area);

  double
  getMinArea() const
  {
    return least_area_;
  }

  /** \brief Turns planes about their centres to be exactly parallel or at right angles to
   * larger ones (default false), by at most three standard deviations of their tilt and a
   * degree; the report says how many and how far. */
  void
  setRegularize(bool regularize)
  {
    regularize_ = regularize;
  }

  bool
  getRegularize() const
  {
    return regularize_;
  }

  /** \brief Finds all planes of the input cloud (of its indices, where set).
   * \param[out] patches the planes by falling area, without a mesh, where it is 0, those
   * grown larger first; none, with the reason in the report, where there are none
   * \throws InitFailedException without a cloud or normals, with normals or classes of
   * another number, with indices or corners outside of the cloud
   * \throws CancelledException when the progress callback stopped it */
  void
  segment(std::vector<PlanePatch>& patches);

  /** \brief The same as the points of each plane, as RegionGrowing gives them. */
  void
  extract(std::vector<PointIndices>& clusters);

  /** \brief For each point of the input cloud the position of its plane in the last
   * result, -1 for none. */
  const std::vector<std::int32_t>&
  getLabels() const
  {
    return labels_;
  }

  /** \brief The same for each point of the source cloud; empty without one. */
  const std::vector<std::int32_t>&
  getSourceLabels() const
  {
    return source_labels_;
  }

protected:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;

private:
  void
  requireInputs() const;

  std::vector<Eigen::Vector3f>
  gatherNormals() const;

  static constexpr double paper_distance = 0.25;

  PointCloud<Normal>::ConstPtr normals_;
  PointCloud<Label>::ConstPtr classes_;
  std::vector<TriangleMesh::Triangle> triangles_;
  shared_ptr<const void> source_;
  acmap::PointView source_points_;
  acmap::SensorView source_sensors_;
  bool noise_driven_ = false;
  double member_distance_ = 0.8;
  double normal_angle_ = 0.39269908169872414;
  std::optional<double> plane_distance_;
  std::size_t least_support_ = 50;
  double least_area_ = 0;
  bool regularize_ = false;
  std::vector<std::int32_t> labels_;
  std::vector<std::int32_t> source_labels_;
};

template <typename PointT>
template <typename SourceT>
void
PlaneHypothesisClustering<PointT>::setSourceCloud(
    const shared_ptr<const PointCloud<SourceT>>& cloud,
    const std::vector<Eigen::Vector3f>& viewpoints)
{
  acmap::requireViewpoints(viewpoints);
  source_ = cloud;
  const bool is_empty = !cloud || cloud->empty();
  source_points_ =
      is_empty ? acmap::PointView()
               : acmap::PointView(&cloud->front().x, sizeof(SourceT), cloud->size());
  source_sensors_ =
      is_empty ? acmap::SensorView() : acmap::sensorsOf(*cloud, viewpoints);
}

} // namespace pcl
