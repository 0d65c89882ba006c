#pragma once

#include "field_layout.h"

#include <pcl/core/point_cloud_file.h>

#include <cstdint>

namespace pcl::acmap {

class ByteSource;

/** \brief Implementations of \ref loadPointCloud. They read from any source of bytes,
 * so that they can be fuzzed without files.
 *
 * A reader of n bytes takes at most 8 n bytes of memory, 450 n if the file is
 * compressed (LZF expands a byte to up to 88 bytes), plus one megabyte.
 * \throws InputFileException when the data do not match their header */
PointCloudFile
readPcd(ByteSource& source);
PointCloudFile
readPly(ByteSource& source);
PointCloudFile
readObj(ByteSource& source);
PointCloudFile
readXyz(ByteSource& source);

/** \brief Rejects more points than the remaining bytes can contain or than an index can
 * represent.
 * \param[in] bytes minimum size of a point
 * \param[in] values number of values of a point in a text, each with at least two
 * characters */
void
requirePointsFit(std::uint64_t points, std::uint64_t bytes, const ByteSource& source);
void
requireTextPointsFit(std::uint64_t points,
                     std::uint64_t values,
                     const ByteSource& source);

/** \brief Sets the fields of the cloud and allocates memory for its points. */
void
shapeCloud(PCLPointCloud2& cloud,
           const FieldLayout& layout,
           std::uint64_t width,
           std::uint64_t height);

/** \brief Checks the coordinates: sets `is_dense` and, if they were converted from a
 * type with more digits than float32, adds a remark if more than about a millimetre is
 * lost. */
void
inspectCoordinates(PointCloudFile& file, bool narrowed);

} // namespace pcl::acmap
