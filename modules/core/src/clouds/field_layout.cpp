#include "clouds/field_layout.h"

#include "files/byte_source.h"

#include <pcl/core/impl/cloud_fields.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace pcl::acmap {

namespace {

using Fields = std::vector<SourceField>;
using Positions = std::array<std::size_t, 3>;

std::optional<std::size_t>
placeOfField(const Fields& source, const char* name)
{
  const auto found = std::find_if(source.begin(), source.end(), [&](const auto& field) {
    return field.name == name;
  });
  if (found == source.end())
    return std::nullopt;
  return static_cast<std::size_t>(found - source.begin());
}

std::size_t
findCoordinate(const Fields& source, const char* name, const ByteSource& file)
{
  const auto same_name = [&](const auto& field) { return field.name == name; };
  if (std::count_if(source.begin(), source.end(), same_name) != 1)
    file.fail(std::string("has not exactly one field ") + name);
  const std::size_t position = *placeOfField(source, name);
  if (source[position].count != 1)
    file.fail(std::string("field ") + name + " holds more than one number");
  return position;
}

// Sets the offsets; returns the length of a record.
std::size_t
placeFields(Fields& source, const ByteSource& file)
{
  constexpr std::int64_t maximum = std::numeric_limits<std::int32_t>::max();
  std::int64_t end = 0;
  std::size_t needed = 0;
  for (SourceField& field : source) {
    const std::int64_t begin = end;
    end += static_cast<std::int64_t>(sizeOfType(field.datatype)) * field.count;
    if (end < 0 || end > maximum)
      file.fail("header puts a field at byte " + std::to_string(end) + " of a point");
    field.offset = static_cast<std::size_t>(begin);
    if (!field.isPadding())
      needed = std::max(needed, static_cast<std::size_t>(end));
  }
  if (needed > static_cast<std::size_t>(end))
    file.fail("header claims points of " + std::to_string(end) +
              " bytes with fields of " + std::to_string(needed));
  return static_cast<std::size_t>(end);
}

// Indices of the colour fields in the order in which PCL packs them: b g r (a).
std::vector<std::size_t>
findColourBytes(const Fields& source)
{
  std::vector<std::size_t> bytes;
  for (const char* name : {"blue", "green", "red", "alpha"}) {
    const auto position = placeOfField(source, name);
    if (position && source[*position].datatype == PCLPointField::UINT8 &&
        source[*position].count == 1)
      bytes.push_back(*position);
    else if (bytes.size() < 3)
      return {};
  }
  if (placeOfField(source, "rgb") || placeOfField(source, "rgba"))
    return {};
  return bytes;
}

/** Are there colours of three numbers of one type that are no bytes? */
bool
hasWideColors(const Fields& source)
{
  if (placeOfField(source, "rgb") || placeOfField(source, "rgba"))
    return false;
  std::optional<std::uint8_t> datatype;
  for (const char* name : {"red", "green", "blue"}) {
    const auto position = placeOfField(source, name);
    if (!position || source[*position].count != 1 ||
        (datatype && source[*position].datatype != *datatype))
      return false;
    datatype = source[*position].datatype;
  }
  return sizeOfType(*datatype) > 1;
}

void
addField(FieldLayout& layout,
         const std::string& name,
         std::size_t offset,
         std::uint8_t datatype,
         std::int64_t count)
{
  PCLPointField field;
  field.name = name;
  field.offset = static_cast<uindex_t>(offset);
  field.datatype = datatype;
  field.count = static_cast<uindex_t>(count);
  layout.fields.push_back(std::move(field));
}

bool
coordinatesStandTogether(const Fields& source, const Positions& xyz)
{
  return xyz[1] == xyz[0] + 1 && xyz[2] == xyz[1] + 1 &&
         std::all_of(xyz.begin(), xyz.end(), [&](std::size_t position) {
           return source[position].datatype == PCLPointField::FLOAT32;
         });
}

void
keepPlaces(FieldLayout& layout)
{
  layout.same = true;
  layout.point_step = layout.source_step;
  for (const SourceField& field : layout.source) {
    layout.targets.push_back({field.offset, field.datatype});
    if (!field.isPadding())
      addField(layout, field.name, field.offset, field.datatype, field.count);
  }
}

void
packAnew(FieldLayout& layout,
         const Positions& xyz,
         const std::vector<std::size_t>& colour)
{
  const Fields& source = layout.source;
  layout.targets.resize(source.size());
  std::vector<bool> placed(source.size(), false);
  for (const std::size_t position : xyz) {
    addField(
        layout, source[position].name, layout.point_step, PCLPointField::FLOAT32, 1);
    layout.targets[position] = {layout.point_step, PCLPointField::FLOAT32};
    layout.point_step += sizeof(float);
    placed[position] = true;
  }
  if (!colour.empty()) {
    const bool alpha = colour.size() == 4;
    const int datatype = alpha ? PCLPointField::UINT32 : PCLPointField::FLOAT32;
    addField(layout,
             alpha ? "rgba" : "rgb",
             layout.point_step,
             static_cast<std::uint8_t>(datatype),
             1);
    for (std::size_t i = 0; i < colour.size(); ++i) {
      layout.targets[colour[i]] = {layout.point_step + i, PCLPointField::UINT8};
      placed[colour[i]] = true;
    }
    layout.point_step += 4;
  }
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (placed[i] || source[i].isPadding())
      continue;
    addField(
        layout, source[i].name, layout.point_step, source[i].datatype, source[i].count);
    layout.targets[i] = {layout.point_step, source[i].datatype};
    layout.point_step += source[i].bytes();
  }
  if (layout.packs_colors) {
    addField(layout, "rgb", layout.point_step, PCLPointField::FLOAT32, 1);
    layout.point_step += 4;
  }
}

bool
isFinerThanFloat(std::uint8_t datatype)
{
  return datatype != PCLPointField::FLOAT32 && sizeOfType(datatype) >= sizeof(float);
}

} // namespace

RecordMove
FieldLayout::moveOf(std::size_t field) const
{
  double minus = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (coordinates[axis] == field)
      minus = shift[static_cast<Eigen::Index>(axis)];
  const bool converts = minus != 0 || source[field].datatype != targets[field].datatype;
  return {0,
          targets[field].offset,
          source[field].bytes(),
          converts ? source[field].datatype : std::uint8_t{0},
          false,
          minus};
}

void
FieldLayout::subtract(const Eigen::Vector3d& offset)
{
  shift = offset;
  same = same && offset.isZero(0);
}

Eigen::Vector3d
FieldLayout::placeIn(const std::uint8_t* record) const
{
  Eigen::Vector3d place;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const SourceField& field = source[coordinates[axis]];
    place[static_cast<Eigen::Index>(axis)] =
        valueOfType(field.datatype, record + field.offset);
  }
  return place;
}

std::vector<RecordMove>
FieldLayout::moves() const
{
  std::vector<RecordMove> moves;
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (source[i].isPadding())
      continue;
    RecordMove move = moveOf(i);
    move.from = source[i].offset;
    if (move.float_from == 0)
      appendCopy(moves, move);
    else
      moves.push_back(move);
  }
  return moves;
}

FieldLayout
planLayout(std::vector<SourceField> source, const ByteSource& file)
{
  FieldLayout layout;
  layout.source_step = placeFields(source, file);
  const Positions xyz{findCoordinate(source, "x", file),
                      findCoordinate(source, "y", file),
                      findCoordinate(source, "z", file)};
  layout.narrows = std::any_of(xyz.begin(), xyz.end(), [&](std::size_t position) {
    return isFinerThanFloat(source[position].datatype);
  });
  const auto colour = findColourBytes(source);
  layout.coordinates = xyz;
  layout.packs_colors = hasWideColors(source);
  layout.source = std::move(source);
  if (colour.empty() && !layout.packs_colors &&
      coordinatesStandTogether(layout.source, xyz))
    keepPlaces(layout);
  else
    packAnew(layout, xyz, colour);
  return layout;
}

void
packColors(const FieldLayout& layout, PCLPointCloud2& cloud, std::uint8_t* data)
{
  constexpr double widest = 65535;
  if (!layout.packs_colors)
    return;
  const std::array<const PCLPointField*, 3> fields = {
      findField(cloud, "red"), findField(cloud, "green"), findField(cloud, "blue")};
  const std::size_t rows = rowsOf(cloud), rgb = findField(cloud, "rgb")->offset;
  const auto value = [&](std::size_t row, std::size_t c) {
    const double level = valueOfType(fields[c]->datatype,
                                     data + row * cloud.point_step + fields[c]->offset);
    return std::clamp(std::isfinite(level) ? level : 0.0, 0.0, widest);
  };
  double largest = 0;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t c = 0; c < 3; ++c)
      largest = std::max(largest, value(row, c));
  const bool is_real = fields[0]->datatype == PCLPointField::FLOAT32 ||
                       fields[0]->datatype == PCLPointField::FLOAT64;
  const double scale = is_real && largest <= 1 ? 255 : largest <= 255 ? 1 : 1 / 257.0;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t c = 0; c < 3; ++c)
      data[row * cloud.point_step + rgb + 2 - c] =
          static_cast<std::uint8_t>(std::lround(value(row, c) * scale));
  const auto is_number = [](const PCLPointField& field) {
    return field.name == "red" || field.name == "green" || field.name == "blue";
  };
  cloud.fields.erase(
      std::remove_if(cloud.fields.begin(), cloud.fields.end(), is_number),
      cloud.fields.end());
}

void
swapRecords(const FieldLayout& layout, std::uint8_t* records, std::size_t count)
{
  for (const SourceField& field : layout.source) {
    const std::size_t size = sizeOfType(field.datatype);
    for (std::size_t at = 0; size > 1 && at < field.bytes(); at += size)
      swapValues(records + field.offset + at, size, layout.source_step, count);
  }
}

} // namespace pcl::acmap
