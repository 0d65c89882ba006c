#pragma once

#include <pcl/PCLPointCloud2.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief The bytes of one field over all points, one point after the other.
 * \throws std::runtime_error when the cloud has no such field */
std::vector<std::uint8_t>
bytesOf(const PCLPointCloud2& cloud, const std::string& field);

/** \brief The same as floats. */
std::vector<float>
floatsOf(const PCLPointCloud2& cloud, const std::string& field);

/** \brief Names of the fields but padding, in their order. */
std::vector<std::string>
namesOf(const PCLPointCloud2& cloud);

/** \brief Expects the same shape, fields and bytes, whatever the layout. */
void
expectEqual(const PCLPointCloud2& cloud, const PCLPointCloud2& expected);

/** \brief The bytes of a number, as they stand in memory. */
template <typename Value>
std::string
rawBytes(Value value)
{
  return {reinterpret_cast<const char*>(&value), sizeof(value)};
}

} // namespace pcl::acmap::test
