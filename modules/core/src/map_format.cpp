#include "map_format.h"

#include "trajectory_checks.h"

#include <pcl/exceptions.h>

#include <cmath>

namespace pcl::acmap {

namespace {

[[noreturn]] void
refuse(const std::string& what, std::size_t index, const std::string& fault)
{
  throw BadArgumentException(what + " " + std::to_string(index) + " of a map " + fault);
}

void
requireChart(const CompactMap& map, std::size_t index)
{
  const TextureChart& chart = map.charts[index];
  if (chart.plane >= map.planes.size())
    refuse("chart",
           index,
           "is of plane " + std::to_string(chart.plane) + " of " +
               std::to_string(map.planes.size()));
  const std::size_t polygons = map.planes[chart.plane].polygons.size();
  if (chart.polygon >= polygons)
    refuse("chart",
           index,
           "is of polygon " + std::to_string(chart.polygon) + " of " +
               std::to_string(polygons));
  const std::string fault = faultOfFrame(chart);
  if (!fault.empty())
    refuse("chart", index, fault);
  for (const std::string& name : {chart.image, chart.kinds_image})
    for (const char c : name)
      if (c < ' ' || c > '~')
        refuse("chart", index, "names an image in letters that are not ASCII");
}

void
requireObservations(const CompactMap& map, std::size_t plane)
{
  const std::vector<std::int32_t>& numbers = map.observations[plane];
  const std::size_t poses = map.trajectory.poses.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] < 0 || (i > 0 && numbers[i] <= numbers[i - 1]))
      refuse("plane", plane, "has observations that do not ascend from 0");
    if (poses > 0 && static_cast<std::size_t>(numbers[i]) >= poses)
      refuse("plane",
             plane,
             "was seen by observation " + std::to_string(numbers[i]) + " of " +
                 std::to_string(poses));
  }
}

} // namespace

std::string
faultOfFrame(const TextureChart& chart)
{
  const std::int64_t width = chart.colors.width;
  const std::int64_t height = chart.colors.height;
  if (width <= 0 || height <= 0 || width * height > maximum_texels)
    return "has " + std::to_string(width) + " x " + std::to_string(height) +
           " texels, 1 to 2^28 are legal";
  const double area = chart.texel_u.cross(chart.texel_v).norm();
  if (!chart.origin.allFinite() || !(area > 0) || !std::isfinite(area))
    return "has texels without an area";
  return "";
}

void
requireConsistent(const CompactMap& map)
{
  for (std::size_t i = 0; i < map.charts.size(); ++i)
    requireChart(map, i);
  if (!map.observations.empty() && map.observations.size() != map.planes.size())
    throw BadArgumentException("a map of " + std::to_string(map.planes.size()) +
                               " planes has observations of " +
                               std::to_string(map.observations.size()));
  for (std::size_t i = 0; i < map.observations.size(); ++i)
    requireObservations(map, i);
  requireTrajectory(map.trajectory);
}

} // namespace pcl::acmap
