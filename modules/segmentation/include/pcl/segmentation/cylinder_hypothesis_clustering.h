#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/cloud_rows.h>
#include <pcl/core/cylinder_patch.h>
#include <pcl/core/export.h>
#include <pcl/core/noise_scale.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/stage_controls.h>
#include <pcl/pcl_base.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/clustering_inputs.h>
#include <pcl/segmentation/cylinder_clustering_types.h>
#include <pcl/segmentation/impl/cylinder_clustering_kernel.h>

#include <utility>
#include <vector>

namespace pcl {

/** \brief Settings and results of \ref CylinderHypothesisClustering, for clouds of points
 * and of rows. \ingroup segmentation */
class ACMAP_EXPORT CylinderClusteringParameters
: public ClusteringInputs,
  public StageControls<CylinderClusteringReport> {
public:
  /** \brief Sets the planes of the cloud, which cylinders may replace.
   * \param[in] planes as found by PlaneHypothesisClustering
   * \param[in] labels for each point of the input cloud the number of its plane, -1 for
   * none
   * \param[in] source_labels the same for the points of the source, or empty */
  void
  setPlanes(std::vector<PlanePatch> planes,
            PointLabels labels,
            PointLabels source_labels = {})
  {
    planes_ = std::move(planes);
    plane_labels_ = std::move(labels);
    plane_source_labels_ = std::move(source_labels);
  }

  /** \brief Sets the cloud from which the input was consolidated, see
   * \ref ClusteringInputs; for a raw cloud this cloud itself, if its sensors are
   * known. */
  template <typename Cloud>
  void
  setSourceCloud(const Cloud& cloud,
                 const std::vector<Eigen::Vector3f>& viewpoints = {})
  {
    settings_.source_scale.reset();
    ClusteringInputs::setSourceCloud(cloud, viewpoints);
  }

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
    min_radius = settings_.min_radius;
    max_radius = settings_.max_radius;
  }

  /** \brief Sets the standard deviation of the points across their surface in metres,
   * along the rays for a raw cloud with sensors (default 0: measured).
   * \throws BadArgumentException when it is negative or not finite */
  void
  setNoise(double sigma);

  double
  getNoise() const
  {
    return settings_.sigma;
  }

  /** \brief All settings. */
  acmap::CylinderClusteringSettings
  settings() const;

protected:
  CylinderClusteringParameters() = default;

  /** \brief Throws InitFailedException if the planes do not belong to the points. */
  void
  requirePlanes(std::size_t points) const;

  /** \brief Finds the cylinders of hypotheses.
   * \param[in] chosen indices of these points, nullptr if they are all
   * \param[in] points number of points of the cloud */
  std::vector<CylinderPatch>
  cluster(acmap::PlaneHypotheses hypotheses,
          const std::vector<std::int32_t>* chosen,
          std::size_t points);

private:
  std::vector<PlanePatch> planes_;
  PointLabels plane_labels_;
  PointLabels plane_source_labels_;
  acmap::CylinderClusteringSettings settings_;
};

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
 * - the vertices of a mesh with normals (\ref ClusteringInputs::setTriangles, \ref setInputNormals) and
 *   the planes that PlaneHypothesisClustering found on it (\ref CylinderClusteringParameters::setPlanes), which
 *   cylinders may replace;
 * - a clean cloud without normals, such as samples of a CAD model: the normals are those
 *   of local quadrics;
 * - a noisy raw cloud of a sensor, without mesh and normals: planes are found first, and
 *   cylinders among the rest, along the rays of the sensors if these are known
 *   (\ref CylinderClusteringParameters::setSourceCloud with the same cloud).
 *
 * With \ref CylinderClusteringParameters::setSourceCloud, each cylinder is fitted to the points of the source along
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
                                     public CylinderClusteringParameters {
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

protected:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;

private:
  PointCloud<Normal>::ConstPtr normals_;
};

/** \brief The same for clouds of any fields, as files have them, and for rows that are
 * larger than the memory. \ingroup segmentation */
template <>
class ACMAP_EXPORT CylinderHypothesisClustering<PCLPointCloud2>
: public CylinderClusteringParameters {
public:
  using Ptr = shared_ptr<CylinderHypothesisClustering<PCLPointCloud2>>;
  using ConstPtr = shared_ptr<const CylinderHypothesisClustering<PCLPointCloud2>>;

  /** \brief Sets the cloud, all of whose points are used. */
  void
  setInputCloud(const CloudRows& cloud)
  {
    rows_ = cloud;
  }

  /** \brief Sets the normals, one row per point, towards the side from which it was
   * seen: float32 fields normal_x, normal_y, normal_z side by side. If unset, those of
   * the cloud are used, or if it has none, normals are computed. */
  void
  setInputNormals(const CloudRows& normals)
  {
    normals_ = normals;
  }

  /** \brief Finds all cylinders of the input cloud.
   * \param[out] patches as those of the class of point types
   * \throws InitFailedException without a cloud, if the numbers of normals or labels
   * differ from those of the points, or with labels or triangle corners outside of the
   * cloud
   * \throws CancelledException when the progress callback requested to stop */
  void
  segment(std::vector<CylinderPatch>& patches);

private:
  CloudRows rows_;
  CloudRows normals_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/cylinder_hypothesis_clustering.hpp>
#endif
