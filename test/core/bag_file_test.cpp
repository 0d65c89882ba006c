#include "cloud_values.h"
#include "mcap_file.h"
#include "temporary_folder.h"
#include "test_png.h"

#include <pcl/core/bag_file.h>
#include <pcl/core/ros_messages.h>

#include <gmock/gmock.h>

#include <array>
#include <cstring>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

/** A bag of texts, in two chunks. */
std::string
bagOfTexts(const std::string& packing)
{
  McapWriter bag(packing);
  bag.add("/a", "std_msgs/msg/String", 1.5, "first");
  bag.add("/b", "std_msgs/msg/String", 1.75, std::string(100000, 'b'));
  bag.endChunk();
  bag.add("/a", "std_msgs/msg/String", 2, "third");
  return bag.finish();
}

template <typename Error, typename Call>
void
expectThrow(const Call& call, const std::string& fault)
{
  EXPECT_THAT(call, testing::ThrowsMessage<Error>(HasSubstr(fault))) << fault;
}

void
expectFault(const std::string& bytes, const std::string& fault)
{
  const TemporaryFolder folder;
  const std::string path = folder.write("ugly.mcap", bytes);
  expectThrow<InputFileException>([&] { BagFile{path}; }, fault);
}

TEST(BagFile, MessagesOfAllPackings)
{
  const TemporaryFolder folder;
  for (const char* packing : {"", "none", "lz4", "zstd"}) {
    const BagFile bag(folder.write("texts.mcap", bagOfTexts(packing)));
    ASSERT_EQ(bag.channels().size(), 2U) << packing;
    EXPECT_EQ(bag.channels()[0].topic, "/a");
    EXPECT_EQ(bag.channels()[0].type, "std_msgs/msg/String");
    EXPECT_EQ(bag.channels()[0].encoding, "cdr");
    EXPECT_EQ(bag.channels()[0].messages, 2U);
    ASSERT_EQ(bag.messages().size(), 3U);
    EXPECT_EQ(bag.messages()[1].channel, 1U);
    EXPECT_EQ(bag.messages()[1].time, 1.75);
    // in any order
    EXPECT_EQ(bag.load(bag.messages()[2]), "third");
    EXPECT_EQ(bag.load(bag.messages()[0]), "first");
    EXPECT_EQ(bag.load(bag.messages()[1]), std::string(100000, 'b'));
  }
}

TEST(BagFile, UglyBagsAreRefusedWithTheirFault)
{
  const std::string whole = bagOfTexts("zstd");
  expectFault("no bag at all, but long enough", "is no bag: neither MCAP");
  for (const std::size_t length : {whole.size() - 1, whole.size() / 2, std::size_t{12}})
    EXPECT_THROW(
        {
          const TemporaryFolder folder;
          BagFile(folder.write("short.mcap", whole.substr(0, length)));
        },
        InputFileException);
  expectFault(whole.substr(0, 60), "truncated within its record at byte");
  std::string changed = bagOfTexts("none");
  changed[200] = static_cast<char>(~changed[200]);
  expectFault(changed, "checksum is wrong");
  changed = bagOfTexts("");
  changed[changed.find("first")] = 'F';
  expectFault(changed, "checksum of its data is wrong");
  McapWriter bag("none");
  bag.put(McapWriter::record(5, std::string(30, '\0')));
  expectFault(bag.finish(), "a message of channel 0, which is not defined");
  bag = McapWriter("none");
  bag.put(McapWriter::record(4,
                             McapWriter::raw(std::uint16_t{1}) +
                                 McapWriter::raw(std::uint16_t{7}) +
                                 McapWriter::sized("/t") + McapWriter::sized("cdr") +
                                 McapWriter::raw(std::uint32_t{0})));
  expectFault(bag.finish(), "a channel /t of schema 7, which is not defined");
  bag = McapWriter("none");
  bag.put(McapWriter::raw(std::uint8_t{5}) + McapWriter::raw(std::uint64_t{1} << 60));
  expectFault(bag.finish(), "ends early");
}

/** A bag with one chunk as given. */
std::string
bagOfChunk(std::uint64_t bytes, const std::string& packing, const std::string& packed)
{
  return McapWriter::magic() +
         McapWriter::record(1, McapWriter::sized("") + McapWriter::sized("")) +
         McapWriter::record(6,
                            std::string(16, '\0') + McapWriter::raw(bytes) +
                                McapWriter::raw(std::uint32_t{0}) +
                                McapWriter::sized(packing) +
                                McapWriter::longSized(packed)) +
         McapWriter::record(15, std::string(4, '\0')) +
         McapWriter::record(2, std::string(20, '\0')) + McapWriter::magic();
}

TEST(BagFile, ChunksMustHoldWhatTheyClaim)
{
  const std::string text(70000, 'x'), record = McapWriter::record(9, text);
  std::string zstd(ZSTD_compressBound(record.size()), '\0');
  zstd.resize(ZSTD_compress(zstd.data(), zstd.size(), record.data(), record.size(), 1));
  std::string lz4(LZ4F_compressFrameBound(record.size(), nullptr), '\0');
  lz4.resize(LZ4F_compressFrame(
      lz4.data(), lz4.size(), record.data(), record.size(), nullptr));
  for (const auto& [packing, packed] : {std::pair("zstd", zstd), {"lz4", lz4}}) {
    const TemporaryFolder folder;
    EXPECT_NO_THROW(BagFile(
        folder.write("whole.mcap", bagOfChunk(record.size(), packing, packed))));
    expectFault(bagOfChunk(record.size() - 1, packing, packed), "more bytes than");
    expectFault(bagOfChunk(record.size() + 1, packing, packed), "and claims 70010");
    expectFault(bagOfChunk(record.size(), packing, packed.substr(0, packed.size() / 2)),
                "truncated");
    expectFault(bagOfChunk(record.size(), packing, "garbage" + packed), packing);
  }
  expectFault(bagOfChunk(std::uint64_t{1} << 40, "zstd", zstd), "claims 1099511627776");
  expectFault(bagOfChunk(record.size(), "brotli", zstd), "packed with 'brotli'");
  expectFault(bagOfChunk(5, "", "four"), "has 4 bytes, and claims 5");
}

TEST(RosMessages, ImagesBecomeColoursAndMetres)
{
  const std::string pixels("\1\2\3\4\5\6", 6);
  const auto colors = [&](const char* encoding, std::uint32_t width, std::string data) {
    return colorsOf(
               readRosImage(imageMessage(7.25, "cam", width, 1, encoding, data), "m"),
               "m")
        .values;
  };
  using testing::ElementsAre;
  EXPECT_THAT(colors("rgb8", 2, pixels), ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(colors("bgr8", 2, pixels), ElementsAre(3, 2, 1, 6, 5, 4));
  EXPECT_THAT(colors("bgra8", 1, "\1\2\3\4"), ElementsAre(3, 2, 1));
  EXPECT_THAT(colors("mono8", 2, "\1\2"), ElementsAre(1, 1, 1, 2, 2, 2));
  // bright red in Y U Y V and U Y V Y
  EXPECT_THAT(colors("yuv422_yuy2", 2, "\x51\x5a\x51\xf0"),
              ElementsAre(254, 0, 0, 254, 0, 0));
  EXPECT_THAT(colors("yuv422", 2, "\x5a\x51\xf0\x51"),
              ElementsAre(254, 0, 0, 254, 0, 0));
  const RosImage image = readRosImage(
      imageMessage(7.25, "cam", 1, 2, "16UC1", std::string("\xe8\3\0\0", 4)), "m");
  EXPECT_EQ(image.header.frame, "cam");
  EXPECT_EQ(image.header.stamp, 7.25);
  EXPECT_TRUE(image.isDepth());
  EXPECT_THAT(depthsOf(image, "m").metres, ElementsAre(1.0F, 0.0F));
  const float metres[] = {1.5F, std::nanf("")};
  const std::string data(reinterpret_cast<const char*>(metres), sizeof metres);
  EXPECT_THAT(
      depthsOf(readRosImage(imageMessage(0, "cam", 2, 1, "32FC1", data), "m"), "m")
          .metres,
      ElementsAre(1.5F, 0.0F));
}

TEST(RosMessages, BayerPatternsHaveTheColoursOfTheirSquares)
{
  // red 9, green 4 and 6, blue 2, and an odd column
  for (const auto& [encoding, square] : {std::pair("bayer_rggb8", "\x9\4\1\6\2\1"),
                                         {"bayer_bggr8", "\2\4\1\6\x9\1"},
                                         {"bayer_gbrg8", "\4\2\1\x9\6\1"},
                                         {"bayer_grbg8", "\4\x9\1\2\6\1"}}) {
    const RgbImage colors = colorsOf(
        readRosImage(imageMessage(1, "cam", 3, 2, encoding, square), "m"), "m");
    ASSERT_EQ(colors.values.size(), 18U);
    for (std::size_t i = 0; i < 18; ++i)
      EXPECT_EQ(colors.values[i], (std::array<int, 3>{9, 5, 2})[i % 3]) << encoding;
  }
}

TEST(RosMessages, CompressedImages)
{
  const std::string png = depthPngBytes(2, 1, {2000, 0});
  const auto message = [](const std::string& format, const std::string& data) {
    CdrBytes cdr;
    cdr.addHeader(1, "cam").addText(format);
    return cdr.addBytes(data).bytes;
  };
  const auto depths = [&](const std::string& format, const std::string& data) {
    return depthsOf(readRosCompressedImage(message(format, data), "m"), "m").metres;
  };
  EXPECT_THAT(depths("16UC1; compressedDepth png", std::string(12, '\0') + png),
              testing::ElementsAre(2.0F, 0.0F));
  const float a = 4000, b = 0;
  const std::string inverse = std::string(4, '\0') + rawBytes(a) + rawBytes(b);
  EXPECT_THAT(depths("32FC1; compressedDepth png", inverse + png),
              testing::ElementsAre(2.0F, 0.0F));
  const RgbImage color{1, 2, {1, 2, 3, 4, 5, 6}};
  const std::vector<std::uint8_t> encoded = encodePng(color);
  EXPECT_EQ(colorsOf(readRosCompressedImage(
                         message("bgr8; png compressed bgr8",
                                 std::string(encoded.begin(), encoded.end())),
                         "m"),
                     "m")
                .values,
            color.values);
  expectThrow<InputFileException>([&] { depths("16UC1; compressedDepth rvl", png); },
                                  "PNG");
}

TEST(RosMessages, CloudsTransformsAndCameras)
{
  const float values[] = {1, 2, 3, 0, 4, 5, 6, 0};
  const RosCloud cloud = readRosCloud(
      cloudMessage(
          3, "lidar", 2, 1, std::string(reinterpret_cast<const char*>(values), 32)),
      "m");
  EXPECT_EQ(cloud.cloud.width, 2U);
  EXPECT_THAT(namesOf(cloud.cloud), testing::ElementsAre("x", "y", "z", "rgb"));
  EXPECT_EQ(valueOf<float>(cloud.cloud, "y", 1), 5);
  Eigen::Isometry3d pose(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY()));
  pose.translation() << 1, 2, 3;
  const auto transforms =
      readRosTransforms(transformMessage(3.5, "odom", "base", pose), "m");
  ASSERT_EQ(transforms.size(), 1U);
  EXPECT_EQ(transforms[0].header.frame, "odom");
  EXPECT_EQ(transforms[0].child, "base");
  EXPECT_TRUE(transforms[0].T_parent_child.isApprox(pose, 1e-12));
  Eigen::Matrix3d matrix;
  matrix << 500, 0, 320, 0, 501, 240, 0, 0, 1;
  const RosCameraInfo info =
      readRosCameraInfo(cameraMessage(1, "cam", 640, 480, matrix), "m");
  EXPECT_EQ(info.pinhole.fy, 501);
  EXPECT_EQ(info.pinhole.cx, 320);
  EXPECT_FALSE(info.is_distorted);
}

TEST(RosMessages, UglyMessagesAreRefused)
{
  const auto refuse =
      [](const auto& read, const std::string& bytes, const char* fault) {
        expectThrow<InputFileException>(
            [&] { read(bytes, "bag: /topic", RosSerialization::Cdr); }, fault);
      };
  const std::string image = imageMessage(1, "cam", 4, 4, "mono8", std::string(16, 'x'));
  for (std::size_t length = 0; length < image.size(); ++length)
    EXPECT_THROW(readRosImage(image.substr(0, length), "m"), InputFileException);
  refuse(readRosImage, std::string("\0\0", 2) + image.substr(2), "little-endian CDR");
  refuse([](const auto& b, const auto& n, auto) { colorsOf(readRosImage(b, n), n); },
         imageMessage(1, "cam", 1000, 1000, "mono8", std::string(1000, 'x')),
         "bag: /topic: ");
  refuse([](const auto& b, const auto& n, auto) { colorsOf(readRosImage(b, n), n); },
         imageMessage(1, "cam", 2, 1, "hsv8", "xxxx"),
         "'hsv8'");
  refuse(readRosCloud,
         cloudMessage(1, "cam", 1U << 31, 1U << 31, std::string(16, 'x')),
         "");
  refuse(readRosCloud, cloudMessage(1, "cam", 3, 1, std::string(32, 'x')), "3 points");
  CdrBytes transform;
  transform.add(std::uint32_t{1}).addHeader(1, "a").addText("b");
  for (int i = 0; i < 7; ++i)
    transform.add(0.0);
  refuse(readRosTransforms, transform.bytes, "no rigid motion");
  refuse(readRosCameraInfo,
         cameraMessage(1, "cam", 4, 4, Eigen::Matrix3d::Zero()),
         "focal length");
}

} // namespace
} // namespace pcl::acmap::test
