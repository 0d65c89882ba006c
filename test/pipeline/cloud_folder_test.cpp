#include "messages.h"
#include "rgbd_folders.h"
#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/pipeline/observation_sequence.h>

#include <gmock/gmock.h>

#include <cstring>
#include <filesystem>
#include <sstream>

namespace pcl::acmap::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/** A cloud of one point. */
std::string
plyOf(float x)
{
  return "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
         "property float z\nend_header\n" +
         std::to_string(x) + " 2 3\n";
}

std::string
scanOf(const std::vector<float>& values)
{
  std::string bytes(values.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

std::string
kittiRow(const Eigen::Isometry3d& pose)
{
  std::ostringstream text;
  text.precision(17);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      text << pose.matrix()(row, column) << " ";
  return text.str() + "\n";
}

std::string
matrixOf(const Eigen::Isometry3d& pose)
{
  std::ostringstream text;
  text.precision(17);
  text << pose.matrix() << "\n";
  return text.str();
}

Eigen::Vector3f
firstPoint(const ObservationSequence& sequence, std::size_t i)
{
  return sequence.load(i).file->points()[0];
}

TEST(CloudFolders, OfPlyFilesAreOrderedByTheirNumbers)
{
  const TemporaryFolder folder;
  std::string poses;
  for (int i = 8; i < 12; ++i) {
    folder.write("scan_" + std::to_string(i) + ".PLY", plyOf(static_cast<float>(i)));
    poses += i == 9 ? "-inf -inf -inf -inf -inf -inf -inf -inf -inf -inf -inf -inf\n"
                    : kittiRow(posedAt(i));
  }
  folder.write("._scan_8.ply", "");
  folder.write("README.txt", "");
  folder.write("poses.txt", poses);
  const ObservationSequence sequence(folder.path(""));
  ASSERT_EQ(sequence.size(), 3U) << "one pose was lost";
  EXPECT_THAT(sequence.remarks(), ElementsAre(HasSubstr("1 clouds left out")));
  EXPECT_EQ(firstPoint(sequence, 1).x(), 10);
  EXPECT_TRUE(sequence.pose(1).isApprox(posedAt(10), 1e-12));
  EXPECT_TRUE(sequence.load(2).T_map_camera.isApprox(posedAt(11), 1e-12));
  folder.write("trajectory.txt",
               poseRow(0, posedAt(0)) + poseRow(1, posedAt(1)) +
                   poseRow(2, posedAt(2)) + poseRow(3, posedAt(3)));
  const ObservationSequence given(folder.path(""));
  EXPECT_EQ(given.size(), 4U);
  EXPECT_TRUE(given.pose(3).isApprox(posedAt(3), 1e-6)) << "trajectory.txt wins";
  EXPECT_THAT(given.remarks(), ElementsAre(HasSubstr("poses.txt")));
}

TEST(CloudFolders, AreNoResultsOfAcmap)
{
  const TemporaryFolder folder;
  folder.write("mesh.ply", plyOf(1));
  folder.write("map.json", "{}");
  EXPECT_THAT(messageOf<InputFileException>(
                  [&] { ObservationSequence(folder.path("")); }, "no fault"),
              HasSubstr("holds no .pcd file"));
}

TEST(CloudFolders, TakePosesByNumberWhereSomeCloudsAreMissing)
{
  const TemporaryFolder folder;
  folder.write("000001.ply", plyOf(1));
  folder.write("000003.ply", plyOf(3));
  std::string poses;
  for (int i = 0; i < 5; ++i)
    poses += kittiRow(posedAt(i));
  folder.write("poses.txt", poses);
  const ObservationSequence sequence(folder.path(""));
  EXPECT_TRUE(sequence.pose(1).isApprox(posedAt(3), 1e-12));
  EXPECT_EQ(sequence.stamp(1), 3);
  folder.write("last.ply", plyOf(9));
  EXPECT_THAT(messageOf<InputFileException>(
                  [&] { ObservationSequence(folder.path("")); }, "no fault"),
              HasSubstr("has 5 poses for 3 clouds"));
}

/** As scanning applications write them: a matrix in a file for each cloud. */
TEST(CloudFolders, TakeThePoseBesideEachCloud)
{
  for (const char* ending : {".txt", ".pose.txt", "_pose.txt", ".pose"}) {
    const TemporaryFolder folder;
    for (const int i : {1, 2, 3}) {
      folder.write(std::to_string(i) + ".ply", plyOf(i));
      folder.write(std::to_string(i) + ending, matrixOf(posedAt(i)));
    }
    EXPECT_TRUE(
        ObservationSequence(folder.path("")).pose(1).isApprox(posedAt(2), 1e-12))
        << ending;
    std::filesystem::remove(folder.path(std::string("2") + ending));
    const ObservationSequence fewer(folder.path(""));
    ASSERT_EQ(fewer.size(), 2U);
    EXPECT_TRUE(fewer.pose(1).isApprox(posedAt(3), 1e-12));
    EXPECT_THAT(fewer.remarks(), Contains(HasSubstr("1 clouds left out")));
    folder.write(std::string("1") + ending, "scanned in the cellar\n");
    EXPECT_THAT(ObservationSequence(folder.path("")).remarks(),
                Contains(HasSubstr("took no poses of the files beside the clouds")));
  }
}

TEST(CloudFolders, OfKittiAreTurnedToTheAxesOfACamera)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("velodyne"));
  folder.write("velodyne/000000.bin", scanOf({5, 1, 2, 0.5F}));
  folder.write("velodyne/000001.bin", scanOf({5, 1, 2, 0.5F, 6, 1, 2, 0.5F}));
  folder.write("poses.txt", kittiRow(posedAt(0)) + kittiRow(posedAt(1)));
  folder.write("calib.txt",
               "P0: 1 0 0 0 0 1 0 0 0 0 1 0\n"
               "Tr: 0 -1 0 0.1 0 0 -1 0.2 1 0 0 0.3\n");
  folder.write("times.txt", "0.0e+00\n1.5e-01\n");
  const ObservationSequence sequence(folder.path(""));
  ASSERT_EQ(sequence.size(), 2U);
  EXPECT_THAT(sequence.remarks(), IsEmpty());
  EXPECT_EQ(sequence.stamp(1), 0.15);
  EXPECT_EQ(firstPoint(sequence, 1), Eigen::Vector3f(-1, -2, 5));
  const Eigen::Vector3d in_camera =
      Eigen::Vector3d(-1, -2, 5) + Eigen::Vector3d(0.1, 0.2, 0.3);
  EXPECT_TRUE((sequence.pose(1) * Eigen::Vector3d(-1, -2, 5))
                  .isApprox(posedAt(1) * in_camera, 1e-9));
  const ObservationSequence inner(folder.path("velodyne"));
  EXPECT_TRUE(inner.pose(1).isApprox(sequence.pose(1), 1e-12));
  folder.write("velodyne/000001.bin", "12345");
  EXPECT_THROW(ObservationSequence(folder.path("")).load(1), InputFileException);
  std::filesystem::remove(folder.path("calib.txt"));
  EXPECT_THAT(ObservationSequence(folder.path("")).remarks(),
              Contains(HasSubstr("no calib.txt")));
}

} // namespace
} // namespace pcl::acmap::test
