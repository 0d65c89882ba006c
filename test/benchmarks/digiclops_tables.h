#pragma once

namespace pcl::acmap::bench {

/** \brief From the bytes of a camera to rectified images: CPU time per frame, compared
 * with OpenCV's remap. */
void
printConversion();

/** \brief Simulated frames with permuted channels: how often the check finds their
 * order and is certain of it. */
void
printOrder();

/** \brief Records one minute of frames from an emulated USB camera. */
void
printStream();

} // namespace pcl::acmap::bench
