#include <pcl/conversions.h>
#include <pcl/pipeline/cloud_labels.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

namespace pcl::acmap {
namespace {

PCLPointCloud2
makeCloud(std::size_t size)
{
  PointCloud<PointXYZ> cloud;
  cloud.resize(size);
  PCLPointCloud2 bytes;
  toPCLPointCloud2(cloud, bytes);
  return bytes;
}

TEST(CloudLabels, NumbersAreThoseOfPlanesPlusOne)
{
  PointCloud<PointXYZL> labelled;
  fromPCLPointCloud2(withLabels(makeCloud(3), {4, -1, 0}), labelled);
  EXPECT_EQ(labelled[0].label, 5u);
  EXPECT_EQ(labelled[1].label, 0u);
  EXPECT_EQ(labelled[2].label, 1u);
}

TEST(CloudLabels, ColoursTellPlanesApart)
{
  constexpr std::int32_t planes = 40;
  std::vector<std::int32_t> labels;
  for (std::int32_t plane = -1; plane < planes; ++plane)
    labels.push_back(plane);
  PointCloud<PointXYZRGB> colored;
  fromPCLPointCloud2(coloredByLabel(withLabels(makeCloud(labels.size()), labels)),
                     colored);
  EXPECT_TRUE(colored[0].r == colored[0].g && colored[0].g == colored[0].b);
  for (std::size_t a = 0; a < colored.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_GT((colored[a].getRGBVector3i() - colored[b].getRGBVector3i()).norm(), 10)
          << a << " " << b;
}

/** Writing four bytes at its offset would overwrite neighbours, or exceed the last
 * row. */
TEST(CloudLabels, ANarrowColourIsReplaced)
{
  PCLPointCloud2 cloud = withLabels(makeCloud(2), {0, -1});
  PCLPointField narrow;
  narrow.name = "rgb";
  narrow.datatype = PCLPointField::UINT8;
  narrow.count = 1;
  narrow.offset = cloud.point_step - 1; // the highest byte of the label
  cloud.fields.push_back(narrow);
  const PCLPointCloud2 colored = coloredByLabel(cloud);
  EXPECT_EQ(colored.data.size(), cloud.data.size() + 2 * sizeof(std::uint32_t));
  PointCloud<PointXYZL> labelled;
  fromPCLPointCloud2(colored, labelled);
  EXPECT_EQ(labelled[0].label, 1u);
  EXPECT_EQ(labelled[1].label, 0u);
  PointCloud<PointXYZRGB> colors;
  fromPCLPointCloud2(colored, colors);
  EXPECT_FALSE(colors[0].r == colors[0].g && colors[0].g == colors[0].b);
}

TEST(CloudLabels, WithoutLabelsThereIsNoColour)
{
  EXPECT_THROW(coloredByLabel(makeCloud(1)), BadArgumentException);
}

TEST(CloudLabels, ThereIsOneForEachPoint)
{
  EXPECT_THROW(withLabels(makeCloud(2), {0}), BadArgumentException);
  EXPECT_THROW(withLabels(makeCloud(2), {0, 1, 2}), BadArgumentException);
  EXPECT_EQ(withLabels({}, {}).data.size(), 0U);
}

} // namespace
} // namespace pcl::acmap
