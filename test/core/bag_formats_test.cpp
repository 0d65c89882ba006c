#include "messages.h"
#include "ros1_bag.h"
#include "sqlite_bag.h"
#include "temporary_folder.h"
#include "test_data.h"

#include <pcl/core/bag_file.h>
#include <pcl/core/ros_messages.h>

#include <gmock/gmock.h>

#include <cstring>
#include <filesystem>

namespace pcl::acmap::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string
faultOf(const std::string& path)
{
  return messageOf<InputFileException>([&] { BagFile{path}; });
}

/** A bag of ROS 1 of texts, in two chunks. */
std::string
ros1Texts(const std::string& packing)
{
  Ros1Writer bag(packing);
  bag.add("/a", "std_msgs/String", 1.5, "first");
  bag.add("/b", "std_msgs/String", 1.75, std::string(100000, 'b'));
  bag.endChunk();
  bag.add("/a", "std_msgs/String", 2, "third");
  return bag.finish();
}

void
expectTexts(const BagFile& bag, const std::string& type, const std::string& encoding)
{
  ASSERT_EQ(bag.channels().size(), 2U);
  EXPECT_EQ(bag.channels()[0].topic, "/a");
  EXPECT_EQ(bag.channels()[0].type, type);
  EXPECT_EQ(bag.channels()[0].encoding, encoding);
  EXPECT_EQ(bag.channels()[0].messages, 2U);
  ASSERT_EQ(bag.messages().size(), 3U);
  EXPECT_EQ(bag.messages()[1].channel, 1U);
  EXPECT_EQ(bag.messages()[1].time, 1.75);
  EXPECT_EQ(bag.load(bag.messages()[2]), "third");
  EXPECT_EQ(bag.load(bag.messages()[0]), "first");
  EXPECT_EQ(bag.load(bag.messages()[1]), std::string(100000, 'b'));
}

TEST(Ros1Bag, MessagesOfAllPackings)
{
  const TemporaryFolder folder;
  for (const char* packing : {"none", "bz2", "lz4"})
    expectTexts(BagFile(folder.write("texts.bag", ros1Texts(packing))),
                "std_msgs/String",
                "ros1");
}

TEST(Ros1Bag, UglyBagsAreRefusedWithTheirFault)
{
  const TemporaryFolder folder;
  const auto fault = [&](const std::string& bytes) {
    return faultOf(folder.write("ugly.bag", bytes));
  };
  Ros1Writer open;
  open.add("/a", "std_msgs/String", 1, "text");
  EXPECT_THAT(fault(open.finish(false)),
              AllOf(HasSubstr("has no index"), HasSubstr("run rosbag reindex")));
  const std::string whole = ros1Texts("bz2");
  EXPECT_THAT(fault(whole.substr(0, whole.size() / 2)), HasSubstr("rosbag reindex"));
  for (std::size_t length = 14; length < whole.size(); length += 97)
    EXPECT_FALSE(fault(whole.substr(0, length)).empty()) << length;
  EXPECT_THAT(fault("#ROSBAG V1.2\n" + whole.substr(13)), HasSubstr("rosbag filter"));
  EXPECT_THAT(fault("no bag at all"), HasSubstr("is no bag: neither MCAP"));
  std::string changed = whole;
  const std::size_t packed = changed.find("BZh9");
  changed[packed + 30] = static_cast<char>(~changed[packed + 30]);
  EXPECT_THAT(fault(changed), HasSubstr("bz2: is damaged"));
  changed = ros1Texts("none");
  changed.replace(changed.find("compression=none"), 16, "compression=rar4");
  EXPECT_THAT(fault(changed), HasSubstr("packed with 'rar4'"));
  changed = ros1Texts("none");
  changed.replace(changed.find("conn="), 9, std::string("conn=\x9\0\0\0", 9));
  EXPECT_THAT(fault(changed), HasSubstr("which is not defined before"));
  // a field without '=', and a chunk that claims too much
  changed = ros1Texts("bz2");
  changed[changed.find("compression=bz2") + 11] = '-';
  EXPECT_THAT(fault(changed), HasSubstr("has a field without '='"));
  changed = ros1Texts("bz2");
  changed.replace(changed.find("size="), 9, "size=\xff\xff\xff\xff");
  EXPECT_THAT(fault(changed), HasSubstr("claims 4294967295 bytes"));
}

TEST(Ros1Bag, MessagesAreReadWithoutAlignment)
{
  const auto ros1 = RosSerialization::Ros1;
  Eigen::Isometry3d pose(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY()));
  pose.translation() << 1, 2, 3;
  const RosImage image = readRosImage(
      imageMessage<Ros1Bytes>(7.25, "camera", 1, 2, "16UC1", "\xe8\3\1\1"), "m", ros1);
  EXPECT_EQ(image.header.stamp, 7.25);
  EXPECT_EQ(image.header.frame, "camera");
  EXPECT_THAT(depthsOf(image, "m").metres, ElementsAre(1.0F, 0.257F));
  const RosTransform odometry =
      readRosOdometry(odometryMessage<Ros1Bytes>(1, "odom", "base", pose), "m", ros1);
  EXPECT_EQ(odometry.child, "base");
  EXPECT_TRUE(odometry.T_parent_child.isApprox(pose));
  const auto transforms =
      readRosTransforms(transformMessage<Ros1Bytes>(1, "map", "odom", pose), "m", ros1);
  ASSERT_EQ(transforms.size(), 1U);
  EXPECT_TRUE(transforms[0].T_parent_child.isApprox(pose));
  Eigen::Matrix3d matrix;
  matrix << 10, 0, 3.5, 0, 20, 2.5, 0, 0, 1;
  const RosCameraInfo camera = readRosCameraInfo(
      cameraMessage<Ros1Bytes>(1, "camera", 8, 6, matrix, 0.1), "m", ros1);
  EXPECT_EQ(camera.pinhole.fy, 20);
  EXPECT_TRUE(camera.is_distorted);
  const float point[4] = {1, 2, 3, 0};
  const RosCloud cloud = readRosCloud(
      cloudMessage<Ros1Bytes>(
          1, "lidar", 1, 1, {reinterpret_cast<const char*>(point), sizeof point}),
      "m",
      ros1);
  EXPECT_EQ(cloud.cloud.width, 1U);
  EXPECT_EQ(cloud.header.frame, "lidar");
}

template <typename Bytes>
void
expectScan(RosSerialization serialization)
{
  const RosScan scan = readRosScan(
      scanMessage<Bytes>(2.5, "laser", -1.5F, 0.5F, {1, 2, 3}), "m", serialization);
  EXPECT_EQ(scan.header.stamp, 2.5);
  EXPECT_EQ(scan.header.frame, "laser");
  EXPECT_EQ(scan.first_angle, -1.5);
  EXPECT_EQ(scan.angle_step, 0.5);
  EXPECT_EQ(scan.max_range, 30);
  EXPECT_THAT(scan.ranges, ElementsAre(1, 2, 3));
}

TEST(RosMessages, LaserScansOfBothSerializations)
{
  expectScan<CdrBytes>(RosSerialization::Cdr);
  expectScan<Ros1Bytes>(RosSerialization::Ros1);
  const std::string endless = scanMessage(2, "l", NAN, 1, {1});
  EXPECT_THAT(messageOf<InputFileException>([&] { readRosScan(endless, "m"); }),
              HasSubstr("not finite"));
}

TEST(RosMessages, BigEndianDepthsAreRead)
{
  RosImage image;
  image.is_big_endian = true;
  image.width = 2;
  image.height = 1;
  image.row_bytes = 4;
  image.encoding = "16UC1";
  image.data = std::string("\3\xe8\0\0", 4);
  EXPECT_THAT(depthsOf(image, "m").metres, ElementsAre(1.0F, 0.0F));
  image.encoding = "32FC1";
  image.width = 1;
  image.data = std::string("\x3f\xc0\0\0", 4);
  EXPECT_THAT(depthsOf(image, "m").metres, ElementsAre(1.5F));
}

/** A bag of SQLite of texts. */
std::string
sqliteTexts(const TemporaryFolder& folder, const std::string& name)
{
  const std::string path = folder.path(name);
  SqliteWriter bag(path);
  bag.add("/a", "std_msgs/msg/String", 1.5, "first");
  bag.add("/b", "std_msgs/msg/String", 1.75, std::string(100000, 'b'));
  bag.add("/a", "std_msgs/msg/String", 2, "third");
  return path;
}

TEST(SqliteBag, MessagesAreRead)
{
  const TemporaryFolder folder;
  expectTexts(
      BagFile(sqliteTexts(folder, "odd name?#%.db3")), "std_msgs/msg/String", "cdr");
}

TEST(SqliteBag, PackedMessagesAreUnpacked)
{
  const TemporaryFolder folder;
  const std::string text(5000, 'x');
  std::string packed(ZSTD_compressBound(text.size()), '\0');
  packed.resize(
      ZSTD_compress(packed.data(), packed.size(), text.data(), text.size(), 1));
  {
    SqliteWriter bag(folder.path("packed.db3"));
    bag.add("/a", "std_msgs/msg/String", 1, packed);
    bag.add("/a", "std_msgs/msg/String", 1, packed.substr(0, packed.size() / 2));
  }
  const BagFile bag(folder.path("packed.db3"));
  EXPECT_EQ(bag.load(bag.messages()[0]), text);
  EXPECT_THAT(messageOf<InputFileException>([&] { (void)bag.load(bag.messages()[1]); }),
              HasSubstr("has a message that"));
}

TEST(SqliteBag, UglyBagsAreRefusedWithTheirFault)
{
  const TemporaryFolder folder;
  const std::string path = sqliteTexts(folder, "texts.db3");
  const std::string whole = contentOf(path);
  for (std::size_t length = 20; length < whole.size(); length += 4001) {
    const std::string fault =
        faultOf(folder.write("short.db3", whole.substr(0, length)));
    EXPECT_THAT(fault, HasSubstr("damaged")) << length;
  }
  SqliteWriter other(folder.path("other.db3"));
  other.run(
      "DROP TABLE messages; CREATE VIEW messages AS WITH RECURSIVE n(i) AS (SELECT "
      "1 UNION ALL SELECT i + 1 FROM n) SELECT i AS id, 1 AS topic_id, i AS "
      "timestamp, x'00' AS data FROM n");
  EXPECT_THAT(faultOf(folder.path("other.db3")), HasSubstr("no tables topics and"));
  SqliteWriter unknown(folder.path("unknown.db3"));
  unknown.run("INSERT INTO messages(topic_id, timestamp, data) VALUES(3, 1, x'00')");
  EXPECT_THAT(faultOf(folder.path("unknown.db3")), HasSubstr("a message of topic 3"));
  SqliteWriter text(folder.path("text.db3"));
  text.add("/a", "t", 1, "");
  text.run("INSERT INTO messages(topic_id, timestamp, data) VALUES(1, 1, 'text')");
  EXPECT_THAT(faultOf(folder.path("text.db3")), HasSubstr("its messages are none"));
}

/** A metadata.yaml of rosbag2. */
void
writeMetadata(const TemporaryFolder& folder, const std::string& files)
{
  folder.write("metadata.yaml",
               "rosbag2_bagfile_information:\n  version: 5\n  relative_file_paths:\n" +
                   files);
}

TEST(BagFolder, PartsAreReadInTheirOrder)
{
  const TemporaryFolder folder;
  for (int part = 0; part < 3; ++part) {
    SqliteWriter bag(folder.path("run_" + std::to_string(part) + ".db3"));
    bag.add("/t" + std::to_string(part), "t", part, "own");
    bag.add("/same", "t", part, std::to_string(part));
  }
  writeMetadata(folder, "    - run/run_1.db3\n    - run_0.db3\n    - run_2.db3\n");
  EXPECT_TRUE(BagFile::isBag(folder.path("")));
  const BagFile bag(folder.path(""));
  ASSERT_EQ(bag.messages().size(), 6U);
  EXPECT_EQ(bag.channels().size(), 4U);
  EXPECT_EQ(bag.load(bag.messages()[1]) + bag.load(bag.messages()[3]) +
                bag.load(bag.messages()[5]),
            "102");
  EXPECT_EQ(bag.messages()[1].channel, bag.messages()[3].channel);
  EXPECT_THAT(bag.remarks(), IsEmpty());
  EXPECT_THAT(BagFile(folder.path("run_0.db3")).remarks(),
              ElementsAre(AllOf(HasSubstr("is part 2 of 3"),
                                HasSubstr("run_1.db3, run_2.db3"))));
  std::filesystem::remove(folder.path("run_2.db3"));
  EXPECT_THAT(faultOf(folder.path("")), HasSubstr("run_2.db3: is missing"));
}

TEST(BagFolder, NumbersOrderPartsWithoutMetadata)
{
  const TemporaryFolder folder;
  for (int part = 0; part < 11; ++part) {
    Ros1Writer bag;
    bag.add("/a", "t", part, std::to_string(part));
    folder.write("walk_2020-01-01-10-" + std::to_string(10 + part) + "-00_" +
                     std::to_string(part) + ".bag",
                 bag.finish());
  }
  const BagFile bag(folder.path(""));
  ASSERT_EQ(bag.messages().size(), 11U);
  EXPECT_EQ(bag.load(bag.messages()[10]), "10");
  EXPECT_THAT(bag.remarks(), Contains(HasSubstr("has no metadata.yaml")));
  EXPECT_THAT(BagFile(bag.files()[3]).remarks(), Contains(HasSubstr("part 4 of 11")));
  folder.write("other.bag", Ros1Writer().finish());
  EXPECT_THAT(faultOf(folder.path("")), HasSubstr("has 12 bags and no metadata.yaml"));
}

TEST(BagFolder, FilesThatArePackedAsAWholeAreNamedWithTheirCommand)
{
  const TemporaryFolder folder;
  const std::string packed = folder.write("run_0.db3.zstd", "\x28\xb5\x2f\xfd");
  EXPECT_TRUE(BagFile::isBag(packed));
  EXPECT_THAT(faultOf(packed), HasSubstr("run zstd -d " + packed));
  writeMetadata(folder, "    - run_0.db3.zstd\n");
  EXPECT_THAT(faultOf(folder.path("")), HasSubstr("run zstd -d "));
  sqliteTexts(folder, "run_0.db3"); // as zstd -d does
  EXPECT_EQ(BagFile(folder.path("")).messages().size(), 3U);
  EXPECT_EQ(BagFile(packed).messages().size(), 3U);
}

TEST(BagFolder, OtherFoldersAreNone)
{
  const TemporaryFolder folder;
  folder.write("metadata.yaml", "name: value\n");
  EXPECT_FALSE(BagFile::isBag(folder.path("")));
  EXPECT_THAT(faultOf(folder.path("")), HasSubstr("has no bag"));
  writeMetadata(folder, "    - ../..\n");
  EXPECT_THAT(faultOf(folder.path("")), HasSubstr("is no name of a file"));
  EXPECT_TRUE(BagFile::isBag(folder.path("none.bag")));
  EXPECT_THAT(faultOf(folder.path("none.bag")), HasSubstr("none.bag"));
}

TEST(BagFolder, ARecordingOfTransformsAlone)
{
  const std::string name = "H_field/recordings/tf_only_db3";
  if (!hasTestData(name + "/metadata.yaml"))
    GTEST_SKIP() << name << " is not in the folder that ACMAP_TEST_DATA names";
  const BagFile bag(testDataPath(name).string());
  EXPECT_EQ(bag.messages().size(), 518U);
  std::size_t transforms = 0;
  for (const BagMessage& message : bag.messages())
    transforms += readRosTransforms(bag.load(message), "tf").size();
  EXPECT_GE(transforms, 518U);
}

} // namespace
} // namespace pcl::acmap::test
