#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/point_types.h>
#include <pcl/core/report.h>
#include <pcl/egomotion/log_polar_kernel.h>
#include <pcl/memory.h>
#include <pcl/registration/correspondence_estimation.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace pcl::registration {

/** \brief What CorrespondenceEstimationLogPolar tells about its last run.
 * \ingroup egomotion */
struct LogPolarReport : Report {
  std::size_t source_keypoints = 0, target_keypoints = 0; ///< with a place
  std::size_t source_patches = 0,
              target_patches = 0; ///< inside the image, with contrast
  std::size_t weak = 0;           ///< sources whose best score is below the least
  std::size_t ambiguous = 0;      ///< whose second best is too near the best
  std::size_t one_sided = 0;      ///< who are not the best of their best
  std::size_t matches = 0;
};

/** \brief Matches keypoints of two organized clouds by how they look: the Pearson
 * coefficient of log-polar patches. Feature matching of "Active Stereo Based Compact
 * Mapping", II-B.1: the coefficient is blind to gain and offset of the light, the
 * log-polar grid makes a change of scale and a turn shifts of its rings and sectors.
 *
 * A match is strong (\ref setMinimumScore), distinct from the second best that lies
 * elsewhere (\ref setMaximumAmbiguity) and mutual: swapping source and target gives the
 * same matches. Source and target are the clouds as they came from the camera, organized,
 * colour at every pixel; keypoints are their indices (setIndicesSource,
 * setIndicesTarget), or those that \ref GradientMaximumKeypoint finds without them. In an
 * ICP loop the clouds may be moved, only distances use their coordinates; but give ICP no
 * guess, for it would drop the colours and the rows.
 *
 * Output: `index_query` in the source, `index_match` in the target, `distance` the squared
 * metres between both; \ref getScores the coefficients. By source index. Time: O(n m) for n and m
 * keypoints, one matrix product a shift; the same bytes for every number of threads.
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
   * \throws BadArgumentException unless rings are within [2, 64] and sectors within [4,
   * 128], or when the shifts that are set (\ref setMaximumShifts) ask for more: at least
   * ring shifts + 2 rings, and twice as many sectors as sector shifts */
  void
  setGrid(int rings, int sectors);

  /** \brief Sets the radii of the first and the last ring (default 1 and 20), pixels.
   * \throws BadArgumentException unless 0.5 <= inner < outer <= 200 */
  void
  setRadii(float inner, float outer);

  /** \brief Sets the least Pearson coefficient (default 0.8).
   * \throws BadArgumentException unless within [-1, 1] */
  void
  setMinimumScore(float score);

  /** \brief Sets how ambiguous a match may be (default 0.7): 1.003 - its score, divided
   * by 1.003 - that of the second best of either, more than 3 pixels from the best; at 1
   * anything better than the second will do, at 0 nothing matches.
   * \throws BadArgumentException unless within [0, 1] */
  void
  setMaximumAmbiguity(float ambiguity);

  /** \brief Sets the least standard deviation in a patch (default 0.3), grey levels.
   * \throws BadArgumentException unless within [0, 128] */
  void
  setMinimumContrast(float contrast);

  /** \brief Sets how many scales (rings) and turns (sectors) are tried on either side
   * (default 0 and 0). A ring is a factor of (outer / inner)^(1 / (rings - 1)), 1.31 by
   * default, a sector 15 degrees.
   * \throws BadArgumentException unless within [0, rings - 2] and [0, sectors / 2] */
  void
  setMaximumShifts(int rings, int sectors);

  /** \brief Sets how far a match may move in the image, pixels (default: any).
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
    settings_.threads = threads;
  }

  unsigned
  getNumberOfThreads() const
  {
    return settings_.threads;
  }

  /** \brief Pearson coefficients of the last run's matches, in their order. */
  const std::vector<float>&
  getScores() const
  {
    return scores_;
  }

  const LogPolarReport&
  getReport() const
  {
    return report_;
  }

  /** \brief Matches, each the best of the other.
   * \param[in] max_distance metres between the points of a match
   * \throws InitFailedException without source or target, or for an index outside of them
   * \throws UnorganizedPointCloudException unless both are organized (or empty)
   * \throws BadArgumentException unless max_distance is above 0 */
  void
  determineCorrespondences(
      Correspondences& correspondences,
      double max_distance = std::numeric_limits<double>::max()) override;

  /** \brief The same: matches are mutual in any case. */
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
