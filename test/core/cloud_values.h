#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/impl/cloud_fields.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief The bytes of one field of all points, point by point.
 * \throws std::runtime_error when the cloud has no such field */
std::vector<std::uint8_t>
bytesOf(const PCLPointCloud2& cloud, const std::string& field);

/** \brief As above, converted to float. */
std::vector<float>
floatsOf(const PCLPointCloud2& cloud, const std::string& field);

/** \brief Names of the fields except padding, in their order. */
std::vector<std::string>
namesOf(const PCLPointCloud2& cloud);

/** \brief Expects the same size, fields and bytes, independent of the memory layout. */
void
expectEqual(const PCLPointCloud2& cloud, const PCLPointCloud2& expected);

/** \brief The bytes of a number as in memory. */
template <typename Value>
std::string
rawBytes(Value value)
{
  return {reinterpret_cast<const char*>(&value), sizeof(value)};
}

/** \brief The value of a field of one point.
 * \throws std::runtime_error when the cloud has no such field */
template <typename Value>
Value
valueOf(const PCLPointCloud2& cloud, const std::string& field, std::size_t point)
{
  const PCLPointField* const found = findField(cloud, field);
  if (!found)
    throw std::runtime_error("there is no field " + field);
  Value value{};
  std::memcpy(
      &value, &cloud.data[point * cloud.point_step + found->offset], sizeof value);
  return value;
}

} // namespace pcl::acmap::test
