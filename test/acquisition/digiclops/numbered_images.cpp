#include "numbered_images.h"

#include "frame_bytes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>

namespace pcl::acmap::test {
namespace {

constexpr std::size_t height = 480;
constexpr std::size_t longest_row = std::size_t{640} * 3;
constexpr std::size_t starts = 65536; // number of offsets into the noise at which a row
                                      // can start
constexpr std::size_t specks = 5000;

/** Position of the frame number: in the centre, not in the margin. */
std::size_t
placeOfNumber(std::size_t image_bytes)
{
  return image_bytes / 2 + 60;
}

/** Bytes in the order in which the camera sends them. */
std::vector<std::uint8_t>
sentBytes(const TrinocularFrame& frame, const Sending& sending)
{
  std::vector<std::uint8_t> bytes;
  for (std::size_t channel = 0; channel < sending.cameras; ++channel) {
    const CameraImage& image = frame.image(sending.order[channel]);
    EXPECT_EQ(image.channels, sending.tiles.empty() ? 1 : 3);
    const CameraImage plane =
        sending.tiles.empty() ? image : mosaicOf(image, sending.tiles);
    bytes.resize(sending.cameras * plane.values.size());
    for (std::size_t i = 0; i < plane.values.size(); ++i)
      bytes.at(sending.cameras * i + channel) = plane.values[i];
  }
  return bytes;
}

/** Sets the margin to zero, because its colours are not those of the sensor. */
void
clearMargin(std::vector<std::uint8_t>& bytes, std::size_t row)
{
  std::fill_n(bytes.begin(), row, 0);
  std::fill_n(bytes.end() - static_cast<std::ptrdiff_t>(row), row, 0);
  for (std::size_t begin = 0; begin < bytes.size(); begin += row) {
    std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(begin), 3, 0);
    std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(begin + row) - 3, 3, 0);
  }
}

} // namespace

NumberedImages::NumberedImages(std::uint64_t seed)
: noise_(longest_row + starts)
{
  std::mt19937_64 random(seed);
  for (std::size_t i = 0; i + 8 <= noise_.size(); i += 8) {
    const std::uint64_t value = random();
    std::memcpy(noise_.data() + i, &value, 8);
  }
}

std::vector<std::uint8_t>
NumberedImages::bytesOf(std::uint64_t number, std::size_t image_bytes) const
{
  const std::size_t row = image_bytes / height;
  const std::uint8_t* const stripes = noise_.data() + number * 7919 % starts;
  std::vector<std::uint8_t> bytes(image_bytes);
  for (std::size_t y = 0; y < height; ++y)
    std::memcpy(bytes.data() + y * row, stripes, row);
  for (std::size_t i = 0; i < specks; ++i)
    bytes[(number + i * i * 2654435761) % image_bytes] ^= 1;
  std::memcpy(bytes.data() + placeOfNumber(image_bytes), &number, sizeof number);
  return bytes;
}

std::vector<std::uint8_t>
NumberedImages::expose(const Exposure& exposure)
{
  {
    const std::lock_guard lock(mutex_);
    exposures_[exposure.number] = exposure;
  }
  return bytesOf(exposure.number, exposure.setting.image_bytes);
}

Exposure
NumberedImages::exposureOf(std::uint64_t number) const
{
  const std::lock_guard lock(mutex_);
  return exposures_.at(number);
}

std::uint64_t
numberOf(const TrinocularFrame& frame,
         const NumberedImages& images,
         const Sending& sending)
{
  std::vector<std::uint8_t> bytes = sentBytes(frame, sending);
  std::uint64_t number = 0;
  std::memcpy(&number, bytes.data() + placeOfNumber(bytes.size()), sizeof number);
  std::vector<std::uint8_t> want = images.bytesOf(number, bytes.size());
  const std::size_t row = bytes.size() / height;
  if (!sending.tiles.empty()) {
    clearMargin(bytes, row);
    clearMargin(want, row);
  }
  else if (sending.is_counted)
    std::copy_n(want.begin() + static_cast<std::ptrdiff_t>(row), 4, want.begin());
  EXPECT_TRUE(bytes == want) << "frame " << number;
  return number;
}

} // namespace pcl::acmap::test
