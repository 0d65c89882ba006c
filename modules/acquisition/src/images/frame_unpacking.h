#pragma once

#include <pcl/acquisition/channel_order.h>
#include <pcl/core/trinocular_frame.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Colours of the upper left four pixels of a sensor, row by row. */
enum class BayerPattern { None, Rggb, Gbrg, Grbg, Bggr };

/** \brief Of a name as the register of a camera spells it: `GBRG`, or `YYYY` or nothing
 * for a sensor without filters.
 * \throws BadArgumentException for any other */
BayerPattern
bayerPatternOf(const std::string& filter);

/** \brief How the bytes of a frame lie. */
struct PlaneLayout {
  int width = 0;   ///< px, at least 1; 3 of a sensor under filters
  int height = 0;  ///< px, likewise
  int cameras = 3; ///< 1 to 3: bytes a pixel, one of each
  ChannelOrder order{RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical};
  BayerPattern bayer = BayerPattern::None;
};

/** \brief Takes the images of a frame apart: grey ones, or of a sensor under filters
 * colour, each missing colour being the mean of its two or four nearest neighbours; the
 * outermost pixels take over those beside them. Memory of images is used again; those of
 * cameras that the layout does not have become empty.
 * \param[in] bytes what is beyond the frame's is left alone
 * \param[in,out] frame only its images change
 * \throws BadArgumentException for a layout that cannot be, or too few bytes */
void
unpackFrame(const std::vector<std::uint8_t>& bytes,
            const PlaneLayout& layout,
            TrinocularFrame& frame);

} // namespace pcl::acmap
