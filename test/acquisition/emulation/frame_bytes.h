#pragma once

#include <pcl/core/trinocular_frame.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Which camera the first, second and third byte of each pixel belong to. */
using ChannelOrder = std::array<RigCamera, 3>;

/** \brief The grey images of a frame as a camera sends them in RGB8: a byte of each. */
std::vector<std::uint8_t>
interleaved(const TrinocularFrame& frame, const ChannelOrder& order);

/** \brief What a sensor under a colour filter sees of an image of three channels.
 * \param[in] tiles the colours of two rows of two pixels, as `GBRG` */
CameraImage
mosaicOf(const CameraImage& colour, const std::string& tiles);

} // namespace pcl::acmap::test
