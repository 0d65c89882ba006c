#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/progress.h>
#include <pcl/correspondence.h>
#include <pcl/egomotion/egomotion_kernel.h>
#include <pcl/egomotion/egomotion_types.h>
#include <pcl/memory.h>
#include <pcl/point_cloud.h>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace pcl {

/** \brief How far did the camera move between two observations? From what it saw alone:
 * visual egomotion of "Active Stereo Based Compact Mapping", II-B.1.
 *
 * GradientMaximumKeypoint in both views, registration::CorrespondenceEstimationLogPolar
 * between them, registration::CorrespondenceRejectorWorstOut (Eq. 1), then
 * registration::TransformationEstimationPlanar (Eq. 2), each match weighted by its sigma.
 * Beyond the paper: features are looked for at three scales and down to the image's noise,
 * so that nearly blank walls are enough; matches beyond three sigma are left out; then
 * pieces of surface (point to plane) and brightness are laid upon each other, together
 * with the features, where that fits better and brings the surfaces nearer.
 *
 * A view without features, matches that do not agree, a direction that nothing tells about
 * (\ref EgomotionOutcome) give no motion rather than a wrong one; the report says why.
 *
 * Organized clouds in the camera's frame (x right, y down, z forward, metres), colour at
 * every pixel, that of a shot without a pattern. Where PointT has a field `sigma` it is one
 * standard deviation along the ray; else the noise is estimated. In the Planar model
 * (default) the camera moves level: in its XZ plane and about its y axis. Views are kept:
 * in a sequence each is looked at once. Time O(n) for n pixels, O(k^2) for k keypoints;
 * the same bytes for every number of threads.
 * \code
 * pcl::VisualEgomotion<pcl::PointXYZRGBSigma> egomotion;
 * egomotion.setInputTarget (before);
 * egomotion.setInputSource (now);
 * if (const auto estimate = egomotion.compute ())
 *   pose = pcl::moved (pose, estimate->action);
 * else
 *   std::cerr << egomotion.getReport ().reason << "\n";
 * \endcode
 * \ingroup egomotion
 */
template <typename PointT>
class VisualEgomotion {
public:
  using Ptr = shared_ptr<VisualEgomotion<PointT>>;
  using ConstPtr = shared_ptr<const VisualEgomotion<PointT>>;
  using PointCloud = pcl::PointCloud<PointT>;
  using PointCloudConstPtr = typename PointCloud::ConstPtr;

  /** \brief Sets the later view, not to be changed afterwards. */
  void
  setInputSource(const PointCloudConstPtr& cloud)
  {
    source_ = cloud;
  }

  PointCloudConstPtr
  getInputSource() const
  {
    return source_;
  }

  /** \brief Sets the view before, in whose frame the motion is told. */
  void
  setInputTarget(const PointCloudConstPtr& cloud)
  {
    target_ = cloud;
  }

  PointCloudConstPtr
  getInputTarget() const
  {
    return target_;
  }

  /** \brief Sets how the camera may move (default Planar). */
  void
  setMotionModel(MotionModel model)
  {
    settings_.model = model;
  }

  MotionModel
  getMotionModel() const
  {
    return settings_.model;
  }

  /** \brief Sets how Eq. 2 is minimised (default ConjugateGradient). */
  void
  setSolver(MotionSolver solver)
  {
    settings_.solver = solver;
  }

  MotionSolver
  getSolver() const
  {
    return settings_.solver;
  }

  /** \brief Sets how far the camera moves between views, at most (default 1), metres;
   * only matches within reach are looked at. \throws BadArgumentException unless within
   * [0.001, 1e6] */
  void
  setMaximumTranslation(double metres);

  double
  getMaximumTranslation() const
  {
    return settings_.most_translation;
  }

  /** \brief Sets how far it turns, at most (default pi / 6), radians.
   * \throws BadArgumentException unless within [0, pi] */
  void
  setMaximumRotation(double radians);

  double
  getMaximumRotation() const
  {
    return settings_.most_rotation;
  }

  /** \brief Sets how many keypoints a view gives at most at each of its three scales
   * (default 1000).
   * \throws BadArgumentException unless within [10, 100000] */
  void
  setMaximumKeypoints(std::size_t keypoints);

  std::size_t
  getMaximumKeypoints() const
  {
    return settings_.keypoints.most;
  }

  /** \brief Sets whether surfaces refine what features gave (default true); they judge
   * it in any case. */
  void
  setRefinement(bool refines)
  {
    settings_.refines = refines;
    kept_.clear();
  }

  bool
  getRefinement() const
  {
    return settings_.refines;
  }

  /** \brief Sets the number of threads (0 = all, default); the result is the same. */
  void
  setNumberOfThreads(unsigned threads = 0)
  {
    settings_.threads = threads;
  }

  unsigned
  getNumberOfThreads() const
  {
    return settings_.threads;
  }

  /** \brief Sets who is told about the progress and may stop the run. */
  void
  setProgressCallback(ProgressCallback callback)
  {
    progress_ = std::move(callback);
  }

  /** \brief Estimates the motion.
   * \return the motion, or none: \ref getReport says why
   * \throws InitFailedException without source or target
   * \throws UnorganizedPointCloudException unless both are organized, or empty
   * \throws CancelledException when the progress callback stopped it; nothing changes
   */
  std::optional<EgomotionEstimate>
  compute();

  /** \brief Matches of the last run by look alone: indices in source and target,
   * squared metres between both as they are. */
  const Correspondences&
  getMatches() const
  {
    return matches_;
  }

  /** \brief Of these, the ones the motion stands on. */
  const Correspondences&
  getInliers() const
  {
    return inliers_;
  }

  /** \brief Outcome, reason, counts, residuals, seconds of the last run. */
  const EgomotionReport&
  getReport() const
  {
    return report_;
  }

private:
  /** A view that was prepared, and of what it was. */
  struct Prepared {
    PointCloudConstPtr cloud;
    std::shared_ptr<const acmap::EgomotionView> view;
  };

  std::shared_ptr<const acmap::EgomotionView>
  prepared(const PointCloudConstPtr& cloud);

  acmap::EgomotionSettings settings_;
  ProgressCallback progress_;
  PointCloudConstPtr source_, target_;
  std::vector<Prepared> kept_; ///< of the last run's two clouds
  Correspondences matches_, inliers_;
  EgomotionReport report_;
};

} // namespace pcl
