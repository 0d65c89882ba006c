#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/cloud_rows.h>
#include <pcl/core/export.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/stage_controls.h>
#include <pcl/pcl_base.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/clustering_inputs.h>
#include <pcl/segmentation/impl/plane_clustering_kernel.h>
#include <pcl/segmentation/plane_clustering_types.h>

#include <optional>
#include <vector>

namespace pcl {

/** \brief Settings and results of \ref PlaneHypothesisClustering, for clouds of points
 * and of rows. \ingroup segmentation */
class ACMAP_EXPORT PlaneClusteringParameters
: public ClusteringInputs,
  public StageControls<PlaneClusteringReport> {
public:
  /** \brief Grows planes as noise and mesh allow (default true), or, if false, by the
   * paper's thresholds, to the letter. */
  void
  setNoiseDriven(bool noise_driven)
  {
    settings_.noise_driven = noise_driven;
  }

  bool
  getNoiseDriven() const
  {
    return settings_.noise_driven;
  }

  /** \brief Sets from which points W_d is measured (default Members, by which walls become
   * whole as in Figs. 8 to 10). Not used if noise-driven. */
  void
  setSupporterReach(SupporterReach reach)
  {
    settings_.reach = reach;
  }

  SupporterReach
  getSupporterReach() const
  {
    return settings_.reach;
  }

  /** \brief Sets W_d in metres (default 0.8): the maximum distance of a supporter from
   * the points of \ref setSupporterReach. Not used if noise-driven.
   * \throws BadArgumentException unless it is above 0 and finite, here and below */
  void
  setClusterTolerance(double distance);

  double
  getClusterTolerance() const
  {
    return settings_.member_distance;
  }

  /** \brief Sets W_n in radians (default pi / 8, maximum pi / 2). */
  void
  setSmoothnessThreshold(double angle);

  double
  getSmoothnessThreshold() const
  {
    return settings_.normal_angle;
  }

  /** \brief Sets W_t in metres (default: computed from the noise; with the paper's
   * thresholds 0.25). */
  void
  setDistanceThreshold(double distance);

  /** \brief W_t in metres as it was set; otherwise the paper's with its thresholds, and
   * nothing if it is computed from the noise. */
  std::optional<double>
  getDistanceThreshold() const;

  /** \brief Sets W_h (default 50): a hypothesis needs more supporters than this, itself
   * not counted. Not used if noise-driven. */
  void
  setMinClusterSize(std::size_t support)
  {
    settings_.min_support = support;
  }

  std::size_t
  getMinClusterSize() const
  {
    return settings_.min_support;
  }

  /** \brief Sets the minimum area of a plane; used if noise-driven.
   * \param[in] area square metres; 0 (default) is automatic: 0.1, or 0.3 % of the total
   * surface if that is smaller
   * \throws BadArgumentException when it is negative or not finite */
  void
  setMinArea(double area);

  double
  getMinArea() const
  {
    return settings_.min_area;
  }

  /** \brief Rotates planes about their centres to be exactly parallel or perpendicular
   * to larger ones (default false), by at most three standard deviations of their tilt
   * and at most one degree. The report contains their number and the maximum
   * rotation. */
  void
  setRegularize(bool regularize)
  {
    settings_.regular = regularize;
  }

  bool
  getRegularize() const
  {
    return settings_.regular;
  }

  /** \brief All settings. */
  acmap::PlaneClusteringSettings
  settings() const;

protected:
  PlaneClusteringParameters() = default;

  /** \brief Finds the planes of hypotheses.
   * \param[in] chosen indices of these points, nullptr if they are all
   * \param[in] points number of points of the cloud */
  std::vector<PlanePatch>
  cluster(acmap::PlaneHypotheses hypotheses,
          const std::vector<std::int32_t>* chosen,
          std::size_t points);

  /** \brief See PlaneHypothesisClustering::estimateSeconds. */
  double
  secondsOf(const acmap::PointView& points, const acmap::PointView& normals) const;

private:
  acmap::PlaneClusteringSettings settings_;
};

/** \brief Finds all planes of a cloud with normals in one deterministic call.
 *
 * This is the clustering of "Active Stereo Based Compact Mapping" (II-C.2). Each point
 * is a hypothesis (p_i, n_i). Hypotheses are tried in the order of their curvature, if
 * the normals were set by \ref setInputNormals, otherwise in the order of the points.
 *
 * By default, planes are grown as the noise and the mesh allow: the mesh defines which
 * points are neighbours, the noise of the points defines how far they may be from the
 * plane, and the area decides which planes are accepted. Coplanar regions are merged,
 * however far apart they are; curved surfaces are recognised and counted. If the cloud
 * from which the points were consolidated is also given (\ref ClusteringInputs::setSourceCloud), its
 * points verify the planes, narrow planes between larger ones (reveals of doors) are
 * found as well, and each plane is fitted to its points along the rays of their sensors.
 *
 * With \ref PlaneClusteringParameters::setNoiseDriven (false), the planes are those of the paper to the letter. A
 * hypothesis i is supported by each other hypothesis j whose point is within W_d of p_i
 * or of another supporter (\ref PlaneClusteringParameters::setSupporterReach) and within
 * W_t of the plane, and whose normal is within W_n of n_i. The plane is estimated again
 * with every supporter, and accepted if there are more than W_h of them. Nothing is
 * merged, added or removed afterwards. With a W_t of 0.25 m doors are part of their
 * walls.
 *
 * Units are metres, in the frame of the cloud. Plane normals have the direction of the
 * normals of the points. The result is the same in every run and for any number of
 * threads. The time is O(n); with the paper's thresholds, O(n + k m) for k hypotheses that are on
 * no plane and m points within W_d.
 * \code
 * pcl::PlaneHypothesisClustering<pcl::PointNormal> clustering;
 * clustering.setInputCloud (consolidated);
 * clustering.setTriangles (mesh.polygons);
 * std::vector<pcl::PlanePatch> planes;
 * clustering.segment (planes);
 * \endcode
 * \ingroup segmentation
 */
template <typename PointT>
class PlaneHypothesisClustering : public PCLBase<PointT>,
                                  public PlaneClusteringParameters {
public:
  using Ptr = shared_ptr<PlaneHypothesisClustering<PointT>>;
  using ConstPtr = shared_ptr<const PlaneHypothesisClustering<PointT>>;
  using PointCloudConstPtr = typename PCLBase<PointT>::PointCloudConstPtr;

  /** \brief Sets the normals n_i, one per point of the cloud. If unset, those of PointT
   * are used. */
  void
  setInputNormals(const PointCloud<Normal>::ConstPtr& normals)
  {
    normals_ = normals;
  }

  /** \brief Sets the classes that NormalVectorVoting assigned to the points: if
   * noise-driven, no plane is seeded at a crease. */
  void
  setVertexClasses(const PointCloud<Label>::ConstPtr& classes)
  {
    classes_ = classes;
  }

  /** \brief Estimates how long \ref segment will take with the paper's thresholds, which
   * compare each hypothesis without a plane with all others within W_d.
   * \return seconds on a processor of 2020, if every twentieth point is on no plane; 0
   * without a cloud, if noise-driven, and if no point has a normal */
  double
  estimateSeconds() const;

  /** \brief Finds all planes of the input cloud, or of its indices if they are set.
   * \param[out] patches the planes in order of decreasing area (without a mesh the area
   * is 0, and the planes are in the order of the area of their regions); if empty, the
   * report contains the reason
   * \throws InitFailedException without a cloud or normals, if the number of normals or
   * classes differs from that of the points, or with indices or triangle corners
   * outside of the cloud
   * \throws CancelledException when the progress callback requested to stop */
  void
  segment(std::vector<PlanePatch>& patches);

  /** \brief Same as segment, but returns the point indices of each plane, as
   * RegionGrowing does. */
  void
  extract(std::vector<PointIndices>& clusters);

protected:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;

private:
  void
  requireInputs() const;

  acmap::PointView
  normals() const;

  PointCloud<Normal>::ConstPtr normals_;
  PointCloud<Label>::ConstPtr classes_;
};

/** \brief The same for clouds of any fields, as files have them, and for rows that are
 * larger than the memory. \ingroup segmentation */
template <>
class ACMAP_EXPORT PlaneHypothesisClustering<PCLPointCloud2>
: public PlaneClusteringParameters {
public:
  using Ptr = shared_ptr<PlaneHypothesisClustering<PCLPointCloud2>>;
  using ConstPtr = shared_ptr<const PlaneHypothesisClustering<PCLPointCloud2>>;

  /** \brief Sets the cloud, all of whose points are hypotheses. */
  void
  setInputCloud(const CloudRows& cloud)
  {
    rows_ = cloud;
  }

  /** \brief Sets the normals n_i, one row per point, as NormalVectorVoting returns them:
   * float32 fields normal_x, normal_y, normal_z side by side; where there are a float32
   * `curvature` and an uint8 `vertex_class`, they define the order of the hypotheses and
   * where no plane is seeded. If unset, those of the cloud are used. */
  void
  setInputNormals(const CloudRows& normals)
  {
    normals_ = normals;
  }

  /** \brief See the class of point types. */
  double
  estimateSeconds() const;

  /** \brief Finds all planes of the input cloud.
   * \param[out] patches as those of the class of point types
   * \throws InitFailedException without a cloud or normals, if these have no such fields
   * or differ in number from the points, or with triangle corners outside of the cloud
   * \throws CancelledException when the progress callback requested to stop */
  void
  segment(std::vector<PlanePatch>& patches);

private:
  CloudRows rows_;
  CloudRows normals_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/plane_hypothesis_clustering.hpp>
#endif
