#include "files/record_moves.h"
#include "files/record_writer.h"
#include "files/text_number.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/point_cloud_writer.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace pcl {

namespace {

char
pcdTypeOf(std::uint8_t datatype)
{
  switch (datatype) {
  case PCLPointField::INT8:
  case PCLPointField::INT16:
  case PCLPointField::INT32:
  case PCLPointField::INT64:
    return 'I';
  case PCLPointField::FLOAT32:
  case PCLPointField::FLOAT64:
    return 'F';
  case PCLPointField::BOOL:
    return 'B';
  default:
    return 'U';
  }
}

/** \brief Returns true for a name that a header can use for a field; `_` means padding.
 */
bool
isFieldName(const std::string& name)
{
  return !name.empty() && name != "_" &&
         std::all_of(
             name.begin(), name.end(), [](char c) { return c > ' ' && c < 127; });
}

void
requireWritable(const CloudRows& rows)
{
  if (!rows)
    throw acmap::BadArgument("there is no cloud to write");
  const PCLPointCloud2& cloud = rows.layout();
  const std::size_t points = rows.size();
  if (cloud.is_bigendian)
    throw acmap::BadArgument("a big-endian cloud is not written");
  if (cloud.point_step == 0 || rows.bytes() / cloud.point_step < points)
    throw acmap::BadArgument("cloud has " + std::to_string(points) + " points of " +
                             std::to_string(cloud.point_step) + " bytes but " +
                             std::to_string(rows.bytes()) + " bytes of data");
  std::set<std::string> names;
  for (const PCLPointField& field : cloud.fields) {
    const std::size_t bytes = acmap::sizeOfType(field.datatype) * field.count;
    if (bytes == 0 || field.offset + bytes > cloud.point_step)
      throw acmap::BadArgument("field " + field.name + " lies outside the points");
    if (field.name != "_" &&
        (!isFieldName(field.name) || !names.insert(field.name).second))
      throw acmap::BadArgument("a field with the name '" + field.name +
                               "' cannot be written, or stands twice");
  }
  for (const char* name : {"x", "y", "z"})
    if (names.count(name) == 0)
      throw acmap::BadArgument(std::string("cloud has no field ") + name);
}

/** \brief The header lines of the fields, and the moves that copy their bytes. */
struct PcdRecord {
  std::string names = "FIELDS";
  std::string sizes = "SIZE";
  std::string types = "TYPE";
  std::string counts = "COUNT";
  std::vector<acmap::RecordMove> moves;
  std::size_t bytes = 0;

  explicit PcdRecord(const PCLPointCloud2& cloud)
  {
    for (const PCLPointField& field : cloud.fields)
      if (field.name != "_")
        add(field);
  }

  void
  add(const PCLPointField& field)
  {
    const std::size_t size = acmap::sizeOfType(field.datatype);
    names += " " + field.name;
    sizes += " " + std::to_string(size);
    types += std::string(" ") + pcdTypeOf(field.datatype);
    counts += " " + std::to_string(field.count);
    acmap::appendCopy(moves, {field.offset, bytes, size * field.count});
    bytes += size * field.count;
  }
};

std::string
textOfViewpoint(const Eigen::Vector3f& origin, const Eigen::Quaternionf& orientation)
{
  constexpr float unit_slack = 1e-3F;
  if (!origin.allFinite() || !(std::abs(orientation.norm() - 1.0F) <=
                               unit_slack)) // the comparison is false for NaN
    throw acmap::BadArgument("the sensor's pose is none");
  std::string text = "VIEWPOINT";
  for (const float value : {origin.x(),
                            origin.y(),
                            origin.z(),
                            orientation.w(),
                            orientation.x(),
                            orientation.y(),
                            orientation.z()})
    text += " " + acmap::textOf(value);
  return text;
}

} // namespace

void
savePointCloud(const std::string& path,
               const CloudRows& rows,
               const Eigen::Vector3f& origin,
               const Eigen::Quaternionf& orientation)
{
  const std::string ending = acmap::lowerEnding(path);
  if (ending != ".pcd")
    throw OutputFileException(path + ": ending '" + ending +
                              "' is not known for a cloud; pcd is");
  requireWritable(rows);
  const PCLPointCloud2& cloud = rows.layout();
  const PcdRecord record(cloud);
  const std::size_t points = rows.size();
  const std::string header =
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n" + record.names +
      "\n" + record.sizes + "\n" + record.types + "\n" + record.counts + "\nWIDTH " +
      std::to_string(cloud.width) + "\nHEIGHT " + std::to_string(cloud.height) + "\n" +
      textOfViewpoint(origin, orientation) + "\nPOINTS " + std::to_string(points) +
      "\nDATA binary\n";
  acmap::OutputFile file(path);
  file.write(header.data(), header.size());
  const auto fill = [&](std::uint8_t* to, std::size_t first, std::size_t count) {
    acmap::moveRecords(record.moves,
                       rows.data() + first * cloud.point_step,
                       cloud.point_step,
                       to,
                       record.bytes,
                       count);
  };
  acmap::writeRecords(file, points, record.bytes, fill);
  file.commit();
}

} // namespace pcl
