#pragma once

#include "shot_color.h"
#include "shot_coverage.h"

#include <pcl/core/report.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/stereo/matched_disparity.h>

#include <vector>

namespace pcl::acmap {

/** \brief Data of the shots of an observation so far. Shots that are matched together
 * are stored in \ref frames; of shots that are matched separately only the results are
 * stored, in \ref matched. */
class Observation {
public:
  explicit Observation(const TrinocularRig& rig);

  /** \brief Adds a shot without a pattern. This function and the next one run in the
   * caller's arena. */
  void
  addDark(const TrinocularFrame::ConstPtr& shot);

  /** \brief Adds the reference image of a shot with a pattern.
   * \param[in] deviation minimum standard deviation of a covered pixel, grey levels */
  void
  addLit(const CameraImage& reference, double deviation);

  /** \brief Adds the disparities of a shot and the report of its matching; its support
   * is discarded, because the outcome implies it. */
  void
  addMatched(MatchedDisparity shot, const Report& report);

  std::size_t
  darkShots() const
  {
    return dark_color_.images();
  }

  std::size_t
  litShots() const
  {
    return lit_color_.images();
  }

  std::size_t
  shots() const
  {
    return darkShots() + litShots();
  }

  /** \brief Mean of the shots without a pattern; if there are none, of those with one.
   */
  CameraImage
  color() const;

  /** \brief Share of the covered pixels after each shot with a pattern. */
  const std::vector<double>&
  coverage() const
  {
    return shares_;
  }

  std::vector<TrinocularFrame::ConstPtr> frames;
  TrinocularFrame::ConstPtr first_dark; ///< null without a shot without a pattern
  std::vector<MatchedDisparity> matched;
  double matching_seconds = 0; ///< of the shots that were matched separately

private:
  ShotColor dark_color_;
  ShotColor lit_color_;
  ShotCoverage coverage_;
  std::vector<double> shares_;
};

} // namespace pcl::acmap
