#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/trinocular_frame.h>

#include <string>

namespace pcl {

/** \brief Writes a frame as one file (`.acf`), without loss and with a checksum; what is
 * read back is equal. It stands whole in its place or not at all.
 * \throws BadArgumentException naming the frame's number, when it has no reference image,
 * images of several sizes, more than 2^28 pixels, not all values of an image, channels
 * other than 1 or 3, a negative observation or a pattern below no_pattern
 * \throws OutputFileException when the file could not be written whole
 * \ingroup acquisition */
ACMAP_EXPORT void
saveTrinocularFrame(const std::string& path, const TrinocularFrame& frame);

/** \brief Reads such a file.
 * \throws InputFileException naming file, the frame's number where it is known, and fault:
 * missing, no frame file, of another version, truncated, too long, sizes that no frame
 * can have, a wrong checksum
 * \ingroup acquisition */
ACMAP_EXPORT TrinocularFrame
loadTrinocularFrame(const std::string& path);

} // namespace pcl
