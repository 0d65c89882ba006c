#include "compact_mapping/open_observations.h"
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
    return openObservations(folder_.path(""), {}, skip_broken, {}, {}).start;
  }

  TemporaryFolder folder_;
};

TEST_F(StartingPoints, AFileIsACloud)
{
  EXPECT_EQ(openObservations(folder_.path("none"), {}, false, {}, {}).start,
            StartingPoint::Cloud);
  EXPECT_EQ(openObservations(folder_.write("a.ply", ""), {}, false, {}, {}).start,
            StartingPoint::Cloud);
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

/** The points are read when they are needed. */
TEST_F(StartingPoints, HeadersTellThePoses)
{
  const std::string begun = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n"
                            "WIDTH 9\nHEIGHT 1\nVIEWPOINT 0 0 2 1 0 0 0\nPOINTS 9\n"
                            "DATA binary\n";
  folder_.write("observation_0000.pcd", nowhere);
  folder_.write("observation_0001.pcd", begun);
  EXPECT_EQ(start(), StartingPoint::PosedObservations);
}

TEST_F(StartingPoints, AFolderOfNeitherIsRefused)
{
  EXPECT_THROW(start(), InputFileException);
}

} // namespace
} // namespace pcl::acmap::test
