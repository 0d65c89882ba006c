#pragma once

namespace pcl::acmap::bench {

/** \brief From the bytes of a camera to rectified images: CPU of a frame, beside OpenCV's
 * remap. */
void
printConversion();

/** \brief Simulated frames whose channels are mixed up: how often the check finds their
 * order, and is certain of it. */
void
printOrder();

/** \brief A minute of frames from an emulated camera on the USB, recorded. */
void
printStream();

} // namespace pcl::acmap::bench
