#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/build_config.h>
#include <pcl/core/cloud_rows.h>
#include <pcl/core/export.h>
#include <pcl/core/point_types.h>
#include <pcl/core/stage_controls.h>
#include <pcl/filters/consolidation_types.h>
#include <pcl/filters/filter.h>
#include <pcl/filters/impl/consolidation_kernel.h>

#include <functional>
#include <optional>
#include <vector>

namespace pcl {

/** \brief Settings of \ref VoxelConsolidation, for clouds of points and of rows.
 * \ingroup filters */
class ACMAP_EXPORT ConsolidationParameters : public StageControls<ConsolidationReport> {
public:
  /** \brief Sets the edge of a voxel.
   * \param[in] size metres; 0 (default) for automatic: the minimum size that reduces
   * the noise to 1/80 of the voxel and is at least twice the spacing of sparse points
   * and four times their noise, see NoiseScale
   * \throws BadArgumentException when negative or not finite */
  void
  setVoxelSize(double size);

  double
  getVoxelSize() const
  {
    return settings_.voxel_size;
  }

  /** \brief Sets the sensor positions of the observations given by the field `view` of
   * the points, in metres, in the frame of the cloud. Clouds without that field are
   * assumed to be seen from their sensor_origin_.
   * \throws BadArgumentException when one is not finite */
  void
  setViewpoints(std::vector<Eigen::Vector3f> viewpoints);

  const std::vector<Eigen::Vector3f>&
  getViewpoints() const
  {
    return viewpoints_;
  }

  /** \brief Keeps the sources of the output points (default false): a second pass over
   * the points, and 8 bytes for each. See VoxelConsolidation::getVoxelOfPoint. */
  void
  setKeepSources(bool keep)
  {
    settings_.keep_sources = keep;
  }

  bool
  getKeepSources() const
  {
    return settings_.keep_sources;
  }

  /** \brief All settings. */
  acmap::ConsolidationSettings
  settings() const;

protected:
  ConsolidationParameters() = default;

  std::vector<Eigen::Vector3f> viewpoints_;

private:
  acmap::ConsolidationSettings settings_;
};

/** \brief Resamples a noisy cloud of surfaces at the scale of its noise: one point per
 * voxel, on the plane of the points around it.
 *
 * The noise of an active-stereo map exceeds the spacing of its points: a wall is a slab
 * of points, and every mesh that interpolates them is crumpled. This filter computes
 * the moments (count, mean, covariance) of the points of each voxel, fits a plane to
 * the window of 5 x 5 x 5 voxels around it, and moves the mean of the voxel along the
 * normal onto the plane. If the window is thicker than the noise, which is predicted
 * from distance and slant of the sensors, it fits 3 x 3 x 3 voxels; otherwise separate
 * planes for the two sides of a thin wall, distinguished by their sensor positions;
 * otherwise, at a crease, the flattest 2 x 2 x 2 voxels. At the border of a surface the
 * point is moved outwards to the end of its sources. A point closer than 0.7 voxels to
 * an earlier one on the same side is removed (0.85 voxels if it left its voxel).
 *
 * An output point is a copy of the input point of its voxel that is closest to its
 * sensor (the first one if no sensor is known), so that `view`, intensity and label are
 * those of a real point. Its x y z are moved, its colour is the mean of the sources,
 * and normal and curvature are set, as far as PointT has these fields. Normals are of
 * unit length and point towards the sensor, or are consistent with their neighbours if
 * the sensor positions do not fit; they are NaN if there is no plane through at least
 * three points. The result does not depend on the order of the points (except that the
 * lower index is the source if two points are equally close to their sensors) or on the
 * number of threads.
 *
 * Metres. Takes O(n) time, and about 110 bytes of memory per occupied voxel.
 * \code
 * pcl::VoxelConsolidation<pcl::PointNormal> consolidation;
 * consolidation.setInputCloud (cloud);
 * pcl::PointCloud<pcl::PointNormal> consolidated;
 * consolidation.filter (consolidated);
 * \endcode
 * This is an addition to "Active Stereo Based Compact Mapping", whose section II-C.1
 * meshes the raw points.
 * \ingroup filters */
template <typename PointT>
class VoxelConsolidation : public Filter<PointT>, public ConsolidationParameters {
public:
  using Ptr = shared_ptr<VoxelConsolidation<PointT>>;
  using ConstPtr = shared_ptr<const VoxelConsolidation<PointT>>;
  using PointCloud = typename Filter<PointT>::PointCloud;
  using PointCloudConstPtr = typename Filter<PointT>::PointCloudConstPtr;

  /** \brief The sources of all output points: those of point i are indices[offsets[i]]
   * to indices[offsets[i + 1] - 1], in ascending order. */
  struct SourceIndices {
    std::vector<std::size_t> offsets;
    Indices indices;
  };

  VoxelConsolidation();

  /** \throws InitFailedException without a cloud */
  void
  setInputCloud(const PointCloudConstPtr& cloud) override;

  /** \brief Consolidates the input cloud, or its indices if they are set.
   * \param[out] output may be the input; empty, with the reason in the report, if no
   * point is finite or no voxel size can be determined
   * \throws InitFailedException without an input cloud, or with indices out of range
   * \throws CancelledException when the progress callback stopped it */
  void
  filter(PointCloud& output);

  /** \brief Returns the input points of each output point of the last run; empty unless
   * enabled by \ref ConsolidationParameters::setKeepSources. */
  const SourceIndices&
  getSourceIndices() const
  {
    return sources_;
  }

  /** \brief Returns for each point of the input cloud the index of the output point
   * that represents it, -1 if there is none; empty unless enabled by
   * \ref ConsolidationParameters::setKeepSources. */
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
  keepSources(const PointLabels& representative_of, std::size_t size);

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
class ACMAP_EXPORT VoxelConsolidation<PCLPointCloud2> : public Filter<PCLPointCloud2>,
                                                        public ConsolidationParameters {
public:
  using Ptr = shared_ptr<VoxelConsolidation<PCLPointCloud2>>;
  using ConstPtr = shared_ptr<const VoxelConsolidation<PCLPointCloud2>>;

  VoxelConsolidation();

  /** \brief Sets the cloud, in place of rows that were set before.
   * \throws InitFailedException without a cloud */
  void
  setInputCloud(const PCLPointCloud2ConstPtr& cloud);

  void
  setInputCloud(const PCLPointCloud2Ptr& cloud)
  {
    setInputCloud(PCLPointCloud2ConstPtr(cloud));
  }

  /** \brief Sets rows that need not be in a PCLPointCloud2; all of them are used. */
  void
  setInputCloud(const CloudRows& rows)
  {
    rows_ = rows;
  }

  /** \brief Sets the position of the sensor of a cloud without a field `view`, in metres.
   * PCLPointCloud2 has none. \throws BadArgumentException when it is not finite */
  void
  setSensorOrigin(const Eigen::Vector3f& origin);

  /** \brief For each point of the input cloud the output point that represents it, -1 if
   * there is none; empty unless requested (setKeepSources). */
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

  /** \brief The same into rows, which are in a file while a \ref ScratchMemory exists. */
  void
  filter(CloudRows& output);

protected:
  void
  applyFilter(PCLPointCloud2& output) override;

private:
  /** Makes the rows of so many points. \return the first byte */
  using MakeRows =
      std::function<std::uint8_t*(const PCLPointCloud2& layout, std::size_t points)>;

  void
  consolidate(const MakeRows& make);

  std::optional<Eigen::Vector3f> sensor_origin_;
  Indices voxel_of_point_;
  CloudRows rows_; ///< instead of the input cloud, if there are any
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/filters/impl/voxel_consolidation.hpp>
#endif
