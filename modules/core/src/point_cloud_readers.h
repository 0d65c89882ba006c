#pragma once

#include "field_layout.h"

#include <pcl/core/point_cloud_file.h>

#include <cstddef>
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
PointCloudFile
readLas(ByteSource& source);
PointCloudFile
readE57(ByteSource& source);

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

/** \brief Sets the fields of the cloud and its size, without points. */
void
describeCloud(PCLPointCloud2& cloud,
              const FieldLayout& layout,
              std::uint64_t width,
              std::uint64_t height);

/** \brief Like \ref describeCloud, with zeros as points. */
void
shapeCloud(PCLPointCloud2& cloud,
           const FieldLayout& layout,
           std::uint64_t width,
           std::uint64_t height);

/** \brief Checks the coordinates of a cloud, all at once or in blocks. */
class CoordinateCheck {
public:
  /** \param[in] narrowed the coordinates are converted from a type with more digits
   * than float32 */
  explicit CoordinateCheck(bool narrowed)
  : narrowed_(narrowed)
  {}

  /** \param[in] coordinates x of the first point of the block
   * \param[in] step bytes from a point to the next
   * \param[in] count number of points */
  void
  add(const std::uint8_t* coordinates, std::size_t step, std::size_t count);

  /** \brief Adds all points of a cloud. */
  void
  add(const PointCloudFile& file);

  /** \brief Sets `is_dense`, and adds a remark if narrowing the coordinates lost more
   * than about a millimetre. */
  void
  finish(PointCloudFile& file) const;

private:
  bool narrowed_;
  bool dense_ = true;
  float largest_ = 0.0F; // only if narrowed
};

/** \brief Reads \a count binary records as the points of a described cloud, and adds
 * them to the check. The caller has checked that the source contains them. */
void
readRecords(ByteSource& source,
            const FieldLayout& layout,
            bool swap_bytes,
            std::size_t count,
            PCLPointCloud2& cloud,
            CoordinateCheck& check);

} // namespace pcl::acmap
