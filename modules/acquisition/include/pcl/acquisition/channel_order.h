#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/core/trinocular_frame.h>

#include <array>
#include <string>

namespace pcl {

/** \brief Cameras that fill the first, second and third byte of an interleaved pixel.
 * \ingroup acquisition */
using ChannelOrder = std::array<RigCamera, 3>;

/** \brief Returns the order as text, for example `reference,horizontal,vertical`.
 * \ingroup acquisition */
ACMAP_EXPORT std::string
textOf(const ChannelOrder& order);

/** \brief Reads what \ref textOf has written, or the first letters of the cameras: `r,h,v`.
 * \throws BadArgumentException for other texts \ingroup acquisition */
ACMAP_EXPORT ChannelOrder
channelOrderIn(const std::string& text);

/** \brief Result of \ref checkChannelOrder. \ingroup acquisition */
struct ChannelOrderCheck {
  /** \brief The order under which the largest number of corners was found again. The
   * assumed order is preferred if it is as good as any other. */
  ChannelOrder best{RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical};

  /** \brief True if \ref best is better than all other orders by a margin large enough
   * to rely on it. */
  bool is_certain = false;

  std::size_t corners = 0; ///< corners of the reference image that were searched for
  double share = 0; ///< fraction of them that is found again under \ref best, in [0, 1]
  double runner_up = 0; ///< the same fraction for the second best order
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const ChannelOrderCheck& check, Visitor&& visit)
{
  visit({"best"}, textOf(check.best));
  visit({"is_certain"}, check.is_certain);
  visit({"corners"}, check.corners);
  visit({"share"}, check.share);
  visit({"runner_up"}, check.runner_up);
}

/** \brief Determines the actual order of the cameras in a frame. Only under the correct
 * order are the corners of the reference image found at the positions in both other
 * images that the calibration predicts for one common depth. This test is needed
 * because the camera's stream does not contain the order, and published sources
 * disagree.
 * \param[in] frame unpacked under an order; three images, grey or in colour
 * \param[in] assumed the order under which it was unpacked
 * \param[in] calibration the cameras of the frame: the unrectified ones, or the result
 * of \ref calibrationOf a rig for rectified frames
 * \throws BadArgumentException when an image is missing or has not the calibration's
 * size
 * \ingroup acquisition */
ACMAP_EXPORT ChannelOrderCheck
checkChannelOrder(const TrinocularFrame& frame,
                  const ChannelOrder& assumed,
                  const RigCalibration& calibration);

} // namespace pcl
