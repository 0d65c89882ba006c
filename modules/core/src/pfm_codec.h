#pragma once

#include <pcl/core/disparity_image.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

class ByteSource;

/** \brief Implementation of \ref loadPfm.
 * \throws InputFileException naming the fault */
DisparityImage
readPfm(ByteSource& source);

/** \brief Returns the bytes that \ref savePfm writes.
 * \throws BadArgumentException as \ref savePfm */
std::vector<std::uint8_t>
encodePfm(const DisparityImage& image);

} // namespace pcl::acmap
