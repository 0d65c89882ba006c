#pragma once

#include <pcl/core/export.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/pipeline/session_source.h>
#include <pcl/stereo/disparity_fusion.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief Decides, shot by shot, if an observation needs a further pattern: for
 * pcl::PatternSequenceGrabber::setWantMore. An observation ends when the patterns so far have
 * covered its pixels; nothing is matched.
 * \code
 * pcl::acmap::PatternNeed need (rectifier);
 * sequence.setWantMore ([&] (const pcl::TrinocularFrame& frame) { return need.wantsMoreAfter (frame); });
 * \endcode */
class ACMAP_EXPORT PatternNeed {
public:
  /** \param[in] rectifier of the camera's frames */
  explicit PatternNeed(FrameRectifier rectifier);

  /** \brief Adds a shot under a pattern, as received from the camera.
   * \return true if a further pattern is needed */
  bool
  wantsMoreAfter(const TrinocularFrame& frame);

private:
  FrameRectifier rectifier_;
  DisparityFusion fusion_;
  std::optional<std::int32_t> observation_;
};

/** \brief The frames of an observation as they are matched: rectified.
 * \param[in] frames as received from the camera
 * \param[in,out] groups leaves out what cannot be used
 * \return nothing without a shot */
ACMAP_EXPORT std::optional<ObservationShots>
shotsOf(const std::vector<TrinocularFrame::ConstPtr>& frames,
        const FrameRectifier& rectifier,
        ShotGroups& groups);

} // namespace pcl::acmap
