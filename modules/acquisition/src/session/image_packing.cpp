#include "image_packing.h"

#include <zlib.h>

#include <algorithm>
#include <new>

namespace pcl::acmap {

namespace {

constexpr int raw_window = -15; // no header and no checksum of zlib

std::size_t
rowBytes(const CameraImage& image)
{
  return static_cast<std::size_t>(image.width) *
         static_cast<std::size_t>(image.channels);
}

std::vector<std::uint8_t>
differencesOfRows(const CameraImage& image)
{
  const std::size_t row = rowBytes(image);
  std::vector<std::uint8_t> differences(image.values.size());
  const std::uint8_t* const values = image.values.data();
  std::copy(values, values + row, differences.data());
  for (std::size_t i = row; i < differences.size(); ++i)
    differences[i] = static_cast<std::uint8_t>(values[i] - values[i - row]);
  return differences;
}

void
addUpRows(CameraImage& image)
{
  const std::size_t row = rowBytes(image);
  for (std::size_t begin = row; begin < image.values.size(); begin += row) {
    std::uint8_t* const values = &image.values[begin];
    const std::uint8_t* const above = values - row;
    for (std::size_t i = 0; i < row; ++i)
      values[i] = static_cast<std::uint8_t>(values[i] + above[i]);
  }
}

} // namespace

std::optional<std::vector<std::uint8_t>>
packImage(const CameraImage& image)
{
  std::vector<std::uint8_t> differences = differencesOfRows(image);
  std::vector<std::uint8_t> packed(differences.size());
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, raw_window, 9, Z_RLE) != Z_OK)
    throw std::bad_alloc();
  stream.next_in = differences.data();
  stream.avail_in = static_cast<uInt>(differences.size());
  stream.next_out = packed.data();
  stream.avail_out = static_cast<uInt>(packed.size());
  const bool is_whole = deflate(&stream, Z_FINISH) == Z_STREAM_END;
  packed.resize(packed.size() - stream.avail_out);
  deflateEnd(&stream);
  if (!is_whole || packed.size() == image.values.size())
    return std::nullopt;
  return packed;
}

bool
unpackImage(const std::uint8_t* packed, std::size_t bytes, CameraImage& image)
{
  z_stream stream{};
  if (inflateInit2(&stream, raw_window) != Z_OK)
    throw std::bad_alloc();
  stream.next_in = const_cast<std::uint8_t*>(packed); // zlib's interface lacks const
  stream.avail_in = static_cast<uInt>(bytes);
  stream.next_out = image.values.data();
  stream.avail_out = static_cast<uInt>(image.values.size());
  const bool is_whole = inflate(&stream, Z_FINISH) == Z_STREAM_END &&
                        stream.avail_in == 0 && stream.avail_out == 0;
  inflateEnd(&stream);
  if (is_whole)
    addUpRows(image);
  return is_whole;
}

} // namespace pcl::acmap
