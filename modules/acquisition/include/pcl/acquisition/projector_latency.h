#pragma once

#include <pcl/acquisition/pattern_projector.h>
#include <pcl/core/trinocular_grabber.h>

#include <optional>

namespace pcl {

/** \brief Measures how long to wait after \ref PatternProjector::show before a shot, so
 * that its exposure contains only the new image; for
 * \ref PatternSequenceGrabber::setSettleTime.
 *
 * Black and a bright image are shown alternately, three times each, while shots are
 * taken continuously. The result is based on the longest delay of the six changes,
 * after which the pixels that are lit by the projector have completed 95 % of their
 * change, or less if noise and daylight limit the accuracy. It is tried with six further
 * changes, one shot each, and lengthened until all of them are complete. One period of the
 * camera is added, since projector and camera are not in phase. The measurement takes about
 * 8 s with a camera of five or more shots per second. Afterwards the camera is stopped, and
 * the projector is dark.
 *
 * \param[in] camera gives one frame for each trigger; must not be used by others during
 * the call
 * \param[in] projector must not be used by others during the call
 * \param[in] bright for example white, of the projector's size
 * \return seconds; nothing when no change was seen (the projector is off, or lights
 * nothing that the camera sees), when the ambient light changed by a similar amount, or
 * when a change took longer than a third of a second
 * \throws BadArgumentException if there is no camera or no projector, or if the
 * projector rejects the image
 * \throws IOException when the camera or the projector fails
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
