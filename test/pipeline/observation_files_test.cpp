#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/pipeline/observation_files.h>

#include <gmock/gmock.h>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;

TEST(ObservationNames, AreInTheOrderOfTheirNumbers)
{
  EXPECT_THAT(inSequence({"observation_10000.pcd",
                          "map.pcd",
                          "observation_9999.pcd",
                          "observation_x.pcd",
                          "observation_0002.pcd"}),
              ElementsAre("observation_0002.pcd",
                          "observation_9999.pcd",
                          "observation_10000.pcd"));
  EXPECT_THAT(inSequence({"b.pcd", "c.PCD", "a.pcd"}),
              ElementsAre("a.pcd", "b.pcd", "c.PCD"));
}

TEST(ObservationNames, OfAMergedMapAreRefused)
{
  const TemporaryFolder folder;
  folder.write("map.pcd", "");
  EXPECT_THAT(observationNames(folder.path("")), ElementsAre("map.pcd"));
  folder.write("map.json", "");
  EXPECT_THROW(observationNames(folder.path("")), InputFileException);
}

TEST(ObservationNames, OfAFolderAreItsPcds)
{
  const TemporaryFolder folder;
  EXPECT_THROW(observationNames(folder.path("")), InputFileException);
  EXPECT_THROW(observationNames(folder.write("file.pcd", "")), InputFileException);
  folder.write("notes.txt", "");
  EXPECT_THAT(observationNames(folder.path("")), ElementsAre("file.pcd"));
}

TEST(TrajectoryRows, BelongToFilesInTheirOrderWhereThereAreAsMany)
{
  const std::vector<std::string> names = {
      "observation_0000.pcd", "observation_0002.pcd", "observation_0003.pcd"};
  EXPECT_THAT(trajectoryRows("t", names, 3), ElementsAre(0, 1, 2));
  EXPECT_THAT(trajectoryRows("t", names, 5), ElementsAre(0, 2, 3));
  EXPECT_THAT(trajectoryRows("t", {"a.pcd", "b.pcd"}, 5), ElementsAre(0, 1));
  EXPECT_THROW(trajectoryRows("t", names, 2), InputFileException);
  EXPECT_THROW(trajectoryRows("t", {"a.pcd", "b.pcd"}, 1), InputFileException);
}

} // namespace
} // namespace pcl::acmap::test
