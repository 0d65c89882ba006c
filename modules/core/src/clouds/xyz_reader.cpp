#include "clouds/point_cloud_readers.h"
#include "clouds/text_layout.h"
#include "files/byte_source.h"
#include "files/text_number.h"

#include <pcl/PCLPointField.h>
#include <pcl/core/impl/unit_text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace pcl::acmap {

namespace {

constexpr std::size_t max_rows = std::numeric_limits<std::int32_t>::max();

/** \brief The values of the columns that are used, row by row. */
struct TextTable {
  std::vector<double> places; ///< x, y, z
  std::vector<float> colors;  ///< red, green, blue
  std::vector<float> others;  ///< intensity and normal, as far as there are some

  std::size_t
  rows() const
  {
    return places.size() / 3;
  }
};

void
addRow(const std::vector<std::string_view>& fields,
       const TextLayout& layout,
       TextTable& table,
       const ByteSource& source)
{
  std::array<double, text_roles> values{};
  for (std::size_t i = 0; i < layout.roles.size() && i < fields.size(); ++i) {
    const TextRole role = layout.roles[i];
    double& value = values[static_cast<std::size_t>(role)];
    if (role != TextRole::None &&
        !parseField(fields[i], layout.has_decimal_commas, value))
      source.failAtLine(inQuotes(fields[i]) + " is not a number");
  }
  const auto at = [&](TextRole role) {
    return &values[static_cast<std::size_t>(role)];
  };
  const auto put = [&](TextRole first, std::size_t count, std::vector<float>& to) {
    for (std::size_t i = 0; layout.has(first) && i < count; ++i)
      to.push_back(narrowed(at(first)[i]));
  };
  table.places.insert(table.places.end(), at(TextRole::X), at(TextRole::X) + 3);
  put(TextRole::Red, 3, table.colors);
  put(TextRole::Intensity, 1, table.others);
  put(TextRole::NormalX, 3, table.others);
}

/** \brief Lines that give the number of points. */
struct CountLines {
  std::uint64_t points = 0;
  std::size_t lines = 0;

  /** \return true if the line is one */
  bool
  take(std::string_view line)
  {
    std::string_view word;
    Words words(line);
    std::uint64_t count = 0;
    if (!words.next(word) || !parseCount(word, count) || words.next(word))
      return false;
    points += count;
    ++lines;
    return true;
  }

  void
  tell(std::size_t rows, bool is_pts, std::vector<std::string>& remarks) const
  {
    if (lines > 0 && points != rows)
      remarks.push_back("the first line claims " + std::to_string(points) +
                        " points, the file has " + std::to_string(rows));
    else if (lines > 0 && !is_pts)
      remarks.emplace_back("a line with the count of the points was left out");
  }
};

void
readRows(ByteSource& source,
         bool is_pts,
         const TextLayout& layout,
         TextTable& table,
         CountLines& counts)
{
  const std::size_t needed = layout.needed();
  std::vector<std::string_view> fields;
  for (std::string_view line; source.readFilledLine(line);) {
    if (isTextComment(line))
      continue;
    const bool is_above = table.places.empty();
    if ((is_above || is_pts) && counts.take(line))
      continue;
    if (is_above && !isTextRow(line))
      continue;
    splitRow(line, layout.separators, fields);
    if (fields.size() < needed)
      source.failAtLine(needed == 3
                            ? "has fewer than three numbers"
                            : "has " + std::to_string(fields.size()) + " columns, " +
                                  std::to_string(needed) + " are needed");
    if (table.rows() >= max_rows)
      source.fail("holds more than " + std::to_string(max_rows) + " points");
    addRow(fields, layout, table, source);
  }
}

std::vector<SourceField>
fieldsOf(const TextLayout& layout)
{
  std::vector<SourceField> fields;
  const auto add = [&](std::initializer_list<const char*> names) {
    for (const char* name : names)
      fields.push_back({name, PCLPointField::FLOAT32, 1});
  };
  add({"x", "y", "z"});
  if (layout.has(TextRole::Red))
    add({"rgb"});
  if (layout.has(TextRole::Intensity))
    add({"intensity"});
  if (layout.has(TextRole::NormalX))
    add({"normal_x", "normal_y", "normal_z"});
  return fields;
}

/** Colours are fractions, 0 to 255 or 0 to 65535, as the largest shows.
 * \throws InputFileException if they are known by the numbers of the first rows only, and
 * others are none */
double
scaleOfColors(const TextLayout& layout,
              const TextTable& table,
              const ByteSource& source)
{
  float least = 0, largest = 0;
  for (const float level : table.colors) {
    least = std::min(least, level);
    largest = std::max(largest, level);
  }
  if (layout.is_guessed && (least < 0 || largest > 255))
    source.fail("has columns that begin as colours, but reach " +
                textOf(largest > 255 ? largest : least) +
                ": --columns x,y,z leaves them out");
  return largest <= 1 ? 255 : largest <= 255 ? 1 : 1 / 257.0;
}

void
storeRows(const TextLayout& layout,
          const FieldLayout& fields,
          const TextTable& table,
          const ByteSource& source,
          PCLPointCloud2& cloud)
{
  const double scale = scaleOfColors(layout, table, source);
  const std::size_t rows = table.rows(), others = table.others.size() / rows;
  const bool has_colors = !table.colors.empty();
  for (std::size_t row = 0; row < rows; ++row) {
    std::uint8_t* const to = &cloud.data[row * fields.point_step];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float value = narrowed(table.places[3 * row + axis]);
      std::memcpy(to + axis * sizeof value, &value, sizeof value);
    }
    for (std::size_t c = 0; has_colors && c < 3; ++c) {
      const double level = table.colors[3 * row + c] * scale;
      to[3 * sizeof(float) + 2 - c] = static_cast<std::uint8_t>(
          std::lround(std::clamp(std::isfinite(level) ? level : 0.0, 0.0, 255.0)));
    }
    if (others > 0)
      std::memcpy(to + (has_colors ? 4 : 3) * sizeof(float),
                  &table.others[row * others],
                  others * sizeof(float));
  }
}

/** Makes metres of the unit that the names have, unless the caller states one. */
void
scaleToMetres(const TextLayout& layout,
              const CloudStatement& stated,
              TextTable& table,
              PointCloudFile& file)
{
  if (!layout.unit || stated.is_scale_stated)
    return;
  file.stated_scale = layout.unit;
  if (*layout.unit == 1)
    return;
  for (double& place : table.places)
    place *= *layout.unit;
  file.remarks.push_back("its columns name their unit: " + unitText(*layout.unit) +
                         " m were taken for 1; --scale states another");
}

/** \throws InputFileException for what is no text of lines in UTF-8 */
void
passMark(ByteSource& source)
{
  const std::string_view head = source.ahead(ByteSource::maximum_line);
  if (head.substr(0, 2) == "\xff\xfe" || head.substr(0, 2) == "\xfe\xff")
    source.fail("is text in UTF-16: save it in UTF-8");
  if (head.find('\n') == head.npos && head.find('\r') < head.size() - 1)
    source.fail("ends its lines by CR alone: save it with LF");
  if (head.substr(0, 3) == "\xef\xbb\xbf")
    source.skip(3);
}

} // namespace

PointCloudFile
readText(ByteSource& source, bool is_pts, const CloudStatement& stated)
{
  passMark(source);
  const TextLayout layout = findTextLayout(
      source.ahead(ByteSource::maximum_line), is_pts, stated.columns, source);
  TextTable table;
  CountLines counts;
  readRows(source, is_pts, layout, table, counts);
  if (table.places.empty())
    source.fail("has no row of three numbers");
  const FieldLayout fields = planLayout(fieldsOf(layout), source);
  PointCloudFile file;
  file.remarks = layout.remarks;
  scaleToMetres(layout, stated, table, file);
  shapeCloud(file.cloud, fields, table.rows(), 1);
  storeRows(layout, fields, table, source, file.cloud);
  file.columns = layout.told();
  shiftPlaces(table.places, stated, false, file);
  counts.tell(table.rows(), is_pts, file.remarks);
  CoordinateCheck check(true, stated.scale);
  check.setShift(file.shift);
  check.add(file);
  check.finish(file);
  return file;
}

} // namespace pcl::acmap
