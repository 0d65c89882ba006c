#pragma once

#include "shot_color.h"
#include "shot_coverage.h"

#include <pcl/core/report.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/stereo/matched_disparity.h>

#include <vector>

namespace pcl::acmap {

/** \brief What is known of a place from its shots so far. Those that are matched together
 * are kept as \ref frames, of those that are matched one by one only what was \ref matched.
 */
class Observation {
public:
  explicit Observation(const TrinocularRig& rig);

  /** \brief Takes the reference image of a shot without a pattern; like the next one, in
   * the caller's arena. */
  void
  addDark(const CameraImage& reference);

  /** \brief Takes the reference image of a shot with a pattern.
   * \param[in] deviation grey levels, of a pixel that is told apart */
  void
  addLit(const CameraImage& reference, double deviation);

  /** \brief Takes what a shot was matched to, and what was told of it; its support is
   * forgotten, as the outcome says it. */
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

  /** \brief Mean of the shots without a pattern, else of those with one. */
  CameraImage
  color() const;

  /** \brief Share of the pixels told apart, after each shot with a pattern. */
  const std::vector<double>&
  coverage() const
  {
    return shares_;
  }

  std::vector<TrinocularFrame::ConstPtr> frames;
  std::vector<MatchedDisparity> matched;
  double matching_seconds = 0; ///< of those matched one by one

private:
  ShotColor dark_color_;
  ShotColor lit_color_;
  ShotCoverage coverage_;
  std::vector<double> shares_;
};

} // namespace pcl::acmap
