#pragma once

#include <pcl/acquisition/pattern_projector.h>
#include <pcl/core/trinocular_grabber.h>

#include <optional>

namespace pcl {

/** \brief How long to wait after \ref PatternProjector::show, so that a shot which is
 * exposed from then on sees the new image alone: for \ref
 * PatternSequenceGrabber::setSettleTime.
 *
 * Black and a bright image are shown by turns, three times each, and shots are taken
 * all the while. From the delay behind the longest of the six changes on, the pixels
 * that the projector lights have come 95 % of their way, or as near as noise and a room
 * with daylight let them. One period of the camera is added: projector and camera are
 * not in phase. Takes about 5 s with a camera of five shots a second or more;
 * afterwards the camera is stopped, and the projector is dark.
 *
 * \param[in] camera gives one frame for each trigger; nobody else uses it meanwhile
 * \param[in] projector nobody else uses it meanwhile
 * \param[in] bright say white, of the projector's size
 * \return seconds; nothing when no change was seen (the projector is off, or does not
 * light what the camera sees), when the room itself changed as much, or when a change
 * took longer than a third of a second
 * \throws BadArgumentException for no camera or no projector; for an image that the
 * projector refuses
 * \throws IOException when camera or projector fail
 * \code
 * if (const auto seconds = pcl::measureSettleTime (camera, projector, white))
 *   grabber.setSettleTime (*seconds);
 * \endcode
 * \ingroup acquisition */
ACMAP_EXPORT std::optional<double>
measureSettleTime(const shared_ptr<TrinocularGrabber>& camera,
                  const shared_ptr<PatternProjector>& projector,
                  const RgbImage& bright);

} // namespace pcl
