#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/build_config.h>
#include <pcl/core/depth_planes.h>
#include <pcl/core/export.h>
#include <pcl/core/point_types.h>
#include <pcl/core/stage_controls.h>
#include <pcl/filters/depth_refinement_types.h>
#include <pcl/filters/filter.h>

namespace pcl {

/** \brief Takes the steps out of a depth camera's view.
 *
 * A Kinect's depth comes in steps of inverse depth, 11 mm at 2 m and 70 mm at 5 m, so that
 * its far walls are stacks of layers, which no mesh of them hides. This filter finds the
 * planes of the view in its picture (\ref acmap::findDepthPlanes) and lays their pixels
 * onto them along their rays; other pixels go to the plane of inverse depth through the
 * 9 x 9 around them that are at their depth, by 1.5 steps at most. Points without such
 * neighbours, which hang between surfaces, are withdrawn. Edges between surfaces stay.
 *
 * Takes an organized cloud in its sensor's frame (x right, y down, z forward, metres) and
 * gives one of the same size, NaN where there is no point; all other fields stay as they
 * are, normals are set, towards the sensor, where PointT has them. Linear time; the same
 * answer for every number of threads.
 * \code
 * pcl::DepthRefinement<pcl::PointXYZRGBNormal> refinement;
 * refinement.setInputCloud (kinect_view);
 * pcl::PointCloud<pcl::PointXYZRGBNormal> refined;
 * refinement.filter (refined);
 * \endcode
 * \ingroup filters
 */
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

  /** \brief Sets the planes of the view as DepthPlaneSegmentation found them, so that they
   * are not searched for again. Pixels whose ray does not meet their plane are smoothed.
   * \param[in] patches in the sensor's frame
   * \param[in] labels for each point of the cloud its patch, -1 for none; none at all: the
   * planes are searched for (default)
   * \throws BadArgumentException where a label names no patch, or the sensor lies on a
   * plane */
  void
  setPlanes(const std::vector<PlanePatch>& patches,
            const std::vector<std::int32_t>& labels);

  /** \brief Refines the input cloud (its indices, where set: the other pixels count as not
   * measured).
   * \param[out] output may be the input; organized as the input. A copy of it, with the
   * reason in the report, where no pinhole camera fits its points
   * \throws InitFailedException without an input cloud, with indices outside of it, or with
   * labels for another number of points
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
: public Filter<PCLPointCloud2>,
  public StageControls<DepthRefinementReport> {
public:
  using Ptr = shared_ptr<DepthRefinement<PCLPointCloud2>>;
  using ConstPtr = shared_ptr<const DepthRefinement<PCLPointCloud2>>;

  DepthRefinement();

  /** \brief See the class of point types. */
  void
  setPlanes(const std::vector<PlanePatch>& patches,
            const std::vector<std::int32_t>& labels);

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
