#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/progress.h>
#include <pcl/correspondence.h>
#include <pcl/egomotion/egomotion_types.h>
#include <pcl/egomotion/impl/egomotion_kernel.h>
#include <pcl/memory.h>
#include <pcl/point_cloud.h>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace pcl {

/** \brief Estimates the motion of the camera between two observations from its views
 * alone: visual egomotion of "Active Stereo Based Compact Mapping", II-B.1.
 *
 * It applies GradientMaximumKeypoint to both views,
 * registration::CorrespondenceEstimationLogPolar to their keypoints,
 * registration::CorrespondenceRejectorWorstOut (Eq. 1), and then
 * registration::TransformationEstimationPlanar (Eq. 2), where each match is weighted by
 * its sigma. Beyond the paper, features are extracted at three scales and down to the
 * noise of the image, so that nearly blank walls are sufficient; matches beyond three
 * sigma are excluded; then surface blocks (point to plane) and brightness are aligned
 * together with the features. The result is accepted if it fits better and brings the
 * surfaces nearer.
 *
 * In paper mode (\ref setPaperMode) it does what the paper says and nothing else.
 *
 * If a view has no features, the matches do not agree, or a direction is not determined
 * (\ref EgomotionOutcome), there is no motion rather than a wrong one; the report gives
 * the reason.
 *
 * The input is organized clouds in the camera's frame (x right, y down, z forward,
 * metres) with a colour at every pixel, from a shot without a pattern. If PointT has a
 * field `sigma`, it must be one standard deviation along the ray; otherwise the noise
 * is estimated. In the Planar model (default) the camera moves level: in its XZ plane
 * and about its y axis. Prepared views are kept, so that in a sequence each view is
 * prepared only once. Time O(n) for n pixels, O(k^2) for k keypoints; the result is the
 * same for every number of threads.
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

  /** \brief Sets the later view; it must not be changed afterwards. */
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

  /** \brief Sets the earlier view, in whose frame the motion is expressed. */
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

  /** \brief Sets the motion model of the camera (default Planar). */
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

  /** \brief Sets the method for minimising Eq. 2 (default ConjugateGradient). */
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

  /** \brief Sets the maximum translation between views (default 1), metres; only
   * matches within this distance are considered. \throws BadArgumentException unless
   * within [0.001, 1e6] */
  void
  setMaximumTranslation(double metres);

  double
  getMaximumTranslation() const
  {
    return settings_.max_translation;
  }

  /** \brief Sets the maximum rotation between views (default pi / 6), radians.
   * \throws BadArgumentException unless within [0, pi] */
  void
  setMaximumRotation(double radians);

  double
  getMaximumRotation() const
  {
    return settings_.max_rotation;
  }

  /** \brief Sets the maximum number of keypoints of a view at each of its three scales
   * (default 1000).
   * \throws BadArgumentException unless within [10, 100000] */
  void
  setMaximumKeypoints(std::size_t keypoints);

  std::size_t
  getMaximumKeypoints() const
  {
    return settings_.keypoints.maximum;
  }

  /** \brief If true, surfaces and brightness refine the motion of the features (default
   * true). Surfaces are used to check the motion in any case. */
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

  /** \brief Sets the number of scales (rings) and rotations (sectors) of the log-polar
   * patches that are tried in either direction (default 0 and 0; in paper mode 1 and 1).
   * A ring is a factor of 1.31, a sector 15 degrees.
   * \throws BadArgumentException unless within [0, 10] and [0, 12] */
  void
  setMaximumShifts(int rings, int sectors);

  int
  getMaximumRingShifts() const
  {
    return acmap::shiftsOf(settings_).rings;
  }

  int
  getMaximumSectorShifts() const
  {
    return acmap::shiftsOf(settings_).sectors;
  }

  /** \brief If true, II-B.1 is done as printed (default false): all strict local maxima
   * of the gradient at full size that have a point; matches that are strong, distinct
   * and mutual, under shifts of rings and sectors; Eq. 1 as printed
   * (registration::CorrespondenceRejectorWorstOut::setPaperMode) up to 1.15, which the
   * paper leaves open; Eq. 2 with B_ij = 1 in one fit by conjugate gradient. There is no
   * bound of the motion, no refinement and no check of the result, except that the
   * matches must determine the motion.
   *
   * Settings that contradict this have no effect while it is on: maximum translation,
   * rotation and keypoints, refinement, solver. The motion model is used as set: the
   * paper's action is Planar. */
  void
  setPaperMode(bool paper)
  {
    settings_.paper = paper;
    kept_.clear();
  }

  bool
  getPaperMode() const
  {
    return settings_.paper;
  }

  /** \brief Sets the number of threads (0 = all, default); the result is the same. */
  void
  setNumberOfThreads(unsigned threads = 0)
  {
    settings_.threads = acmap::requiredThreads(threads);
  }

  unsigned
  getNumberOfThreads() const
  {
    return settings_.threads;
  }

  /** \brief Sets the callback that receives the progress and may cancel the run. */
  void
  setProgressCallback(ProgressCallback callback)
  {
    progress_ = std::move(callback);
  }

  /** \brief Estimates the motion.
   * \return the motion, or none; \ref getReport gives the reason
   * \throws InitFailedException without source or target
   * \throws UnorganizedPointCloudException unless both are organized, or empty
   * \throws CancelledException when the progress callback cancels; nothing changes
   */
  std::optional<EgomotionEstimate>
  compute();

  /** \brief Matches of the last run by appearance alone: indices in source and target,
   * squared distance before the alignment, metres^2. */
  const Correspondences&
  getMatches() const
  {
    return matches_;
  }

  /** \brief The matches on which the motion is based. */
  const Correspondences&
  getInliers() const
  {
    return inliers_;
  }

  /** \brief Outcome, reason, counts, residuals and seconds of the last run. */
  const EgomotionReport&
  getReport() const
  {
    return report_;
  }

  /** \brief All settings. */
  const acmap::EgomotionSettings&
  settings() const
  {
    return settings_;
  }

private:
  /** A prepared view and its cloud. */
  struct Prepared {
    PointCloudConstPtr cloud;
    std::shared_ptr<const acmap::EgomotionView> view;
  };

  std::shared_ptr<const acmap::EgomotionView>
  prepared(const PointCloudConstPtr& cloud);

  acmap::EgomotionSettings settings_;
  ProgressCallback progress_;
  PointCloudConstPtr source_, target_;
  std::vector<Prepared> kept_; ///< of the two clouds of the last run
  Correspondences matches_, inliers_;
  EgomotionReport report_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/egomotion/impl/visual_egomotion.hpp>
#endif
