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

constexpr std::size_t max_obj_vertices = std::numeric_limits<std::int32_t>::max();

/** \brief The leading numbers of a line, at most six. */
struct Numbers {
  explicit Numbers(Words words)
  {
    while (count < values.size() && words.next(bad) && parseNumber(bad, values[count]))
      ++count;
  }

  std::array<double, 6> values{};
  std::size_t count = 0;
  std::string_view bad; // the first word that is not a number
};

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
makeCloud(const std::vector<double>& points,
          bool colour,
          const CloudStatement& stated,
          const ByteSource& source)
{
  PointCloudFile file;
  const FieldLayout layout = planLayout(textFields(colour), source);
  const std::size_t count = points.size() / 3;
  shapeCloud(file.cloud, layout, count, 1);
  for (std::size_t i = 0; i < count; ++i) {
    const std::array<float, 3> point = {narrowed(points[3 * i]),
                                        narrowed(points[3 * i + 1]),
                                        narrowed(points[3 * i + 2])};
    std::memcpy(&file.cloud.data[i * layout.point_step], point.data(), sizeof point);
  }
  shiftPlaces(points, stated, false, file);
  CoordinateCheck check(true, stated.scale);
  check.setShift(file.shift);
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

} // namespace

PointCloudFile
readObj(ByteSource& source, const CloudStatement& stated)
{
  std::vector<double> points;
  std::vector<float> colours;
  for (std::string_view line; source.readFilledLine(line);) {
    Words words(line);
    std::string_view key;
    if (!words.next(key) || key != "v")
      continue;
    const Numbers numbers(words);
    if (numbers.count < 3)
      source.failAtLine(numbers.bad.empty()
                            ? "vertex has fewer than three numbers"
                            : inQuotes(numbers.bad) + " is not a number");
    points.insert(points.end(), &numbers.values[0], &numbers.values[0] + 3);
    if (points.size() / 3 > max_obj_vertices)
      source.fail("holds more than " + std::to_string(max_obj_vertices) + " points");
    if (numbers.count == 6)
      for (std::size_t c = 3; c < 6; ++c)
        colours.push_back(narrowed(numbers.values[c]));
  }
  if (points.empty())
    source.fail("has no vertex: no line begins with 'v'");
  const bool coloured = colours.size() == points.size();
  PointCloudFile file = makeCloud(points, coloured, stated, source);
  if (!file.usual_up)
    file.usual_up = Eigen::Vector3f::UnitY();
  if (coloured)
    storeColours(colours, file.cloud);
  else if (!colours.empty())
    file.remarks.emplace_back("only some vertices have a colour; these were left out");
  return file;
}

} // namespace pcl::acmap
