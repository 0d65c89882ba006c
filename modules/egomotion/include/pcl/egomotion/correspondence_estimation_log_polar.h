#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/fields.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/point_types.h>
#include <pcl/core/report.h>
#include <pcl/egomotion/impl/log_polar_kernel.h>
#include <pcl/memory.h>
#include <pcl/registration/correspondence_estimation.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace pcl::registration {

/** \brief Report of CorrespondenceEstimationLogPolar on its last run.
 * \ingroup egomotion */
struct LogPolarReport : Report {
  std::size_t source_keypoints = 0, target_keypoints = 0; ///< with a 3D point
  std::size_t source_patches = 0,
              target_patches = 0; ///< inside the image, with contrast
  std::size_t weak = 0;           ///< sources whose best score is below the minimum
  std::size_t ambiguous = 0;      ///< sources whose second best score is too similar
  std::size_t one_sided = 0;      ///< sources that are not the best of their target
  std::size_t matches = 0;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const LogPolarReport& report, Visitor&& visit)
{
  visit({"source_keypoints"}, report.source_keypoints);
  visit({"target_keypoints"}, report.target_keypoints);
  visit({"source_patches"}, report.source_patches);
  visit({"target_patches"}, report.target_patches);
  visit({"weak"}, report.weak);
  visit({"ambiguous"}, report.ambiguous);
  visit({"one_sided"}, report.one_sided);
  visit({"matches"}, report.matches);
}

/** \brief Matches keypoints of two organized clouds by appearance, using the Pearson
 * coefficient of log-polar patches. Feature matching of "Active Stereo Based Compact
 * Mapping", II-B.1: the coefficient is invariant to gain and offset of the light; on
 * the log-polar grid a change of scale shifts the rings, and a rotation shifts the
 * sectors.
 *
 * A match is strong (\ref setMinimumScore), distinct from the second best at another
 * position (\ref setMaximumAmbiguity) and mutual: swapping source and target gives the
 * same matches. Source and target must be the clouds as received from the camera:
 * organized, with a colour at every pixel. Keypoints are their indices
 * (setIndicesSource, setIndicesTarget); if no indices are set,
 * \ref GradientMaximumKeypoint finds them. In an ICP loop the clouds may be moved,
 * because coordinates are only used for distances; but do not pass a guess to ICP,
 * because it would discard the colours and the rows.
 *
 * Output: `index_query` in the source, `index_match` in the target, `distance` in
 * squared metres; \ref getScores returns the coefficients. Matches are ordered by
 * source index. Time: O(n m) for n and m keypoints under each shift; most pairs are
 * excluded by a bound from 32 numbers of each patch, which does not change the result.
 * It is the same for every number of threads.
 * \code
 * pcl::registration::CorrespondenceEstimationLogPolar<pcl::PointXYZRGB> matcher;
 * matcher.setInputSource (now);
 * matcher.setIndicesSource (now_keypoints);
 * matcher.setInputTarget (before);
 * matcher.setIndicesTarget (before_keypoints);
 * pcl::Correspondences matches;
 * matcher.determineCorrespondences (matches, 1.0);
 * \endcode
 * \ingroup egomotion
 */
template <typename PointSource,
          typename PointTarget = PointSource,
          typename Scalar = float>
class CorrespondenceEstimationLogPolar
: public CorrespondenceEstimationBase<PointSource, PointTarget, Scalar> {
  using Base = CorrespondenceEstimationBase<PointSource, PointTarget, Scalar>;

public:
  using Ptr = shared_ptr<CorrespondenceEstimationLogPolar>;
  using ConstPtr = shared_ptr<const CorrespondenceEstimationLogPolar>;

  CorrespondenceEstimationLogPolar();

  /** \brief Sets the grid (default 12 rings of 24 samples).
   * \throws BadArgumentException unless rings are within [2, 64] and sectors within
   * [4, 128], or when the shifts that are set (\ref setMaximumShifts) require more: at
   * least ring shifts + 2 rings, and twice as many sectors as sector shifts */
  void
  setGrid(int rings, int sectors);

  /** \brief Sets the radii of the first and the last ring (default 1 and 20), pixels.
   * \throws BadArgumentException unless 0.5 <= inner < outer <= 200 */
  void
  setRadii(float inner, float outer);

  /** \brief Sets the minimum Pearson coefficient (default 0.8).
   * \throws BadArgumentException unless within [-1, 1] */
  void
  setMinimumScore(float score);

  /** \brief Sets the maximum ambiguity of a match (default 0.7): 1.003 - its score,
   * divided by 1.003 - the second best score of either keypoint, more than 3 pixels
   * from the best. At 1, any match that is better than the second best is accepted; at
   * 0, none is.
   * \throws BadArgumentException unless within [0, 1] */
  void
  setMaximumAmbiguity(float ambiguity);

  /** \brief Sets the minimum standard deviation in a patch (default 0.3), grey levels.
   * \throws BadArgumentException unless within [0, 128] */
  void
  setMinimumContrast(float contrast);

  /** \brief Sets the number of scales (rings) and rotations (sectors) that are tried in
   * either direction (default 0 and 0). A ring is a factor of
   * (outer / inner)^(1 / (rings - 1)), 1.31 by default; a sector is 15 degrees by
   * default.
   * \throws BadArgumentException unless within [0, rings - 2] and [0, sectors / 2] */
  void
  setMaximumShifts(int rings, int sectors);

  /** \brief Sets the maximum displacement in the image, pixels (default: any).
   * \throws BadArgumentException unless above 0 */
  void
  setMaximumImageDistance(float pixels);

  const acmap::LogPolarSettings&
  getSettings() const
  {
    return settings_;
  }

  float
  getMaximumImageDistance() const
  {
    return image_distance_;
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

  /** \brief Pearson coefficients of the matches of the last run, in their order. */
  const std::vector<float>&
  getScores() const
  {
    return scores_;
  }

  /** \brief Sets the target, also to none, which PCL's setter would read. */
  void
  setInputTarget(const typename Base::PointCloudTargetConstPtr& cloud)
  {
    target_ = cloud;
    this->target_cloud_updated_ = true;
  }

  const LogPolarReport&
  getReport() const
  {
    return report_;
  }

  /** \brief Finds the matches, each of which is mutually the best.
   * \param[in] max_distance maximum distance between the points of a match, metres
   * \throws InitFailedException without source or target, or for an index outside them
   * \throws UnorganizedPointCloudException unless both are organized (or empty)
   * \throws BadArgumentException unless max_distance is above 0 */
  void
  determineCorrespondences(
      Correspondences& correspondences,
      double max_distance = std::numeric_limits<double>::max()) override;

  /** \brief Same as \ref determineCorrespondences, matches are mutual in any case. */
  void
  determineReciprocalCorrespondences(
      Correspondences& correspondences,
      double max_distance = std::numeric_limits<double>::max()) override;

  typename Base::Ptr
  clone() const override;

private:
  using PCLBase<PointSource>::input_;
  using PCLBase<PointSource>::indices_;
  using Base::corr_name_;
  using Base::target_;
  using Base::target_indices_;

  acmap::LogPolarSettings settings_;
  float image_distance_ = std::numeric_limits<float>::infinity();
  std::vector<float> scores_;
  LogPolarReport report_;
};

} // namespace pcl::registration

#ifdef PCL_NO_PRECOMPILE
#include <pcl/egomotion/impl/correspondence_estimation_log_polar.hpp>
#endif
