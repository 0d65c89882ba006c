#pragma once

#include <pcl/PCLPointCloud2.h>

#include <cstdint>
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

} // namespace pcl::acmap::test
