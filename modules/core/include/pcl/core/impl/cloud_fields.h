#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/cloud_rows.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/impl/voxel_moments.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/core/sensor_view.h>
#include <pcl/types.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief Returns the field with the given name, or nullptr if there is none. */
ACMAP_EXPORT const PCLPointField*
findField(const PCLPointCloud2& cloud, const std::string& name);

/** \brief Returns the field with the given name if it has a single value of the given
 * type, or nullptr. */
ACMAP_EXPORT const PCLPointField*
findField(const PCLPointCloud2& cloud, const std::string& name, std::uint8_t datatype);

/** \brief Returns the packed colour field `rgb` or `rgba`: a single value of four
 * bytes, the first three of which are blue, green, red. Returns nullptr if there is
 * none. */
ACMAP_EXPORT const PCLPointField*
findColor(const PCLPointCloud2& cloud);

/** \brief The fields of a normal. */
inline constexpr std::array<const char*, 3> normal_field_names = {
    "normal_x", "normal_y", "normal_z"};

/** \brief Name and type of a requested field with a single value. */
struct FieldWish {
  std::string name;
  std::uint8_t datatype;
};

/** \brief Returns a cloud without points that has the fields of \a cloud, followed by
 * the requested fields that it lacks. If the first field of a requested name has
 * another type or several values, the requested field replaces all fields of that name.
 */
ACMAP_EXPORT PCLPointCloud2
layoutWith(const PCLPointCloud2& cloud, const std::vector<FieldWish>& wishes);

/** \brief Returns the cloud in that layout; the values of new fields are zero. */
ACMAP_EXPORT PCLPointCloud2
withFields(PCLPointCloud2 cloud, const std::vector<FieldWish>& wishes);

/** \brief Returns rows in that layout, in a file while a ScratchMemory exists.
 * \param[in] write (row, number) sets the requested fields of a row, which has the
 * values of \a cloud, and zeros in new fields */
template <typename Write>
CloudRows
rowsWith(const CloudRows& cloud, const std::vector<FieldWish>& wishes, Write&& write)
{
  PCLPointCloud2 layout = layoutWith(cloud.layout(), wishes);
  layout.width = cloud.layout().width;
  layout.height = cloud.layout().height;
  const std::size_t step = layout.point_step, from = cloud.layout().point_step;
  LargeVector<std::uint8_t> rows(cloud.size() * step);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    std::memcpy(&rows[i * step], cloud.data() + i * from, from);
    write(&rows[i * step], i);
  }
  return {std::move(layout), std::move(rows)};
}

/** \brief Removes the fields that a PCD cannot store: those whose name is not a word of
 * ASCII characters or is already used by an earlier field. */
ACMAP_EXPORT void
dropUnwritableFields(PCLPointCloud2& cloud);

/** \brief Sets the number of points of an unorganized cloud. */
ACMAP_EXPORT void
resizeRows(PCLPointCloud2& cloud, std::size_t rows);

/** \brief View of the coordinates of a cloud, valid as long as the cloud is unchanged.
 * \param[in] indices of rows, nullptr for all of them
 * \throws InitFailedException if there is no cloud, if it has no float32 fields x, y, z
 * side by side, other bytes than it states or in another order than those of this machine,
 * or if an index is outside of it */
ACMAP_EXPORT PointView
requirePoints(const CloudRows& cloud, const Indices* indices = nullptr);

/** \brief View of the normals of a cloud, valid as long as the cloud is unchanged; empty if
 * it has no float32 fields normal_x, normal_y, normal_z side by side. */
ACMAP_EXPORT PointView
normalsOf(const CloudRows& cloud);

/** \brief Returns the sensor positions of the points of a cloud, valid as long as the
 * cloud is unchanged: the viewpoint given by their int32 field `view`, or, if there is
 * no such field, the same position for all points; unknown if there is none.
 * \param[in] origin the position for clouds without a field `view`
 * \param[in] indices of rows, nullptr for all of them */
ACMAP_EXPORT SensorView
sensorsOf(const CloudRows& cloud,
          const std::vector<Eigen::Vector3f>& viewpoints,
          const std::optional<Eigen::Vector3f>& origin,
          const Indices* indices = nullptr);

/** \brief Returns the colours of a cloud, valid as long as it is unchanged; empty if it
 * has none. */
ACMAP_EXPORT ColorView
colorsOf(const CloudRows& cloud);

inline std::size_t
rowsOf(const PCLPointCloud2& cloud)
{
  return std::size_t{cloud.width} * cloud.height;
}

/** \brief Sets a value of a point.
 * \param[in] offset offset of its field */
template <typename Value>
void
setValue(PCLPointCloud2& cloud, std::size_t row, std::size_t offset, const Value& value)
{
  std::memcpy(&cloud.data[row * cloud.point_step + offset], &value, sizeof value);
}

} // namespace pcl::acmap
