
#include <pcl/conversions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

namespace pcl::acmap {
namespace {

PCLPointCloud2
makeCloud()
{
  PointCloud<PointXYZL> cloud;
  for (std::uint32_t i = 0; i < 6; ++i) {
    cloud.push_back(PointXYZL());
    cloud.back().x = static_cast<float>(i);
    cloud.back().label = 10 + i;
  }
  cloud.width = 3;
  cloud.height = 2;
  PCLPointCloud2 bytes;
  toPCLPointCloud2(cloud, bytes);
  return bytes;
}

TEST(CloudFields, FieldsAreFoundByNameAndType)
{
  const PCLPointCloud2 cloud = makeCloud();
  EXPECT_NE(findField(cloud, "x"), nullptr);
  EXPECT_EQ(findField(cloud, "view"), nullptr);
  EXPECT_NE(findField(cloud, "label", PCLPointField::UINT32), nullptr);
  EXPECT_EQ(findField(cloud, "label", PCLPointField::INT32), nullptr);
  EXPECT_EQ(findColor(cloud), nullptr);
  EXPECT_EQ(rowsOf(cloud), 6u);
}

TEST(CloudFields, NewOnesStandBehindAndTheValuesStay)
{
  PCLPointCloud2 cloud = withFields(makeCloud(), {{"view", PCLPointField::INT32}});
  setValue(cloud, 5, findField(cloud, "view")->offset, std::int32_t{-7});
  EXPECT_EQ(cloud.width, 3u);
  EXPECT_EQ(cloud.height, 2u);
  PointCloud<PointXYZL> back;
  fromPCLPointCloud2(cloud, back);
  ASSERT_EQ(back.size(), 6u);
  for (std::uint32_t i = 0; i < 6; ++i) {
    EXPECT_EQ(back[i].x, static_cast<float>(i));
    EXPECT_EQ(back[i].label, 10 + i);
  }
  std::int32_t value = 0;
  std::memcpy(&value,
              &cloud.data[5 * cloud.point_step + findField(cloud, "view")->offset],
              sizeof value);
  EXPECT_EQ(value, -7);
}

TEST(CloudFields, WhatIsThereStays)
{
  const PCLPointCloud2 cloud = makeCloud();
  const PCLPointCloud2 same = withFields(cloud, {{"label", PCLPointField::UINT32}});
  EXPECT_EQ(same.fields.size(), cloud.fields.size());
  EXPECT_EQ(same.data, cloud.data);
}

TEST(CloudFields, AnotherTypeIsReplaced)
{
  const PCLPointCloud2 cloud =
      withFields(makeCloud(), {{"label", PCLPointField::UINT8}});
  EXPECT_EQ(cloud.fields.size(), makeCloud().fields.size());
  EXPECT_NE(findField(cloud, "label", PCLPointField::UINT8), nullptr);
}

/** \brief Adds a field with this name that refers to existing bytes. */
void
addField(PCLPointCloud2& cloud, const std::string& name, std::uint8_t datatype)
{
  PCLPointField field = cloud.fields.back();
  field.name = name;
  field.datatype = datatype;
  field.count = 1;
  cloud.fields.push_back(field);
}

TEST(CloudFields, DoubledNamesAreReplacedTogether)
{
  PCLPointCloud2 cloud = makeCloud();
  cloud.fields.back().datatype = PCLPointField::INT8;
  addField(cloud, "label", PCLPointField::UINT8);
  const PCLPointCloud2 wide = withFields(cloud, {{"label", PCLPointField::UINT32}});
  const PCLPointField* label = findField(wide, "label");
  ASSERT_NE(label, nullptr);
  EXPECT_EQ(label->datatype, PCLPointField::UINT32);
  EXPECT_EQ(label->offset + 4, wide.point_step);
  EXPECT_EQ(wide.fields.size(), makeCloud().fields.size());
}

TEST(CloudFields, ColourIsOneValueOfFourBytes)
{
  PCLPointCloud2 cloud = makeCloud();
  addField(cloud, "rgb", PCLPointField::UINT8);
  EXPECT_EQ(findColor(cloud), nullptr);
  addField(cloud, "rgba", PCLPointField::UINT32);
  ASSERT_NE(findColor(cloud), nullptr);
  EXPECT_EQ(findColor(cloud)->name, "rgba");
  cloud.fields.back().count = 3;
  EXPECT_EQ(findColor(cloud), nullptr);
  cloud = makeCloud();
  addField(cloud, "rgb", PCLPointField::FLOAT32);
  EXPECT_EQ(findColor(cloud), &cloud.fields.back());
}

TEST(CloudFields, WhatNoPcdHoldsIsDropped)
{
  PCLPointCloud2 cloud = makeCloud();
  PCLPointField odd = cloud.fields.back();
  const std::size_t size = cloud.fields.size();
  for (const char* name : {"label",
                           "two words",
                           "",
                           "gr\xc3\xb6\xc3\x9f"
                           "e"}) {
    odd.name = name;
    cloud.fields.push_back(odd);
  }
  dropUnwritableFields(cloud);
  EXPECT_EQ(cloud.fields.size(), size);
}

} // namespace
} // namespace pcl::acmap
