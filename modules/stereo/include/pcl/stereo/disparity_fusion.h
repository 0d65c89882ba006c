#pragma once

#include <pcl/core/export.h>
#include <pcl/core/progress.h>
#include <pcl/core/report.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/stereo/matched_disparity.h>
#include <pcl/stereo/trinocular_matching.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl {

/** \brief What \ref DisparityFusion tells about its last run. \ingroup stereo */
struct DisparityFusionReport : Report {
  std::size_t shots = 0;     ///< with a pattern
  std::size_t off_shots = 0; ///< without one: colour

  /** \brief Pixels by \ref DisparityOutcome. */
  std::array<std::size_t, disparity_outcomes> outcomes{};

  /** \brief After each shot with a pattern: the share of the reference's pixels that the
   * patterns so far have told apart (covered well enough to be matched), in [0, 1]. */
  std::vector<double> coverage;
};

/** \brief Makes one disparity image of the shots of an observation. Section II-A of "Active
 * Stereo Based Compact Mapping".
 *
 * - Median: each shot is matched by itself; a pixel gets the lower median of its
 *   disparities, as in the paper.
 * - Statistical: the same, then the disparities that are consistent with each other (within
 *   three robust deviations of the median, at least 1 px), their mean weighted by their
 *   variances, its standard deviation; what fails a chi-square test is told as
 *   inconsistent. The paper's future work (i).
 * - SpaceTime: all shots are matched at once, see \ref TrinocularMatching. The default: it
 *   is the most accurate, and the fastest.
 *
 * Colour is that of the mean shot without a pattern; without one, of the mean of all
 * shots. Disparities in pixels, metres only in the rig. Time O(n * disparities) a shot
 * (Median, Statistical) or O(n * disparities * shots) once (SpaceTime); memory
 * O(n * shots).
 * \code
 * pcl::DisparityFusion fusion;
 * fusion.setInputRig (grabber.getRig ());
 * for (const auto& shot : shots)
 *   fusion.addShot (shot);
 * pcl::MatchedDisparity fused;
 * fusion.fuse (fused);
 * \endcode
 * \ingroup stereo */
class ACMAP_EXPORT DisparityFusion {
public:
  enum class Method { Median, Statistical, SpaceTime };

  DisparityFusion();
  ~DisparityFusion();
  DisparityFusion(DisparityFusion&&) noexcept;
  DisparityFusion&
  operator=(DisparityFusion&&) noexcept;

  /** \brief Geometry of the frames, rectified; forgets the shots.
   * \throws BadArgumentException as \ref TrinocularMatching::setInputRig */
  void
  setInputRig(const TrinocularRig& rig);

  /** \brief How shots are matched; its threads and progress callback are not taken over,
   * nor its rig where the fusion has one. Forgets the shots. */
  void
  setMatching(const TrinocularMatching& matching);

  const TrinocularMatching&
  getMatching() const;

  /** \brief Forgets the shots where it changes the method. */
  void
  setMethod(Method method);

  Method
  getMethod() const;

  /** \brief Least number of shots a disparity must rest on (default 3, or the number of
   * shots where there are fewer); Median and Statistical.
   * \throws BadArgumentException unless within [1, 256] */
  void
  setMinimumSupport(int shots);

  int
  getMinimumSupport() const;

  /** \brief Coverage that is reached by a further shot must be larger by this share for
   * \ref wantsAnotherShot to say yes (default 0.005).
   * \throws BadArgumentException unless within [0, 1] */
  void
  setLeastGain(double share);

  double
  getLeastGain() const;

  void
  setNumberOfThreads(unsigned threads);

  unsigned
  getNumberOfThreads() const;

  /** \brief Shows progress and can cancel, in \ref addShot and \ref fuse. */
  void
  setProgressCallback(ProgressCallback callback);

  /** \brief Forgets the shots: the next one begins an observation. */
  void
  clear();

  /** \brief Takes a shot of the observation; Median and Statistical match it now.
   * \throws InitFailedException without a rig
   * \throws BadArgumentException when it is null, an image is missing, has another size
   * than the rig or not all its values, or there are 256 shots already; the shots so far
   * stay
   * \throws CancelledException when the progress callback says so; the shots so far stay */
  void
  addShot(const TrinocularFrame::ConstPtr& shot);

  /** \brief How many shots were taken, those without a pattern with them. */
  std::size_t
  shots() const;

  /** \brief Whether another pattern would still help: the last one told more pixels apart
   * than the least gain, or there are too few shots to know. For a grabber's callback, so
   * that it throws no light for nothing. */
  bool
  wantsAnotherShot() const;

  /** \brief The disparities of the shots so far; more shots may follow.
   * \param[out] fused untouched after an exception; without a shot with a pattern all
   * pixels are \ref DisparityOutcome::TooFewShots
   * \throws InitFailedException without a rig
   * \throws CancelledException when the progress callback says so */
  void
  fuse(MatchedDisparity& fused);

  /** \brief Colour of the reference view, three channels; empty without shots. */
  CameraImage
  getColor() const;

  /** \brief Of the last \ref fuse; coverage of the shots so far. */
  DisparityFusionReport
  getReport() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

/** \brief The method a name means: `median`, `statistical` or `spacetime`.
 * \throws BadArgumentException for another name \ingroup stereo */
ACMAP_EXPORT DisparityFusion::Method
disparityFusionMethod(const std::string& name);

} // namespace pcl
