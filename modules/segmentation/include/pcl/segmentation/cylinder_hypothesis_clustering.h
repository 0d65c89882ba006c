#pragma once

#include <pcl/Vertices.h>
#include <pcl/core/build_config.h>
#include <pcl/core/cloud_rows.h>
#include <pcl/core/cylinder_patch.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/point_fields.h>
#include <pcl/core/noise_scale.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/stage_controls.h>
#include <pcl/core/triangle_mesh.h>
#include <pcl/pcl_base.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/cylinder_clustering_types.h>

#include <optional>
#include <utility>
#include <vector>

namespace pcl {

/** \brief Finds all cylinders of a cloud in one deterministic call: columns, pipes and
 * curved walls.
 *
 * It is future work (ii) of "Active Stereo Based Compact Mapping" (IV). A cylinder is
 * taken where the description of the scene becomes shorter: the bits of its parameters,
 * of its outline and of the residuals at the measured noise must be fewer than those of
 * the planes and of the free points that it replaces. A wall that is flat within its
 * noise therefore stays a plane. There is no random sampling.
 *
 * The input is one of these:
 * - the vertices of a mesh with normals (\ref setTriangles, \ref setInputNormals) and
 *   the planes that PlaneHypothesisClustering found on it (\ref setPlanes), which
 *   cylinders may replace;
 * - a clean cloud without normals, such as samples of a CAD model: the normals are those
 *   of local quadrics;
 * - a noisy raw cloud of a sensor, without mesh and normals: planes are found first, and
 *   cylinders among the rest, along the rays of the sensors if these are known
 *   (\ref setSourceCloud with the same cloud).
 *
 * With \ref setSourceCloud, each cylinder is fitted to the points of the source along
 * their rays, at the exact intersections with the cylinder.
 *
 * Units are metres, in the frame of the cloud. The result is the same in every run and
 * for any number of threads. The time is O(n log n) for n points.
 * \code
 * pcl::CylinderHypothesisClustering<pcl::PointNormal> clustering;
 * clustering.setInputCloud (consolidated);
 * clustering.setTriangles (mesh.polygons);
 * clustering.setPlanes (planes, plane_clustering.getLabels ());
 * std::vector<pcl::CylinderPatch> cylinders;
 * clustering.segment (cylinders);
 * \endcode
 * \ingroup segmentation
 */
template <typename PointT>
class CylinderHypothesisClustering : public PCLBase<PointT>,
                                     public StageControls<CylinderClusteringReport> {
public:
  using Ptr = shared_ptr<CylinderHypothesisClustering<PointT>>;
  using ConstPtr = shared_ptr<const CylinderHypothesisClustering<PointT>>;
  using PointCloudConstPtr = typename PCLBase<PointT>::PointCloudConstPtr;

  /** \brief Sets the normals, one per point of the cloud, towards the side from which it
   * was seen. If unset, those of PointT are used, or if it has none, normals are
   * computed. */
  void
  setInputNormals(const PointCloud<Normal>::ConstPtr& normals)
  {
    normals_ = normals;
  }

  /** \brief Sets the mesh whose vertices the points are: it defines the neighbours. */
  void
  setTriangles(const std::vector<Vertices>& polygons);

  void
  setTriangles(TriangleMesh mesh)
  {
    triangles_ = std::move(mesh.triangles);
  }

  /** \brief Sets the planes of the cloud, which cylinders may replace.
   * \param[in] planes as found by PlaneHypothesisClustering
   * \param[in] labels for each point of the input cloud the number of its plane, -1 for
   * none
   * \param[in] source_labels the same for the points of the source, or empty */
  void
  setPlanes(std::vector<PlanePatch> planes,
            std::vector<std::int32_t> labels,
            PointLabels source_labels = {})
  {
    planes_ = std::move(planes);
    plane_labels_ = std::move(labels);
    plane_source_labels_ = std::move(source_labels);
  }

  /** \brief Sets the cloud from which the input was consolidated; for a raw cloud this
   * cloud itself, if its sensors are known.
   * \param[in] cloud it is kept until another one is set
   * \param[in] viewpoints sensor positions of the observations to which the field
   * `view` of the cloud refers, in metres; without that field, the sensor position of
   * all points is sensor_origin_
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
  setSourceCloud(const CloudRows& cloud,
                 const std::vector<Eigen::Vector3f>& viewpoints = {});

  /** \brief Sets the noise scale of the source cloud where it has been measured before, by
   * measureNoiseScale with the same sensors (default: it is measured). To be set after
   * the source: another source has no known scale.
   * \throws BadArgumentException when sigma or spacing are negative or not finite */
  void
  setSourceScale(const NoiseScale& scale);

  /** \brief Sets the limits of the radius in metres (default: 0, 1e9, none).
   * \throws BadArgumentException unless 0 <= min_radius <= max_radius and both are
   * finite */
  void
  setRadiusLimits(double min_radius, double max_radius);

  void
  getRadiusLimits(double& min_radius, double& max_radius) const
  {
    min_radius = min_radius_;
    max_radius = max_radius_;
  }

  /** \brief Sets the standard deviation of the points across their surface in metres,
   * along the rays for a raw cloud with sensors (default 0: measured).
   * \throws BadArgumentException when it is negative or not finite */
  void
  setNoise(double sigma);

  double
  getNoise() const
  {
    return sigma_;
  }

  /** \brief Finds all cylinders of the input cloud, or of its indices if they are set.
   * \param[out] patches the cylinders in order of decreasing area; if empty, the report
   * contains the reason
   * \throws InitFailedException without a cloud, if the numbers of normals or labels
   * differ from those of the points, or with indices, labels or triangle corners outside
   * of the cloud
   * \throws CancelledException when the progress callback requested to stop */
  void
  segment(std::vector<CylinderPatch>& patches);

  /** \brief Same as segment, but returns the point indices of each cylinder, as
   * RegionGrowing does. */
  void
  extract(std::vector<PointIndices>& clusters);

  /** \brief For each point of the input cloud the number of its cylinder in the last
   * result, -1 for none. */
  const std::vector<std::int32_t>&
  getLabels() const
  {
    return labels_;
  }

  /** \brief For each point of the source cloud the number of its cylinder; empty without
   * a source cloud. */
  const PointLabels&
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

  LargeVector<Eigen::Vector3f>
  gatherNormals() const;

  /** The sensors of the points, which have the observations of the source. */
  acmap::SensorView
  pointSensors(const std::int32_t* chosen) const;

  PointCloud<Normal>::ConstPtr normals_;
  TriangleMesh::Triangles triangles_;
  std::vector<PlanePatch> planes_;
  std::vector<std::int32_t> plane_labels_;
  PointLabels plane_source_labels_;
  shared_ptr<const void> source_;
  acmap::PointView source_points_;
  acmap::SensorView source_sensors_;
  std::vector<Eigen::Vector3f> viewpoints_; ///< of the source
  double min_radius_ = 0;
  double max_radius_ = 1e9;
  double sigma_ = 0;
  std::optional<NoiseScale> source_scale_;
  std::vector<std::int32_t> labels_;
  PointLabels source_labels_;
};

template <typename PointT>
template <typename SourceT>
void
CylinderHypothesisClustering<PointT>::setSourceCloud(
    const shared_ptr<const PointCloud<SourceT>>& cloud,
    const std::vector<Eigen::Vector3f>& viewpoints)
{
  acmap::requireViewpoints(viewpoints);
  source_scale_.reset();
  source_ = cloud;
  const bool is_empty = !cloud || cloud->empty();
  source_points_ =
      is_empty ? acmap::PointView()
               : acmap::PointView(&cloud->front().x, sizeof(SourceT), cloud->size());
  source_sensors_ =
      is_empty ? acmap::SensorView() : acmap::sensorsOf(*cloud, viewpoints);
  viewpoints_ = is_empty ? std::vector<Eigen::Vector3f>() : viewpoints;
  if (!is_empty && !acmap::has_view<SourceT>)
    viewpoints_ = {cloud->sensor_origin_.template head<3>()};
}

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/cylinder_hypothesis_clustering.hpp>
#endif
