#pragma once

#include "field_layout.h"

#include <pcl/core/point_cloud_file.h>

#include <cstdint>

namespace pcl::acmap {

class ByteSource;

/** \brief The readers behind \ref loadPointCloud. They work on any source of bytes, so
 * that a fuzzer can feed them without a file.
 *
 * A reader of n bytes takes at most 8 n bytes of memory, 450 n where the file is
 * compressed (LZF makes up to 88 bytes of one), and a megabyte.
 * \throws InputFileException when the bytes are not what their header says */
PointCloudFile
readPcd(ByteSource& source);
PointCloudFile
readPly(ByteSource& source);
PointCloudFile
readObj(ByteSource& source);
PointCloudFile
readXyz(ByteSource& source);

/** \brief Refuses more points than bytes follow or than an index can count.
 * \param[in] bytes what a point takes at least
 * \param[in] values of a point in a text, of two characters each */
void
requirePointsFit(std::uint64_t points, std::uint64_t bytes, const ByteSource& source);
void
requireTextPointsFit(std::uint64_t points,
                     std::uint64_t values,
                     const ByteSource& source);

/** \brief Gives the cloud the fields of the layout and memory for its points. */
void
shapeCloud(PCLPointCloud2& cloud,
           const FieldLayout& layout,
           std::uint64_t width,
           std::uint64_t height);

/** \brief Looks at the coordinates: sets `is_dense` and, where these came from more
 * digits than a float keeps, tells when more than a millimetre is lost. */
void
inspectCoordinates(PointCloudFile& file, bool narrowed);

} // namespace pcl::acmap
