#pragma once

#include <pcl/core/export.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/core/trinocular_frame.h>

#include <array>
#include <string>

namespace pcl {

/** \brief Which camera fills the first, second and third byte of an interleaved pixel.
 * \ingroup acquisition */
using ChannelOrder = std::array<RigCamera, 3>;

/** \brief Say `reference,horizontal,vertical`. \ingroup acquisition */
ACMAP_EXPORT std::string
textOf(const ChannelOrder& order);

/** \brief What \ref checkChannelOrder found. \ingroup acquisition */
struct ChannelOrderCheck {
  /** \brief The order under which most corners were found again: the given one where it is
   * as good as any. */
  ChannelOrder best{RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical};

  /** \brief Whether best stands out far enough from all others to rely on it. */
  bool is_certain = false;

  std::size_t corners = 0; ///< of the reference image that were looked for
  double share = 0;        ///< of them that best finds again, in [0, 1]
  double runner_up = 0;    ///< likewise under the best other order
};

/** \brief Finds out in which order the cameras of a frame really are: only under the right
 * one lie the corners of the reference where the calibration lets a neighbour see them,
 * for one and the same depth in both. Nothing in the stream of a camera tells it, and
 * sources disagree.
 * \param[in] frame unpacked under an order; three images, grey or in colour
 * \param[in] assumed that order
 * \param[in] calibration the cameras that the frame is of: as they are built, or
 * \ref calibrationOf a rig for rectified frames
 * \throws BadArgumentException when an image is missing, or not of the calibration's size
 * \ingroup acquisition */
ACMAP_EXPORT ChannelOrderCheck
checkChannelOrder(const TrinocularFrame& frame,
                  const ChannelOrder& assumed,
                  const RigCalibration& calibration);

} // namespace pcl
