#pragma once

#include "clouds/field_layout.h"

#include <pcl/core/impl/large_memory.h>
#include <pcl/core/point_cloud_file.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

class ByteSource;

/** \brief Implementations of \ref loadPointCloud. They read from any source of bytes,
 * so that they can be fuzzed without files.
 *
 * A reader of n bytes takes at most 16 n bytes of memory, 450 n if the file is
 * compressed (LZF expands a byte to up to 88 bytes), plus one megabyte.
 * \param[out] rows binary points are read into these, if they are given, instead of into
 * the cloud, which then has no data; they are empty before
 * \param[in] stated lengths and the shift of the result are those of the file, multiplied by
 * nobody
 * \throws InputFileException when the data do not match their header */
PointCloudFile
readPcd(ByteSource& source,
        LargeVector<std::uint8_t>* rows = nullptr,
        const CloudStatement& stated = {});
PointCloudFile
readPly(ByteSource& source,
        LargeVector<std::uint8_t>* rows = nullptr,
        const CloudStatement& stated = {});
PointCloudFile
readObj(ByteSource& source, const CloudStatement& stated = {});

/** \param[in] is_pts of seven columns the fourth is the intensity, and lines with a count may
 * be above any block of rows */
PointCloudFile
readText(ByteSource& source, bool is_pts = false, const CloudStatement& stated = {});
PointCloudFile
readLas(ByteSource& source,
        LargeVector<std::uint8_t>* rows = nullptr,
        const CloudStatement& stated = {});
PointCloudFile
readE57(ByteSource& source,
        LargeVector<std::uint8_t>* rows = nullptr,
        const CloudStatement& stated = {});
PointCloudFile
readPtx(ByteSource& source,
        LargeVector<std::uint8_t>* rows = nullptr,
        const CloudStatement& stated = {});

/** \brief What to do with a file that LASzip has packed. */
std::string
packedAdvice(const std::string& path);

/** \brief Finds the shift of points that were read from a text, and subtracts it from them.
 * \param[in] places x, y, z of all points in the file
 * \param[in] is_rounded the text was written of float32 */
void
shiftPlaces(const std::vector<double>& places,
            const CloudStatement& stated,
            bool is_rounded,
            PointCloudFile& file);

/** \brief Calls a function with the bytes that get the points of a file: the rows, if they
 * are given, else the data of its cloud. */
template <typename Function>
void
intoRows(LargeVector<std::uint8_t>* rows,
         PCLPointCloud2& cloud,
         const Function& function)
{
  if (rows)
    function(*rows);
  else
    function(cloud.data);
}

/** \brief Appends points, one block after the other, so that a header that claims too many
 * does not cost their memory.
 * \param[in] count number of points
 * \param[in] step bytes of a point
 * \param[in] block number of points of a block
 * \param[in,out] data vector of bytes
 * \param[in] read called with the number of points of a block and with their place, which
 * has zeros */
template <typename Bytes, typename Read>
void
appendBlocks(std::size_t count,
             std::size_t step,
             std::size_t block,
             Bytes& data,
             const Read& read)
{
  const std::size_t begin = data.size();
  reserveLarge(data, begin + count * step);
  for (std::size_t done = 0; done < count; done += block) {
    const std::size_t now = std::min(block, count - done);
    data.resize(begin + (done + now) * step);
    read(now, &data[begin + done * step]);
  }
}

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

/** \brief Rejects more points than an index can represent. */
void
requireCountable(std::uint64_t points, const ByteSource& source);

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
   * than float32
   * \param[in] scale metres in a unit of the file */
  explicit CoordinateCheck(bool narrowed, double scale = 1)
  : narrowed_(narrowed)
  , scale_(static_cast<float>(scale))
  {}

  /** \param[in] coordinates x of the first point of the block
   * \param[in] step bytes from a point to the next
   * \param[in] count number of points */
  void
  add(const std::uint8_t* coordinates, std::size_t step, std::size_t count);

  /** \brief Adds all points of a cloud. */
  void
  add(const PointCloudFile& file);

  /** \brief Points that were (0, 0, 0) before a shift do not count: they were not measured. */
  void
  setShift(const Eigen::Vector3d& shift)
  {
    zero_ = (-shift).cast<float>();
  }

  /** \brief Sets `is_dense`, and adds a remark if narrowing the coordinates lost more
   * than about a millimetre. */
  void
  finish(PointCloudFile& file) const;

private:
  bool narrowed_;
  float scale_;
  bool dense_ = true;
  float largest_ = 0.0F; // only if narrowed
  Eigen::Vector3f zero_ = Eigen::Vector3f::Zero();
};

/** \brief Binary records of a file, which become points one block after the other. */
class RecordBlocks {
public:
  RecordBlocks(ByteSource& source, const FieldLayout& layout, bool swap_bytes);

  /** \brief Reads \a count records as points, and adds them to the check. The caller has
   * checked that the source contains them.
   * \param[out] data vector of bytes */
  template <typename Bytes>
  void
  readAll(std::size_t count, Bytes& data, CoordinateCheck& check)
  {
    appendBlocks(
        count,
        layout_.point_step,
        block_,
        data,
        [&](std::size_t now, std::uint8_t* points) { read(now, points, check); });
  }

  /** \brief Finds the shift of the records that follow, from some of them.
   * \return what the layout shall subtract */
  static Eigen::Vector3d
  findShift(ByteSource& source,
            const FieldLayout& layout,
            bool swap_bytes,
            std::uint64_t count,
            const CloudStatement& stated);

private:
  void
  read(std::size_t count, std::uint8_t* points, CoordinateCheck& check);

  ByteSource& source_;
  const FieldLayout& layout_;
  bool swap_bytes_;
  std::size_t block_; ///< records
  std::vector<std::uint8_t> records_;
  std::vector<RecordMove> moves_;
};

} // namespace pcl::acmap
