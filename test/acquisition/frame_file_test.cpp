#include "session/frame_codec.h"
#include "session/little_endian.h"
#include "session_frames.h"
#include "temporary_folder.h"

#include <pcl/acquisition/frame_file.h>
#include <pcl/core/random.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

// Offsets in the file, from doc/acquisition/frame_file.md.
constexpr std::size_t number_place = 12;
constexpr std::size_t first_image_place = 36;
constexpr std::size_t second_image_place = 60;

TrinocularFrame
smallFrame()
{
  return frameOf(rigOf(16, 12), 17, 2, 5);
}

std::string
faultOf(const Bytes& bytes)
{
  return faultOfRunning<InputFileException>([&] { decodeFrame("f.acf", bytes); });
}

/** The small frame with a modified number in its header, and a valid checksum. */
template <typename Unsigned>
Bytes
frameWith(std::size_t place, Unsigned value)
{
  Bytes bytes = encodeFrame(smallFrame());
  std::uint8_t* to = &bytes[place];
  putNumber(to, value);
  to = &bytes[bytes.size() - 4];
  putNumber(to, checksumOf(bytes.data(), bytes.size() - 4));
  return bytes;
}

TEST(FrameFile, KeepsEveryBit)
{
  const TemporaryFolder folder;
  for (const int channels : {1, 3})
    for (const auto& [width, height] : {std::pair{64, 48}, {1, 1}, {1, 40}, {40, 1}}) {
      const auto frame =
          frameOf(rigOf(width, height), 123456789012345, 7, 11, channels);
      const std::string path = folder.path("a.acf");
      saveTrinocularFrame(path, frame);
      expectEqual(loadTrinocularFrame(path), frame);
      EXPECT_EQ(contentOf(path).size(), encodeFrame(frame).size());
    }
}

TEST(FrameFile, KeepsCamerasThatAreMissingAndKindsThatDiffer)
{
  TrinocularFrame frame = smallFrame();
  frame.image(RigCamera::Horizontal) = {};
  frame.image(RigCamera::Vertical) = noisyImage(16, 12, 3, 5);
  frame.pattern = TrinocularFrame::no_pattern;
  expectEqual(decodeFrame("f.acf", encodeFrame(frame)), frame);
}

TEST(FrameFile, IsSmallWhereImagesAreSmoothAndNeverMuchLonger)
{
  TrinocularFrame frame;
  frame.images[0] = {100, 80, 1, Bytes(8000, 77)};
  expectEqual(decodeFrame("f.acf", encodeFrame(frame)), frame);
  EXPECT_LT(encodeFrame(frame).size(), 300U);
  Random random(3);
  for (std::uint8_t& value : frame.images[0].values)
    value = static_cast<std::uint8_t>(random.bits());
  expectEqual(decodeFrame("f.acf", encodeFrame(frame)), frame);
  EXPECT_EQ(encodeFrame(frame).size(), frame_header_bytes + 8000 + 4);
}

TEST(FrameFile, SameFrameSameBytes)
{
  EXPECT_EQ(encodeFrame(smallFrame()), encodeFrame(smallFrame()));
}

TEST(FrameFile, RefusesFramesThatCannotBe)
{
  const std::vector<std::pair<std::string, std::function<void(TrinocularFrame&)>>>
      cases{{"observation -1", [](auto& f) { f.observation = -1; }},
            {"pattern -2", [](auto& f) { f.pattern = -2; }},
            {"reference camera: has no image", [](auto& f) { f.images[0] = {}; }},
            {"horizontal camera: 20 x 12 pixels, the reference has 16 x 12",
             [](auto& f) { f.images[1] = noisyImage(20, 12, 1, 1); }},
            {"vertical camera: 2 channels", [](auto& f) { f.images[2].channels = 2; }},
            {"vertical camera: 191 bytes cannot hold",
             [](auto& f) { f.images[2].values.pop_back(); }},
            {"horizontal camera: 1 bytes",
             [](auto& f) {
               f.images[1] = {0, 0, 1, {9}};
             }},
            {"horizontal camera: an image of", [](auto& f) { f.images[1].height = 0; }},
            {"at most 2^28", [](auto& f) { f.images[0].width = -1; }}};
  for (const auto& [fault, spoil] : cases) {
    TrinocularFrame frame = smallFrame();
    spoil(frame);
    EXPECT_THAT(faultOfRunning<BadArgumentException>([&] { encodeFrame(frame); }),
                testing::AllOf(HasSubstr("frame 17: "), HasSubstr(fault)));
  }
}

TEST(FrameFile, RefusesEveryTruncation)
{
  const Bytes bytes = encodeFrame(smallFrame());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const Bytes begin(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_NE(faultOf(begin), "") << size;
  }
  EXPECT_THAT(faultOf(Bytes(bytes.begin(), bytes.end() - 1)),
              HasSubstr("f.acf: frame 17: is truncated"));
  Bytes longer = bytes;
  longer.push_back(0);
  EXPECT_THAT(faultOf(longer), HasSubstr("1 bytes too many"));
}

TEST(FrameFile, RefusesEveryFlippedBit)
{
  Bytes bytes = encodeFrame(smallFrame());
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    EXPECT_NE(faultOf(bytes), "") << bit;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
  }
  ++bytes[bytes.size() / 2];
  EXPECT_THAT(faultOf(bytes), HasSubstr("f.acf: frame 17: its checksum is wrong"));
}

TEST(FrameFile, RefusesRandomDamage)
{
  const Bytes whole = encodeFrame(smallFrame());
  Random random(7);
  for (int round = 0; round < 2000; ++round) {
    Bytes bytes = whole;
    for (std::uint64_t n = 1 + random.bits() % 8; n > 0; --n)
      bytes[random.bits() % bytes.size()] = static_cast<std::uint8_t>(random.bits());
    EXPECT_EQ(faultOf(bytes).empty(), bytes == whole) << round;
  }
}

TEST(FrameFile, RefusesHeadersThatLie)
{
  const Bytes same = frameWith<std::uint64_t>(number_place, 17);
  EXPECT_EQ(faultOf(same), "");
  EXPECT_THAT(faultOf(frameWith<std::uint32_t>(8, 2)),
              HasSubstr("written by a newer acmap (format 2"));
  for (const auto& [place, value, fault] :
       {std::tuple{first_image_place, 17U, "horizontal camera: 16 x 12 pixels"},
        {first_image_place + 8, 4U, "4 channels"},
        {first_image_place, 0x40000001U, "at most 2^28"},
        {first_image_place + 12, 2U, "packing 2"},
        {second_image_place + 12, 0U, "cannot hold"}})
    EXPECT_THAT(faultOf(frameWith<std::uint32_t>(place, value)),
                testing::AllOf(HasSubstr("frame 17"), HasSubstr(fault)));
  // More bytes than the file has, and a number so large that the sum would overflow.
  for (const std::uint64_t bytes : {std::uint64_t{191}, ~std::uint64_t{0}})
    EXPECT_NE(faultOf(frameWith<std::uint64_t>(first_image_place + 16, bytes)), "");
}

TEST(FrameFile, RefusesImagesThatDoNotUnpackToTheirSize)
{
  // A valid checksum over a frame whose packed bytes belong to a taller image.
  const TrinocularFrame tall = frameOf(rigOf(16, 13), 17, 2, 5);
  Bytes bytes = encodeFrame(tall);
  for (const std::size_t image : {0U, 1U, 2U}) {
    std::uint8_t* height = &bytes[first_image_place + 24 * image + 4];
    putNumber(height, std::uint32_t{12});
  }
  std::uint8_t* end = &bytes[bytes.size() - 4];
  putNumber(end, checksumOf(bytes.data(), bytes.size() - 4));
  EXPECT_THAT(faultOf(bytes), HasSubstr("its image cannot be unpacked"));
}

TEST(FrameFile, NamesFilesThatAreNone)
{
  const TemporaryFolder folder;
  const auto fault = [](const std::string& path) {
    return faultOfRunning<InputFileException>([&] { loadTrinocularFrame(path); });
  };
  const std::string missing = folder.path("none.acf");
  EXPECT_THAT(fault(missing), HasSubstr(missing + ": No such file"));
  EXPECT_THAT(fault(folder.path("")), HasSubstr("is not a regular file"));
  EXPECT_THAT(fault(folder.write("a.acf", "")), HasSubstr("a.acf: is empty"));
  EXPECT_THAT(fault(folder.write("a.acf", "ACF")), HasSubstr("is no frame file"));
  EXPECT_THAT(fault(folder.write("a.acf", std::string(500, 'a'))),
              HasSubstr("is no frame file"));
}

TEST(FrameFile, IsWholeOrNotThere)
{
  const TemporaryFolder folder;
  EXPECT_THAT(faultOfRunning<OutputFileException>(
                  [] { saveTrinocularFrame("/dev/full", smallFrame()); }),
              HasSubstr("No space left"));
  EXPECT_THROW(saveTrinocularFrame(folder.path("no/a.acf"), smallFrame()),
               OutputFileException);
  EXPECT_EQ(folder.count(), 0);
}

} // namespace
} // namespace pcl::acmap::test
