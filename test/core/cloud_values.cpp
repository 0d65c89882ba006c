#include "cloud_values.h"

#include <pcl/common/io.h>

#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>

namespace pcl::acmap::test {

namespace {

const PCLPointField&
findField(const PCLPointCloud2& cloud, const std::string& name)
{
  for (const PCLPointField& field : cloud.fields)
    if (field.name == name)
      return field;
  throw std::runtime_error("no field " + name);
}

} // namespace

std::vector<std::uint8_t>
bytesOf(const PCLPointCloud2& cloud, const std::string& name)
{
  const PCLPointField& field = findField(cloud, name);
  const std::size_t size = getFieldSize(field.datatype) * field.count;
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < std::size_t{cloud.width} * cloud.height; ++i) {
    const auto first = cloud.data.begin() +
                       static_cast<std::ptrdiff_t>(i * cloud.point_step + field.offset);
    bytes.insert(bytes.end(), first, first + static_cast<std::ptrdiff_t>(size));
  }
  return bytes;
}

std::vector<float>
floatsOf(const PCLPointCloud2& cloud, const std::string& name)
{
  const std::vector<std::uint8_t> bytes = bytesOf(cloud, name);
  std::vector<float> values(bytes.size() / sizeof(float));
  if (!values.empty())
    std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

std::vector<std::string>
namesOf(const PCLPointCloud2& cloud)
{
  std::vector<std::string> names;
  for (const PCLPointField& field : cloud.fields)
    if (field.name != "_")
      names.push_back(field.name);
  return names;
}

void
expectEqual(const PCLPointCloud2& cloud, const PCLPointCloud2& expected)
{
  EXPECT_EQ(cloud.width, expected.width);
  EXPECT_EQ(cloud.height, expected.height);
  ASSERT_EQ(namesOf(cloud), namesOf(expected));
  for (const std::string& name : namesOf(cloud)) {
    // PCL stores a packed colour as float32 in clouds and binary files, but as uint32
    // in ASCII.
    if (name != "rgb") {
      EXPECT_EQ(findField(cloud, name).datatype, findField(expected, name).datatype);
    }
    EXPECT_EQ(bytesOf(cloud, name), bytesOf(expected, name)) << name;
  }
}

} // namespace pcl::acmap::test
