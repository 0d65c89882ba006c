#pragma once

#include <pcl/core/disparity_image.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

class ByteSource;

/** \brief The reader behind \ref loadPfm.
 * \throws InputFileException naming the fault */
DisparityImage
readPfm(ByteSource& source);

/** \brief What \ref savePfm writes.
 * \throws BadArgumentException likewise */
std::vector<std::uint8_t>
encodePfm(const DisparityImage& image);

} // namespace pcl::acmap
