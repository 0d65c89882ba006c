#include "clouds/point_cloud_readers.h"
#include "files/byte_source.h"
#include "files/text_number.h"

#include <pcl/PCLPointField.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

namespace {

constexpr std::size_t max_points = std::numeric_limits<std::int32_t>::max();

/** \brief The leading numbers of a line, at most \a Most. */
template <std::size_t Most>
struct Numbers {
  explicit Numbers(Words words)
  {
    while (count < Most && words.next(bad) && parseNumber(bad, values[count]))
      ++count;
    if (count > 0 && count == Most)
      bad = {};
  }

  std::array<float, Most> values{};
  std::size_t count = 0;
  std::string_view bad; // the first word that is not a number
};

void
appendPoint(std::vector<float>& to, const float* values, const ByteSource& source)
{
  if (to.size() / 3 >= max_points)
    source.fail("holds more than " + std::to_string(max_points) + " points");
  to.insert(to.end(), values, values + 3);
}

std::vector<SourceField>
textFields(bool colour)
{
  std::vector<SourceField> fields;
  for (const char* name : {"x", "y", "z"})
    fields.push_back({name, PCLPointField::FLOAT32, 1});
  if (colour)
    fields.push_back({"rgb", PCLPointField::FLOAT32, 1});
  return fields;
}

PointCloudFile
makeCloud(const std::vector<float>& points, bool colour, const ByteSource& source)
{
  PointCloudFile file;
  const FieldLayout layout = planLayout(textFields(colour), source);
  const std::size_t count = points.size() / 3;
  shapeCloud(file.cloud, layout, count, 1);
  moveRecords({{0, 0, 3 * sizeof(float)}},
              reinterpret_cast<const std::uint8_t*>(points.data()),
              3 * sizeof(float),
              file.cloud.data.data(),
              layout.point_step,
              count);
  CoordinateCheck check(true);
  check.add(file);
  check.finish(file);
  return file;
}

// Colours are between 0 and 1, as written by most programs, unless one exceeds 1.
void
storeColours(const std::vector<float>& colours, PCLPointCloud2& cloud)
{
  const float largest = *std::max_element(colours.begin(), colours.end());
  const float scale = largest > 1.0F ? 1.0F : 255.0F;
  std::uint8_t* to = cloud.data.data() + 3 * sizeof(float);
  for (std::size_t i = 0; i < colours.size(); i += 3, to += cloud.point_step)
    for (std::size_t c = 0; c < 3; ++c) {
      const float level = std::clamp(colours[i + c] * scale, 0.0F, 255.0F);
      to[2 - c] = static_cast<std::uint8_t>(std::lround(level));
    }
}

bool
isComment(std::string_view line)
{
  const std::size_t begin = line.find_first_not_of(" \t");
  line.remove_prefix(std::min(begin, line.size()));
  return line.substr(0, 1) == "#" || line.substr(0, 2) == "//";
}

/** \brief Lines that some programs write before the rows of an XYZ file. */
class XyzPreamble {
public:
  /** \return true when the line contains the number of rows, or names of the columns */
  bool
  accepts(const Numbers<3>& numbers, std::string_view line)
  {
    if (numbers.count == 0 && !names_) {
      names_ = true;
      return true;
    }
    std::string_view word;
    Words words(line);
    if (numbers.count != 1 || !numbers.bad.empty() || count_ || names_ ||
        !words.next(word) || !parseCount(word, rows_))
      return false;
    count_ = true;
    return true;
  }

  void
  tell(std::size_t rows, std::vector<std::string>& remarks) const
  {
    if (names_)
      remarks.emplace_back("a line of names above the points was left out");
    if (count_ && rows_ == rows)
      remarks.emplace_back("a line with the count of the points was left out");
    else if (count_)
      remarks.push_back("the first line claims " + std::to_string(rows_) +
                        " points, the file has " + std::to_string(rows));
  }

private:
  bool names_ = false;
  bool count_ = false;
  std::uint64_t rows_ = 0;
};

} // namespace

PointCloudFile
readXyz(ByteSource& source)
{
  std::vector<float> points;
  XyzPreamble preamble;
  for (std::string_view line; source.readFilledLine(line);) {
    if (isComment(line))
      continue;
    const Numbers<3> numbers(Words(line, Words::Separators::blanks_and_commas));
    if (numbers.count == 3)
      appendPoint(points, numbers.values.data(), source);
    else if (!points.empty() || !preamble.accepts(numbers, line))
      source.failAtLine(numbers.bad.empty()
                            ? "has fewer than three numbers"
                            : inQuotes(numbers.bad) + " is not a number");
  }
  if (points.empty())
    source.fail("has no row of three numbers");
  PointCloudFile file = makeCloud(points, false, source);
  preamble.tell(points.size() / 3, file.remarks);
  return file;
}

PointCloudFile
readObj(ByteSource& source)
{
  std::vector<float> points;
  std::vector<float> colours;
  for (std::string_view line; source.readFilledLine(line);) {
    Words words(line);
    std::string_view key;
    if (!words.next(key) || key != "v")
      continue;
    const Numbers<6> numbers(words);
    if (numbers.count < 3)
      source.failAtLine(numbers.bad.empty()
                            ? "vertex has fewer than three numbers"
                            : inQuotes(numbers.bad) + " is not a number");
    appendPoint(points, numbers.values.data(), source);
    if (numbers.count == 6)
      colours.insert(colours.end(), &numbers.values[3], &numbers.values[3] + 3);
  }
  if (points.empty())
    source.fail("has no vertex: no line begins with 'v'");
  const bool coloured = colours.size() == points.size();
  PointCloudFile file = makeCloud(points, coloured, source);
  file.usual_up = Eigen::Vector3f::UnitY();
  if (coloured)
    storeColours(colours, file.cloud);
  else if (!colours.empty())
    file.remarks.emplace_back("only some vertices have a colour; these were left out");
  return file;
}

} // namespace pcl::acmap
