#include "compact_mapping/starting_point.h"
#include "temporary_folder.h"

#include <pcl/core/exceptions.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;

std::string
pcd(const std::string& viewpoint)
{
  return "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\n"
         "HEIGHT 1\nVIEWPOINT " +
         viewpoint + "\nPOINTS 1\nDATA ascii\n1 2 3\n";
}

const std::string nowhere = pcd("0 0 0 1 0 0 0");

class StartingPoints : public testing::Test {
protected:
  StartingPoint
  start(bool skip_broken = false) const
  {
    return startingPointOf(folder_.path(""), skip_broken);
  }

  TemporaryFolder folder_;
};

TEST_F(StartingPoints, AFileIsACloud)
{
  EXPECT_EQ(startingPointOf(folder_.path("none"), false), StartingPoint::Cloud);
  EXPECT_EQ(startingPointOf(folder_.write("a.ply", ""), false), StartingPoint::Cloud);
}

TEST_F(StartingPoints, ASessionIsRaw)
{
  folder_.write("observation_0000.pcd", nowhere);
  folder_.write("session.yaml", "");
  EXPECT_EQ(start(), StartingPoint::Session);
}

TEST_F(StartingPoints, PosesAreToldByTrajectoryOrViewpoints)
{
  folder_.write("observation_0000.pcd", nowhere);
  EXPECT_EQ(start(), StartingPoint::PosedObservations) << "one alone";
  folder_.write("observation_0001.pcd", nowhere);
  EXPECT_EQ(start(), StartingPoint::Observations);
  folder_.write("observation_0002.pcd", pcd("0 0 1 1 0 0 0"));
  EXPECT_EQ(start(), StartingPoint::PosedObservations);
  fs::remove(folder_.path("observation_0002.pcd"));
  folder_.write("trajectory.txt", "0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n");
  EXPECT_EQ(start(), StartingPoint::PosedObservations);
}

TEST_F(StartingPoints, BrokenObservationsHaveNoSay)
{
  folder_.write("observation_0000.pcd", "VERSION");
  for (const char* name : {"observation_0001.pcd", "observation_0002.pcd"})
    folder_.write(name, nowhere);
  EXPECT_THROW(start(), InputFileException);
  EXPECT_EQ(start(true), StartingPoint::Observations);
  folder_.write("observation_0002.pcd", pcd("0 0 1 1 0 0 0"));
  EXPECT_EQ(start(true), StartingPoint::PosedObservations);
}

TEST_F(StartingPoints, AFolderOfNeitherIsRefused)
{
  EXPECT_THROW(start(), InputFileException);
}

} // namespace
} // namespace pcl::acmap::test
