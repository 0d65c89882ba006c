#pragma once

#include <pcl/core/trinocular_frame.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief The cameras of the first, second and third byte of each pixel. */
using ChannelOrder = std::array<RigCamera, 3>;

/** \brief The grey images of a frame as a camera sends them in RGB8: one byte each. */
std::vector<std::uint8_t>
interleaved(const TrinocularFrame& frame, const ChannelOrder& order);

/** \brief What a sensor with a colour filter measures of an image of three channels.
 * \param[in] tiles the colours of two rows of two pixels, such as `GBRG` */
CameraImage
mosaicOf(const CameraImage& colour, const std::string& tiles);

} // namespace pcl::acmap::test
