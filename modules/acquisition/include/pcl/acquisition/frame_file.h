#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/trinocular_frame.h>

#include <string>

namespace pcl {

/** \brief Writes a frame to one file (`.acf`), without loss and with a checksum.
 * Reading it back gives an equal frame. The file appears at its path only when it is
 * complete.
 * \throws BadArgumentException naming the frame's number, if it has no reference image,
 * images of different sizes, more than 2^28 pixels, an image without all its values, a
 * number of channels other than 1 or 3, a negative observation or a pattern below
 * no_pattern
 * \throws OutputFileException when the file could not be written completely
 * \ingroup acquisition */
ACMAP_EXPORT void
saveTrinocularFrame(const std::string& path, const TrinocularFrame& frame);

/** \brief Reads a file written by \ref saveTrinocularFrame.
 * \throws InputFileException naming the file, the frame's number if it is known, and
 * the fault: missing file, not a frame file, unsupported version, truncated, too long,
 * invalid sizes, wrong checksum
 * \ingroup acquisition */
ACMAP_EXPORT TrinocularFrame
loadTrinocularFrame(const std::string& path);

} // namespace pcl
