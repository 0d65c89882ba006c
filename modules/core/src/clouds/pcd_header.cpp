#include "clouds/pcd_header.h"

#include "files/byte_source.h"
#include "files/text_number.h"

#include <pcl/PCLPointField.h>
#include <pcl/core/impl/pcd_viewpoint.h>
#include <pcl/core/impl/size_text.h>

#include <array>
#include <limits>
#include <optional>
#include <string_view>

namespace pcl::acmap {

namespace {

/** \brief The lines of a header, stored until all are known, because their order is
 * arbitrary. */
struct PcdLines {
  std::vector<std::string> names;
  std::vector<std::uint64_t> sizes;
  std::vector<char> types;
  std::vector<std::int64_t> counts;
  std::optional<std::uint64_t> width;
  std::optional<std::uint64_t> height;
  std::optional<std::uint64_t> points;
};

std::uint64_t
toCount(std::string_view word, std::string_view key, const ByteSource& source)
{
  std::uint64_t count = 0;
  if (!parseCount(word, count))
    source.failAtLine(std::string(key) + " " + inQuotes(word) + " is not a count");
  return count;
}

std::uint64_t
readCount(Words& words, std::string_view key, const ByteSource& source)
{
  std::string_view word;
  words.next(word);
  return toCount(word, key, source);
}

std::vector<std::uint64_t>
readSizes(Words& words, std::string_view key, const ByteSource& source)
{
  std::vector<std::uint64_t> sizes;
  for (std::string_view word; words.next(word);)
    sizes.push_back(toCount(word, key, source));
  return sizes;
}

std::vector<std::int64_t>
readFieldCounts(Words& words, const ByteSource& source)
{
  constexpr std::int64_t maximum = std::numeric_limits<std::int32_t>::max();
  std::vector<std::int64_t> counts;
  for (std::string_view word; words.next(word);) {
    std::int64_t& count = counts.emplace_back();
    if (!storeNumber(
            word, PCLPointField::INT64, reinterpret_cast<std::uint8_t*>(&count)) ||
        count < -maximum || count > maximum)
      source.failAtLine("COUNT " + inQuotes(word) + " is not a count");
  }
  return counts;
}

void
readViewpoint(Words& words, PcdHeader& header, const ByteSource& source)
{
  std::array<double, 7> values{};
  for (double& value : values) {
    std::string_view word;
    if (!words.next(word) || !parseNumber(word, value))
      source.failAtLine("VIEWPOINT needs 7 numbers: tx ty tz qw qx qy qz");
  }
  const Eigen::Vector3d origin(values[0], values[1], values[2]);
  const Eigen::Quaternionf orientation(narrowed(values[3]),
                                       narrowed(values[4]),
                                       narrowed(values[5]),
                                       narrowed(values[6]));
  const float norm = orientation.norm();
  constexpr double farthest = std::numeric_limits<float>::max();
  if (!(origin.cwiseAbs().maxCoeff() <= farthest) || !origin.allFinite() ||
      !(norm > 0.5F && norm < 2.0F)) {
    header.remarks.emplace_back("VIEWPOINT is not a pose; the identity was taken");
    return;
  }
  header.origin = origin;
  header.orientation = orientation.normalized();
}

PcdHeader::Encoding
readEncoding(Words& words, const ByteSource& source)
{
  std::string_view word;
  words.next(word);
  if (word == "ascii")
    return PcdHeader::Encoding::ascii;
  if (word == "binary")
    return PcdHeader::Encoding::binary;
  if (word == "binary_compressed")
    return PcdHeader::Encoding::binary_compressed;
  source.failAtLine("DATA " + inQuotes(word) + " is not known");
}

/** \return false for a key that is not part of a PCD header */
bool
readKeyedLine(std::string_view key,
              Words& words,
              PcdLines& lines,
              PcdHeader& header,
              const ByteSource& source)
{
  if (key == "FIELDS" || key == "COLUMNS") {
    lines.names.clear();
    for (std::string_view word; words.next(word);) {
      if (lines.names.size() == max_fields)
        source.failAtLine("names more than " + std::to_string(max_fields) + " fields");
      lines.names.emplace_back(word);
    }
  }
  else if (key == "TYPE") {
    lines.types.clear();
    for (std::string_view word; words.next(word);)
      lines.types.push_back(word.front());
  }
  else if (key == "SIZE")
    lines.sizes = readSizes(words, key, source);
  else if (key == "COUNT")
    lines.counts = readFieldCounts(words, source);
  else if (key == "WIDTH")
    lines.width = readCount(words, key, source);
  else if (key == "HEIGHT")
    lines.height = readCount(words, key, source);
  else if (key == "POINTS")
    lines.points = readCount(words, key, source);
  else if (key == "VIEWPOINT")
    readViewpoint(words, header, source);
  else
    return key == "VERSION";
  return true;
}

std::uint8_t
datatypeOf(char type, std::uint64_t size)
{
  const auto pick = [size](int one, int two, int four, int eight) {
    return size == 1 ? one : size == 2 ? two : size == 4 ? four : size == 8 ? eight : 0;
  };
  using Field = PCLPointField;
  int datatype = 0;
  if (type == 'I')
    datatype = pick(Field::INT8, Field::INT16, Field::INT32, Field::INT64);
  else if (type == 'U')
    datatype = pick(Field::UINT8, Field::UINT16, Field::UINT32, Field::UINT64);
  else if (type == 'F')
    datatype = pick(0, 0, Field::FLOAT32, Field::FLOAT64);
  else if (type == 'B' && size == 1)
    datatype = Field::BOOL;
  return static_cast<std::uint8_t>(datatype);
}

template <typename Value>
Value
valueOr(const std::vector<Value>& values, std::size_t i, Value otherwise)
{
  return values.empty() ? otherwise : values[i];
}

void
joinFields(const PcdLines& lines, PcdHeader& header, const ByteSource& source)
{
  if (lines.names.empty())
    source.fail("header has no FIELDS");
  const auto require_length = [&](const char* key, std::size_t length) {
    if (length != 0 && length != lines.names.size())
      source.fail(std::string("header has ") + std::to_string(lines.names.size()) +
                  " FIELDS but " + std::to_string(length) + " of " + key);
  };
  require_length("SIZE", lines.sizes.size());
  require_length("TYPE", lines.types.size());
  require_length("COUNT", lines.counts.size());
  for (std::size_t i = 0; i < lines.names.size(); ++i) {
    const std::uint64_t size = valueOr<std::uint64_t>(lines.sizes, i, 4);
    const char type = valueOr(lines.types, i, 'F');
    const std::string field = "field " + inQuotes(lines.names[i]);
    SourceField& added = header.fields.emplace_back();
    added.name = lines.names[i];
    added.datatype = datatypeOf(type, size);
    if (added.datatype == 0)
      source.fail(field + " has TYPE " + inQuotes({&type, 1}) + " with SIZE " +
                  std::to_string(size));
    added.count = valueOr<std::int64_t>(lines.counts, i, 1);
    if (added.count < 1 && !added.isPadding())
      source.fail(field + " has COUNT " + std::to_string(added.count));
  }
}

void
joinCounts(const PcdLines& lines, PcdHeader& header, const ByteSource& source)
{
  if (!lines.points && !lines.width)
    source.fail("header has neither POINTS nor WIDTH");
  header.width = lines.width.value_or(0);
  header.height = lines.height.value_or(0);
  if (header.width == 0 && header.height <= 1)
    header.width = lines.points.value_or(0);
  if (header.height == 0)
    header.height = 1;
  if (header.width > std::numeric_limits<std::uint64_t>::max() / header.height)
    source.fail("header claims " + sizeText(header) + " points");
  header.points = header.width * header.height;
  if (lines.points && *lines.points != header.points)
    source.fail("header claims " + std::to_string(*lines.points) + " points and " +
                sizeText(header));
  if (header.points == 0) {
    header.width = 0;
    header.height = 1;
  }
}

} // namespace

PcdHeader
readPcdHeader(ByteSource& source)
{
  PcdHeader header;
  PcdLines lines;
  for (std::string_view line; source.readLine(line);) {
    Words words(line);
    std::string_view key;
    if (!words.next(key) || key.front() == '#')
      continue;
    if (key == "DATA") {
      header.encoding = readEncoding(words, source);
      joinFields(lines, header, source);
      joinCounts(lines, header, source);
      return header;
    }
    if (!readKeyedLine(key, words, lines, header, source))
      source.failAtLine(inQuotes(key) + " is no entry of a PCD header");
  }
  source.fail("ends before the DATA line of a PCD header");
}

Eigen::Isometry3d
loadPcdViewpoint(const std::string& path)
{
  ByteSource source(path);
  const PcdHeader header = readPcdHeader(source);
  Eigen::Isometry3d pose(header.orientation.cast<double>().normalized());
  pose.translation() = header.origin;
  return pose;
}

} // namespace pcl::acmap
