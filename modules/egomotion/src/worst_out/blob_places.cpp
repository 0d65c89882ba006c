#include "worst_out/blob_places.h"

#include <pcl/exceptions.h>

#include <array>
#include <cstring>
#include <string>

namespace pcl::acmap {

namespace {

/** Offset of a coordinate within a point. */
std::size_t
offsetOf(const PCLPointCloud2& cloud, const std::string& name)
{
  for (const PCLPointField& field : cloud.fields) {
    if (field.name != name)
      continue;
    // A count of 0 means 1, as in old files.
    if (field.datatype != PCLPointField::FLOAT32 || field.count > 1)
      throw BadArgumentException("the field " + name +
                                 " is refused: it must be one 32 bit float");
    if (field.offset + sizeof(float) > cloud.point_step)
      throw BadArgumentException("the field " + name +
                                 " is refused: it must lie inside of a point");
    return field.offset;
  }
  throw BadArgumentException("a cloud has no field " + name);
}

void
requireData(const PCLPointCloud2& cloud)
{
  const std::size_t row = static_cast<std::size_t>(cloud.width) * cloud.point_step;
  if (cloud.height > 0 && cloud.row_step < row)
    throw BadArgumentException("the row step " + std::to_string(cloud.row_step) +
                               " is refused: it must hold a row, " +
                               std::to_string(row) + " bytes");
  const std::size_t needed = static_cast<std::size_t>(cloud.height) * cloud.row_step;
  if (cloud.data.size() < needed)
    throw BadArgumentException("a cloud of " + std::to_string(cloud.data.size()) +
                               " bytes is refused: it must have " +
                               std::to_string(needed));
}

} // namespace

std::vector<Eigen::Vector3f>
placesOf(const PCLPointCloud2::ConstPtr& cloud)
{
  if (!cloud)
    throw BadArgumentException("a cloud is missing");
  const std::array<std::size_t, 3> offsets{
      offsetOf(*cloud, "x"), offsetOf(*cloud, "y"), offsetOf(*cloud, "z")};
  requireData(*cloud);
  std::vector<Eigen::Vector3f> places;
  places.reserve(static_cast<std::size_t>(cloud->width) * cloud->height);
  for (std::size_t row = 0; row < cloud->height; ++row)
    for (std::size_t column = 0; column < cloud->width; ++column) {
      const std::uint8_t* const point =
          cloud->data.data() + row * cloud->row_step + column * cloud->point_step;
      Eigen::Vector3f place;
      for (int axis = 0; axis < 3; ++axis)
        std::memcpy(&place[axis], point + offsets[axis], sizeof(float));
      places.push_back(place);
    }
  return places;
}

} // namespace pcl::acmap
