#include "clouds/mesh_codecs.h"

#include "files/record_moves.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/cloud_fields.h>

#include <algorithm>
#include <array>

namespace pcl::acmap {

namespace {

void
requireInside(const CloudRows& rows)
{
  const PCLPointCloud2& cloud = rows.layout();
  const std::size_t points = rows.size();
  if (cloud.point_step == 0 ? points > 0 : rows.bytes() / cloud.point_step < points)
    throw acmap::BadArgument("cloud has " + std::to_string(points) + " points of " +
                             std::to_string(cloud.point_step) + " bytes but " +
                             std::to_string(rows.bytes()) + " bytes of data");
  for (const PCLPointField& field : cloud.fields) {
    const std::size_t bytes = sizeOfType(field.datatype) * field.count;
    if (field.offset + bytes > cloud.point_step)
      throw acmap::BadArgument("field " + field.name + " lies outside the points");
  }
}

/** \return the offsets of three float fields, or nothing unless all of them exist */
std::vector<std::size_t>
findFloats(const PCLPointCloud2& cloud, const std::array<const char*, 3>& names)
{
  std::vector<std::size_t> offsets;
  for (const char* name : names) {
    const PCLPointField* const field = findField(cloud, name, PCLPointField::FLOAT32);
    if (!field)
      return {};
    offsets.push_back(field->offset);
  }
  return offsets;
}

// PCL packs a colour as the bytes b g r a.
std::vector<std::size_t>
findColour(const PCLPointCloud2& cloud)
{
  const PCLPointField* const color = findColor(cloud);
  if (!color)
    return {};
  std::vector<std::size_t> offsets = {
      color->offset + 2U, color->offset + 1U, color->offset};
  if (color->name == "rgba")
    offsets.push_back(color->offset + 3U);
  return offsets;
}

bool
isWord(const std::string& name)
{
  return !name.empty() && name != "_" &&
         std::all_of(
             name.begin(), name.end(), [](char c) { return c > ' ' && c < 127; });
}

bool
isStorable(std::uint8_t datatype)
{
  return sizeOfType(datatype) > 0 && datatype != PCLPointField::BOOL &&
         datatype != PCLPointField::INT64 && datatype != PCLPointField::UINT64;
}

} // namespace

MeshColumns
sortColumns(const CloudRows& rows)
{
  requireInside(rows);
  const PCLPointCloud2& cloud = rows.layout();
  MeshColumns columns;
  const auto coordinates = findFloats(cloud, {"x", "y", "z"});
  if (coordinates.empty())
    throw acmap::BadArgument("cloud has no float32 fields x, y and z");
  std::copy(coordinates.begin(), coordinates.end(), columns.coordinates.begin());
  columns.normal = findFloats(cloud, {"normal_x", "normal_y", "normal_z"});
  columns.colour = findColour(cloud);
  std::vector<std::string> taken{"x", "y", "z"};
  if (!columns.normal.empty())
    taken.insert(taken.end(), {"normal_x", "normal_y", "normal_z", "nx", "ny", "nz"});
  if (!columns.colour.empty())
    taken.insert(taken.end(), {"rgb", "rgba", "red", "green", "blue", "alpha"});
  for (const PCLPointField& field : cloud.fields) {
    if (field.count != 1 || !isStorable(field.datatype) || !isWord(field.name) ||
        std::find(taken.begin(), taken.end(), field.name) != taken.end())
      continue;
    taken.push_back(field.name);
    columns.scalars.push_back({field.name, field.datatype, field.offset});
  }
  return columns;
}

} // namespace pcl::acmap
