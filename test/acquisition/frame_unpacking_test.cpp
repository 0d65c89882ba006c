#include "images/frame_unpacking.h"
#include "session_frames.h"

#include <pcl/core/random.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include <algorithm>
#include <map>

namespace pcl::acmap::test {
namespace {

using Bytes = std::vector<std::uint8_t>;
using testing::HasSubstr;

constexpr ChannelOrder turned_order{
    RigCamera::Vertical, RigCamera::Reference, RigCamera::Horizontal};

const std::map<std::string, BayerPattern> patterns{{"RGGB", BayerPattern::Rggb},
                                                   {"GBRG", BayerPattern::Gbrg},
                                                   {"GRBG", BayerPattern::Grbg},
                                                   {"BGGR", BayerPattern::Bggr}};

Bytes
noise(std::size_t size, std::uint64_t seed = 1)
{
  Random random(seed);
  Bytes bytes(size);
  for (std::uint8_t& byte : bytes)
    byte = static_cast<std::uint8_t>(random.bits());
  return bytes;
}

Bytes
bytesOf(const PlaneLayout& layout)
{
  return noise(static_cast<std::size_t>(layout.width * layout.height * layout.cameras));
}

/** One channel of a frame with a colour filter, whose colours are named from the upper
 * left. */
class Mosaic {
public:
  Mosaic(const Bytes& bytes, const PlaneLayout& layout, int plane, std::string filter)
  : bytes_(bytes)
  , layout_(layout)
  , plane_(plane)
  , filter_(std::move(filter))
  {}

  int
  value(int x, int y) const
  {
    const int pixel = y * layout_.width + x;
    return bytes_[static_cast<std::size_t>(layout_.cameras * pixel + plane_)];
  }

  /** The mean of the nearest pixels that have a colour. */
  int
  color(int x, int y, char color) const
  {
    x = std::clamp(x, 1, layout_.width - 2);
    y = std::clamp(y, 1, layout_.height - 2);
    for (const int farthest : {0, 1, 2}) { // squared distances
      int sum = 0;
      int found = 0;
      for (int v = y - 1; v <= y + 1; ++v)
        for (int u = x - 1; u <= x + 1; ++u)
          if ((u - x) * (u - x) + (v - y) * (v - y) == farthest &&
              filter_[static_cast<std::size_t>(2 * (v % 2) + u % 2)] == color) {
            sum += value(u, v);
            ++found;
          }
      if (found > 0)
        return (sum + found / 2) / found;
    }
    throw std::logic_error("a filter without this color");
  }

private:
  const Bytes& bytes_;
  PlaneLayout layout_;
  int plane_;
  std::string filter_;
};

TEST(FrameUnpacking, EveryCameraGetsItsBytes)
{
  for (const int cameras : {1, 2, 3})
    for (const auto& [width, height] :
         {std::pair{1, 1}, {7, 1}, {1, 5}, {67, 31}, {640, 480}}) {
      const PlaneLayout layout{width, height, cameras, turned_order};
      const Bytes bytes = bytesOf(layout);
      TrinocularFrame frame = frameOf(rigOf(8, 8), 17, 2, 5, 3);
      unpackFrame(bytes, layout, frame);
      EXPECT_EQ(frame.number, 17U);
      EXPECT_EQ(frame.observation, 2);
      EXPECT_EQ(frame.pattern, 5);
      for (int plane = 0; plane < 3; ++plane) {
        const CameraImage& image =
            frame.image(turned_order[static_cast<std::size_t>(plane)]);
        if (plane >= cameras) {
          EXPECT_EQ(image, CameraImage());
          continue;
        }
        ASSERT_TRUE(isWhole(image));
        ASSERT_EQ(image.width, width);
        ASSERT_EQ(image.height, height);
        ASSERT_EQ(image.channels, 1);
        const Mosaic expected(bytes, layout, plane, "YYYY");
        for (int y = 0; y < height; ++y)
          for (int x = 0; x < width; ++x)
            ASSERT_EQ(image.values[static_cast<std::size_t>(y * width + x)],
                      expected.value(x, y));
      }
    }
}

TEST(FrameUnpacking, ColorsAreMeansOfTheirNeighbours)
{
  for (const auto& [filter, bayer] : patterns)
    for (const int cameras : {1, 2, 3})
      for (const auto& [width, height] :
           {std::pair{3, 3}, {4, 3}, {3, 4}, {16, 4}, {35, 18}, {98, 35}}) {
        const PlaneLayout layout{width, height, cameras, turned_order, bayer};
        const Bytes bytes = bytesOf(layout);
        TrinocularFrame frame;
        unpackFrame(bytes, layout, frame);
        for (int plane = 0; plane < cameras; ++plane) {
          const CameraImage& image =
              frame.image(turned_order[static_cast<std::size_t>(plane)]);
          ASSERT_TRUE(isWhole(image));
          ASSERT_EQ(image.channels, 3);
          const Mosaic expected(bytes, layout, plane, filter);
          for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
              for (std::size_t k = 0; k < 3; ++k)
                ASSERT_EQ(image.values[3 * static_cast<std::size_t>(y * width + x) + k],
                          expected.color(x, y, "RGB"[k]))
                    << filter << ' ' << width << " x " << height << ", pixel " << x
                    << ' ' << y << ' ' << "RGB"[k];
        }
      }
}

TEST(FrameUnpacking, ThreadsOfOpenCvDoNotMatter)
{
  const PlaneLayout layout{640, 480, 3, turned_order, BayerPattern::Gbrg};
  const Bytes bytes = bytesOf(layout);
  const int before = cv::getNumThreads();
  TrinocularFrame alone, shared;
  cv::setNumThreads(1);
  unpackFrame(bytes, layout, alone);
  cv::setNumThreads(2);
  unpackFrame(bytes, layout, shared);
  cv::setNumThreads(before);
  EXPECT_EQ(alone.images, shared.images);
}

TEST(FrameUnpacking, MemoryIsUsedAgain)
{
  for (const BayerPattern bayer : {BayerPattern::None, BayerPattern::Grbg}) {
    const PlaneLayout layout{64, 48, 3, turned_order, bayer};
    TrinocularFrame frame;
    unpackFrame(bytesOf(layout), layout, frame);
    std::array<const std::uint8_t*, 3> places{};
    for (std::size_t i = 0; i < 3; ++i)
      places[i] = frame.images[i].values.data();
    const TrinocularFrame first = frame;
    unpackFrame(noise(3 * 64 * 48, 2), layout, frame);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(frame.images[i].values.data(), places[i]);
      EXPECT_FALSE(frame.images[i] == first.images[i]);
    }
  }
}

TEST(FrameUnpacking, BytesBeyondTheFrameAreLeftAlone)
{
  const PlaneLayout layout{16, 12, 3, turned_order};
  Bytes bytes = bytesOf(layout);
  TrinocularFrame frame, padded;
  unpackFrame(bytes, layout, frame);
  bytes.resize(bytes.size() + 448, 255);
  unpackFrame(bytes, layout, padded);
  EXPECT_EQ(frame.images, padded.images);
}

TEST(FrameUnpacking, WhatCannotBeIsRefused)
{
  TrinocularFrame frame = frameOf(rigOf(8, 8), 1, 0, 0);
  const TrinocularFrame before = frame;
  const auto faultOf = [&](const PlaneLayout& layout, std::size_t bytes) {
    return faultOfRunning<BadArgumentException>(
        [&] { unpackFrame(noise(bytes), layout, frame); });
  };
  const BayerPattern none = BayerPattern::None;
  const ChannelOrder twice{
      RigCamera::Vertical, RigCamera::Horizontal, RigCamera::Vertical};
  EXPECT_THAT(faultOf({8, 8, 3, turned_order, none}, 191),
              HasSubstr("191 bytes; its images need 192"));
  EXPECT_THAT(faultOf({0, 8, 3, turned_order, none}, 192), HasSubstr("at least 1"));
  EXPECT_THAT(faultOf({8, -8, 3, turned_order, none}, 192), HasSubstr("8 x -8"));
  EXPECT_THAT(faultOf({8, 2, 3, turned_order, BayerPattern::Rggb}, 192),
              HasSubstr("at least 3"));
  EXPECT_THAT(faultOf({8, 8, 0, turned_order, none}, 192), HasSubstr("0 cameras"));
  EXPECT_THAT(faultOf({8, 8, 4, turned_order, none}, 256), HasSubstr("4 cameras"));
  EXPECT_THAT(faultOf({8, 8, 3, twice, none}, 192), HasSubstr("vertical camera twice"));
  EXPECT_EQ(faultOf({8, 8, 2, twice, none}, 128), ""); // the third camera is not used
  expectEqual(before, frameOf(rigOf(8, 8), 1, 0, 0));
}

TEST(FrameUnpacking, FiltersHaveNames)
{
  for (const auto& [filter, bayer] : patterns)
    EXPECT_EQ(bayerPatternOf(filter), bayer);
  EXPECT_EQ(bayerPatternOf("YYYY"), BayerPattern::None);
  EXPECT_EQ(bayerPatternOf(""), BayerPattern::None);
  for (const char* const nonsense : {"gbrg", "RGB", "GGGG", "\xff\xff\xff\xff"})
    EXPECT_THROW(bayerPatternOf(nonsense), BadArgumentException) << nonsense;
}

} // namespace
} // namespace pcl::acmap::test
