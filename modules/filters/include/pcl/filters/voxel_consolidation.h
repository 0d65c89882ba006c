#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/build_config.h>
#include <pcl/core/export.h>
#include <pcl/core/point_types.h>
#include <pcl/core/stage_controls.h>
#include <pcl/filters/consolidation_types.h>
#include <pcl/filters/filter.h>

#include <optional>
#include <vector>

namespace pcl {

/** \brief Brings a noisy cloud of surfaces to its noise scale: one point a voxel, on the
 * plane of the points around it.
 *
 * At the density of an active-stereo map the noise exceeds the spacing: the cloud is a
 * slab, and every mesh that interpolates it is crumpled. This filter sums the points of
 * each voxel up to their moments (count, mean, covariance), fits a plane to the window of
 * 5 x 5 x 5 voxels about it, and moves the voxel's mean along the normal onto the plane.
 * Where the window is thicker than the noise, which is expected by distance and slant of
 * the sensors, it fits 3 x 3 x 3 voxels; then the two sides of a thin wall apart, by where
 * their sensors stood; then, at a crease, the flattest 2 x 2 x 2. At a rim the point moves
 * outwards to where its sources end. A point nearer than 0.7 voxels to an earlier one on
 * its side is dropped (0.85 when it left its voxel).
 *
 * Output points are copies of the input point that was seen from nearest (the first one,
 * where nothing is known), so that `view`, intensity, label have a true source; on top of
 * it x y z are moved, colour is the mean of the sources, and normal and curvature are set,
 * as far as PointT has them. Normals are unit, towards the sensor, or agree with their
 * neighbours' where no sensor fits; NaN where three points are not to be had. Neither the order of the points nor the number of threads matters
 * (where sensors are equally near, the lower index is the source).
 *
 * Metres. Time O(n), memory of the occupied voxels, about 110 bytes each.
 * \code
 * pcl::VoxelConsolidation<pcl::PointNormal> consolidation;
 * consolidation.setInputCloud (cloud);
 * pcl::PointCloud<pcl::PointNormal> consolidated;
 * consolidation.filter (consolidated);
 * \endcode
 * It goes beyond "Active Stereo Based Compact Mapping", whose II-C.1 meshes the raw points.
 * \ingroup filters
 */
template <typename PointT>
class VoxelConsolidation : public Filter<PointT>,
                           public StageControls<ConsolidationReport> {
public:
  using Ptr = shared_ptr<VoxelConsolidation<PointT>>;
  using ConstPtr = shared_ptr<const VoxelConsolidation<PointT>>;
  using PointCloud = typename Filter<PointT>::PointCloud;
  using PointCloudConstPtr = typename Filter<PointT>::PointCloudConstPtr;

  /** \brief The sources of all output points: those of point i are
   * indices[offsets[i]] to indices[offsets[i + 1]], ascending. */
  struct SourceIndices {
    std::vector<std::size_t> offsets;
    Indices indices;
  };

  VoxelConsolidation();

  /** \throws InitFailedException without a cloud */
  void
  setInputCloud(const PointCloudConstPtr& cloud) override;

  /** \brief Sets the edge of a voxel.
   * \param[in] size metres; 0 (default): automatic, the smallest one that leaves at most
   * 1/80 of itself as noise, is twice the spacing of the points where they are sparse and
   * four times their noise, see NoiseScale
   * \throws BadArgumentException when negative or not finite */
  void
  setVoxelSize(double size);

  double
  getVoxelSize() const
  {
    return voxel_size_;
  }

  /** \brief Sets where the observations stood that the points' field `view` names, in
   * metres, in the frame of the cloud. Clouds without that field were seen from their
   * sensor_origin_. \throws BadArgumentException when one is not finite */
  void
  setViewpoints(std::vector<Eigen::Vector3f> viewpoints);

  const std::vector<Eigen::Vector3f>&
  getViewpoints() const
  {
    return viewpoints_;
  }

  /** \brief Asks for \ref getSourceIndices and \ref getVoxelOfPoint (default false): a
   * second look at the points, and 8 bytes for each. */
  void
  setKeepSources(bool keep)
  {
    keep_sources_ = keep;
  }

  bool
  getKeepSources() const
  {
    return keep_sources_;
  }

  /** \brief Consolidates the input cloud (its indices, where set).
   * \param[out] output may be the input; empty, with the reason in the report, where no
   * point is finite or no voxel size can be told
   * \throws InitFailedException without an input cloud, or with indices outside of it
   * \throws CancelledException when the progress callback stopped it */
  void
  filter(PointCloud& output);

  /** \brief The input points of each output point in the last run; empty unless asked for
   * with \ref setKeepSources. */
  const SourceIndices&
  getSourceIndices() const
  {
    return sources_;
  }

  /** \brief For each point of the input cloud the output point that stands for it, -1
   * where there is none; empty unless asked for with \ref setKeepSources. */
  const Indices&
  getVoxelOfPoint() const
  {
    return voxel_of_point_;
  }

protected:
  using Filter<PointT>::input_;
  using Filter<PointT>::indices_;
  using Filter<PointT>::filter_name_;

  void
  applyFilter(PointCloud& output) override;

private:
  void
  keepSources(const std::vector<std::int32_t>& representative_of, std::size_t size);

  double voxel_size_ = 0;
  std::vector<Eigen::Vector3f> viewpoints_;
  bool keep_sources_ = false;
  SourceIndices sources_;
  Indices voxel_of_point_;
};

/** \brief The same for clouds of any fields, as files have them.
 *
 * Output rows are copies of the row of a source with all its fields; on top of it x y z are
 * moved, `rgb` (or `rgba`) is the mean of the sources, `normal_x`, `normal_y`, `normal_z`
 * and `curvature` are set, and added where they are missing, and `sigma` becomes the
 * residual noise. \ingroup filters */
template <>
class ACMAP_EXPORT VoxelConsolidation<PCLPointCloud2>
: public Filter<PCLPointCloud2>,
  public StageControls<ConsolidationReport> {
public:
  using Ptr = shared_ptr<VoxelConsolidation<PCLPointCloud2>>;
  using ConstPtr = shared_ptr<const VoxelConsolidation<PCLPointCloud2>>;

  VoxelConsolidation();

  /** \brief See the class of point types. */
  void
  setVoxelSize(double size);

  double
  getVoxelSize() const
  {
    return voxel_size_;
  }

  /** \brief Sets the positions of the observations that the int32 field `view` refers to,
   * in metres, in the frame of the cloud.
   * \throws BadArgumentException when one is not finite */
  void
  setViewpoints(std::vector<Eigen::Vector3f> viewpoints);

  /** \brief Sets the position of the sensor of a cloud without a field `view`, in metres.
   * PCLPointCloud2 has none. \throws BadArgumentException when it is not finite */
  void
  setSensorOrigin(const Eigen::Vector3f& origin);

  /** \brief Requests \ref getVoxelOfPoint (default false). */
  void
  setKeepSources(bool keep)
  {
    keep_sources_ = keep;
  }

  bool
  getKeepSources() const
  {
    return keep_sources_;
  }

  /** \brief For each point of the input cloud the output point that represents it, -1 if
   * there is none; empty unless requested with \ref setKeepSources. */
  const Indices&
  getVoxelOfPoint() const
  {
    return voxel_of_point_;
  }

  /** \brief Runs on the input cloud (its indices, where set).
   * \param[out] output may be the input
   * \throws InitFailedException if the cloud has no float32 fields x, y, z side by side,
   * or fewer bytes than it states, or indices are outside of it
   * \throws CancelledException when the progress callback stopped it */
  void
  filter(PCLPointCloud2& output);

protected:
  void
  applyFilter(PCLPointCloud2& output) override;

private:
  double voxel_size_ = 0;
  std::vector<Eigen::Vector3f> viewpoints_;
  std::optional<Eigen::Vector3f> sensor_origin_;
  bool keep_sources_ = false;
  Indices voxel_of_point_;
};

} // namespace pcl
