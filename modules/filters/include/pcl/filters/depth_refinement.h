#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/build_config.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/depth_planes.h>
#include <pcl/core/point_types.h>
#include <pcl/core/stage_controls.h>
#include <pcl/filters/depth_refinement_types.h>
#include <pcl/filters/filter.h>

namespace pcl {

/** \brief Removes the quantisation steps from the view of a depth camera.
 *
 * A Kinect quantises inverse depth, with steps of 11 mm at 2 m and 70 mm at 5 m, so
 * that distant walls become stacks of layers, which remain visible in a mesh. This
 * filter finds the planes of the view in image space (acmap::findDepthPlanes) and
 * moves their pixels onto them along their rays. Other pixels are moved to the plane of
 * inverse depth through the 9 x 9 pixels around them that are at the same depth, by at
 * most 1.5 times the step or the noise, whichever is larger. Points without such
 * neighbours, which are between surfaces, are removed. Edges between surfaces are
 * preserved.
 *
 * The input is an organized cloud in the frame of its sensor (x right, y down, z
 * forward, metres). The output has the same size, with NaN for pixels without a point.
 * All other fields are copied; normals are set, towards the sensor, if PointT has them.
 * Takes linear time; the result is the same for every number of threads.
 * \code
 * pcl::DepthRefinement<pcl::PointXYZRGBNormal> refinement;
 * refinement.setInputCloud (kinect_view);
 * pcl::PointCloud<pcl::PointXYZRGBNormal> refined;
 * refinement.filter (refined);
 * \endcode
 * \ingroup filters */
template <typename PointT>
class DepthRefinement : public Filter<PointT>,
                        public StageControls<DepthRefinementReport> {
public:
  using Ptr = shared_ptr<DepthRefinement<PointT>>;
  using ConstPtr = shared_ptr<const DepthRefinement<PointT>>;
  using PointCloud = typename Filter<PointT>::PointCloud;
  using PointCloudConstPtr = typename Filter<PointT>::PointCloudConstPtr;

  DepthRefinement();

  /** \throws InitFailedException without a cloud */
  void
  setInputCloud(const PointCloudConstPtr& cloud) override;

  /** \brief Sets the planes of the view that DepthPlaneSegmentation found, so that they
   * are not searched again. Pixels whose ray does not intersect their plane are
   * smoothed.
   * \param[in] patches in the frame of the sensor
   * \param[in] labels for each point of the cloud the index of its patch, -1 for none;
   * if it is empty (default), the planes are searched
   * \throws BadArgumentException if a label is not the index of a patch, or the sensor
   * is on a plane */
  void
  setPlanes(const std::vector<PlanePatch>& patches, const PointLabels& labels);

  /** \brief Refines the input cloud. If indices are set, the other pixels are treated
   * as not measured.
   * \param[out] output organized as the input, and may be the input itself. It is a
   * copy of the input, with the reason in the report, if no pinhole camera fits the
   * points
   * \throws InitFailedException without an input cloud, with indices out of range, or
   * with labels for another number of points
   * \throws UnorganizedPointCloudException when the cloud is not organized
   * \throws CancelledException when the progress callback stopped it */
  void
  filter(PointCloud& output);

protected:
  using Filter<PointT>::input_;
  using Filter<PointT>::indices_;
  using Filter<PointT>::filter_name_;

  void
  applyFilter(PointCloud& output) override;

private:
  acmap::DepthPlanes planes_;
};

/** \brief The same for organized clouds of any fields, as files have them: x y z are moved,
 * `normal_x`, `normal_y` and `normal_z` are set, and added where they are missing.
 * \ingroup filters */
template <>
class ACMAP_EXPORT DepthRefinement<PCLPointCloud2>
: public Filter<PCLPointCloud2>, public StageControls<DepthRefinementReport> {
public:
  using Ptr = shared_ptr<DepthRefinement<PCLPointCloud2>>;
  using ConstPtr = shared_ptr<const DepthRefinement<PCLPointCloud2>>;

  DepthRefinement();

  /** \throws InitFailedException without a cloud */
  void
  setInputCloud(const PCLPointCloud2ConstPtr& cloud);

  /** \brief See the class of point types. */
  void
  setPlanes(const std::vector<PlanePatch>& patches, const PointLabels& labels);

  /** \brief Runs on the input cloud (its indices, where set).
   * \param[out] output may be the input
   * \throws InitFailedException if the cloud has no float32 fields x, y, z side by side,
   * or fewer bytes than it states, indices are outside of it, or there are labels for
   * another number of points
   * \throws UnorganizedPointCloudException when the cloud is not organized
   * \throws CancelledException when the progress callback stopped it */
  void
  filter(PCLPointCloud2& output);

protected:
  void
  applyFilter(PCLPointCloud2& output) override;

private:
  acmap::DepthPlanes planes_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/filters/impl/depth_refinement.hpp>
#endif
