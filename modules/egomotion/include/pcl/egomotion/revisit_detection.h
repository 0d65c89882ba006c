#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/stage_controls.h>
#include <pcl/egomotion/impl/revisit_kernel.h>
#include <pcl/egomotion/revisit_detection_types.h>
#include <pcl/memory.h>
#include <pcl/point_cloud.h>

#include <functional>
#include <utility>
#include <vector>

namespace pcl {

/** \brief Finds pairs of views of a sequence that were made at different times and see
 * the same place, and the motion between them (loop closures). The paper, "Active Stereo
 * Based Compact Mapping", has none: its poses come from consecutive views.
 *
 * Keypoints of all views (ORB: Rublee et al., "ORB: an efficient alternative to SIFT or
 * SURF", 2011) are in one search index (FLANN's hierarchical clustering: Muja and Lowe,
 * "Fast Matching of Binary Features", 2012). Views whose keypoints have their nearest
 * neighbours in each other are proposed. A proposal is verified as VisualEgomotion
 * verifies a motion: the matches that agree in space (Eq. 1) are fitted, surfaces and
 * brightness refine the motion in six degrees of freedom, and its covariance must
 * determine it. Appearance alone is not taken: the keypoints that agree must be many and
 * well spread, a good part of the surfaces of both views must coincide, and hardly any
 * may occlude what the other view has seen.
 *
 * The input is organized clouds as for VisualEgomotion: camera's frame (x right, y down,
 * z forward, metres), a colour at every pixel from a shot without a pattern, and `sigma`
 * (metres along the ray) if PointT has it. Places that are exactly alike in colour and
 * shape cannot be distinguished; PlaneAdjustment checks revisits against the odometry.
 * Time O(n log n) for n views; the result is the same for every number of threads.
 * \code
 * pcl::RevisitDetection<pcl::PointXYZRGBSigma> detection;
 * for (const auto& cloud : clouds)
 *   detection.addPointCloud (cloud);
 * detection.compute ();
 * for (const pcl::Revisit& revisit : detection.getRevisits ())
 *   std::cout << revisit.earlier << " and " << revisit.later << '\n';
 * \endcode
 * \ingroup egomotion */
template <typename PointT>
class RevisitDetection : public StageControls<RevisitReport> {
public:
  using Ptr = shared_ptr<RevisitDetection<PointT>>;
  using ConstPtr = shared_ptr<const RevisitDetection<PointT>>;
  using PointCloud = pcl::PointCloud<PointT>;
  using PointCloudConstPtr = typename PointCloud::ConstPtr;

  /** \brief Returns a view; it is called from several threads. */
  using Loader = std::function<PointCloudConstPtr()>;

  /** \brief Adds a view; the order must be that in which they were made.
   * \param[in] cloud organized or empty; it must not be changed afterwards
   * \return its number
   * \throws InitFailedException when the cloud is missing
   * \throws UnorganizedPointCloudException unless the cloud is organized, or empty */
  std::size_t
  addPointCloud(const PointCloudConstPtr& cloud);

  /** \brief Adds a view that is loaded whenever it is needed, so that not all views are
   * in memory at once. */
  std::size_t
  addPointCloudLoader(Loader loader)
  {
    loaders_.push_back(std::move(loader));
    return loaders_.size() - 1;
  }

  std::size_t
  getNumberOfPointClouds() const
  {
    return loaders_.size();
  }

  /** \brief Removes all views. */
  void
  clear()
  {
    loaders_.clear();
  }

  /** \brief Sets the smallest difference between the numbers of the two views of a
   * revisit (default 10): nearer ones are neighbours, between which the odometry is
   * accurate.
   * \throws BadArgumentException unless within [1, 1e6] */
  void
  setMinimumSeparation(std::size_t views);

  std::size_t
  getMinimumSeparation() const
  {
    return settings_.min_separation;
  }

  /** \brief Finds the revisits among all views.
   * \throws InitFailedException without a view, or when a loader returns none
   * \throws UnorganizedPointCloudException when a loaded cloud is not organized
   * \throws CancelledException when the progress callback requested to stop; nothing is
   * changed
   * \throws what a loader throws */
  void
  compute();

  /** \brief The revisits of the last run, in the order of the later view, then of the
   * earlier one. */
  const std::vector<Revisit>&
  getRevisits() const
  {
    return revisits_;
  }

private:
  acmap::RevisitSettings settings_;
  std::vector<Loader> loaders_;
  std::vector<Revisit> revisits_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/egomotion/impl/revisit_detection.hpp>
#endif
