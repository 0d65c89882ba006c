#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/pipeline/map_input.h>

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
    InputStatement stated;
    stated.skip_broken = skip_broken;
    return openMapInput(folder_.path(""), stated).start;
  }

  TemporaryFolder folder_;
};

TEST_F(StartingPoints, AFileIsACloud)
{
  EXPECT_EQ(openMapInput(folder_.path("none")).start, StartingPoint::Cloud);
  EXPECT_EQ(openMapInput(folder_.write("a.ply", "")).start, StartingPoint::Cloud);
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

TEST_F(StartingPoints, ObservationsAreOpenedInMetres)
{
  folder_.write("observation_0000.pcd", nowhere);
  folder_.write("observation_0001.pcd", pcd("0 0 5 1 0 0 0"));
  InputStatement stated;
  stated.reader.setScale(0.001);
  const MapInput input = openMapInput(folder_.path(""), stated);
  ASSERT_TRUE(input.observations);
  ASSERT_EQ(input.observations->size(), 2U);
  EXPECT_FLOAT_EQ(input.observations->load(0).file->points()[0].z(), 0.003F);
  EXPECT_NEAR(input.observations->pose(1).translation().z(), 0.005, 1e-9);
}

} // namespace
} // namespace pcl::acmap::test
