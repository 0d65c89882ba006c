#pragma once

#include <pcl/acquisition/channel_order.h>
#include <pcl/core/trinocular_frame.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Colours of the upper left four pixels of a sensor, row by row. */
enum class BayerPattern { None, Rggb, Gbrg, Grbg, Bggr };

/** \brief Returns the pattern for the name in a camera register, for example `GBRG`;
 * `YYYY` or an empty string means a sensor without a colour filter.
 * \throws BadArgumentException for any other name */
BayerPattern
bayerPatternOf(const std::string& filter);

/** \brief Layout of the bytes of a frame. */
struct PlaneLayout {
  int width = 0;   ///< px, at least 1; with a colour filter at least 3
  int height = 0;  ///< px, as the width
  int cameras = 3; ///< 1 to 3: number of bytes per pixel, one for each camera
  ChannelOrder order{RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical};
  BayerPattern bayer = BayerPattern::None;
};

/** \brief Separates a frame into images: grey ones or, with a colour filter, colour
 * images, in which each missing colour is the mean of its two or four nearest
 * neighbours; the outermost pixels are copies of their inner neighbours. The memory of
 * existing images is reused; images of cameras that are not in the layout become empty.
 * \param[in] bytes additional bytes after the frame are ignored
 * \param[in,out] frame only its images change
 * \throws BadArgumentException if the layout is invalid or there are too few bytes */
void
unpackFrame(const std::vector<std::uint8_t>& bytes,
            const PlaneLayout& layout,
            TrinocularFrame& frame);

} // namespace pcl::acmap
