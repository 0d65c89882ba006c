#include "temporary_folder.h"
#include "truth_room.h"

#include <pcl/pipeline/map_sizes.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

TEST(MapSizes, CountPlanesAndCorners)
{
  const TemporaryFolder folder;
  const MapSizes sizes = measureMap(roomMap(), 1000, folder.path(""));
  EXPECT_EQ(sizes.raw, 16000U);
  EXPECT_EQ(sizes.geometry, 4 * (16 + 4 * 12U)) << "four rectangles";
  EXPECT_EQ(sizes.details, 0U);
  EXPECT_EQ(sizes.glb, 0U) << "no file";
  EXPECT_EQ(sizes.ratioTo(sizes.geometry), 62.5);
  EXPECT_EQ(sizes.ratioTo(sizes.glb), 16000) << "not infinite";
}

TEST(MapSizes, AreThoseOfTheFiles)
{
  const TemporaryFolder folder;
  folder.write("map.glb", "12345");
  folder.write("map.json", "123");
  const MapSizes sizes = measureMap({}, 0, folder.path(""));
  EXPECT_EQ(sizes.glb, 5U);
  EXPECT_EQ(sizes.textured(), 5U);
  EXPECT_EQ(sizes.json, 3U);
  EXPECT_EQ(sizes.geometry, 0U);
}

} // namespace
} // namespace pcl::acmap::test
