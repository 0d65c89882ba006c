#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/export.h>
#include <pcl/core/point_view.h>
#include <pcl/types.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief The field of that name; nullptr without one. */
ACMAP_EXPORT const PCLPointField*
findField(const PCLPointCloud2& cloud, const std::string& name);

/** \brief The same, but of one value of that type. */
ACMAP_EXPORT const PCLPointField*
findField(const PCLPointCloud2& cloud, const std::string& name, std::uint8_t datatype);

/** \brief The packed colour, `rgb` or `rgba`: one value of four bytes, the first of them
 * blue, green, red; nullptr without one. */
ACMAP_EXPORT const PCLPointField*
findColor(const PCLPointCloud2& cloud);

/** \brief The fields of a normal. */
inline constexpr std::array<const char*, 3> normal_field_names = {
    "normal_x", "normal_y", "normal_z"};

/** \brief A field of one value. */
struct FieldWish {
  std::string name;
  std::uint8_t datatype;
};

/** \brief A cloud with no rows, but with the fields of another one and with those wished
 * for, behind; all fields of a wished name go where the first of them is of another type.
 */
ACMAP_EXPORT PCLPointCloud2
layoutWith(const PCLPointCloud2& cloud, const std::vector<FieldWish>& wishes);

/** \brief The cloud in that layout; the values of new fields are zero. */
ACMAP_EXPORT PCLPointCloud2
withFields(PCLPointCloud2 cloud, const std::vector<FieldWish>& wishes);

/** \brief Drops the fields that a PCD cannot hold: a name that is no word of ASCII, or that
 * an earlier field has. */
ACMAP_EXPORT void
dropUnwritableFields(PCLPointCloud2& cloud);

/** \brief Sets the number of rows of an unorganized cloud. */
ACMAP_EXPORT void
resizeRows(PCLPointCloud2& cloud, std::size_t rows);

/** \brief View of the coordinates of a cloud, valid as long as the cloud is unchanged.
 * \param[in] indices of rows, nullptr for all of them
 * \throws InitFailedException if there is no cloud, if it has no float32 fields x, y, z
 * side by side or fewer bytes than it states, or if an index is outside of it */
ACMAP_EXPORT PointView
requirePoints(const PCLPointCloud2ConstPtr& cloud, const Indices* indices = nullptr);

inline std::size_t
rowsOf(const PCLPointCloud2& cloud)
{
  return std::size_t{cloud.width} * cloud.height;
}

/** \brief Sets a value of a row. \param[in] offset of its field */
template <typename Value>
void
setValue(PCLPointCloud2& cloud, std::size_t row, std::size_t offset, const Value& value)
{
  std::memcpy(&cloud.data[row * cloud.point_step + offset], &value, sizeof value);
}

} // namespace pcl::acmap
