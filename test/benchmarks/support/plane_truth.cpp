#include "plane_truth.h"

#include "simulated_points.h"

#include <algorithm>
#include <iterator>

namespace pcl::acmap::bench {
namespace {

constexpr const char* main_planes[] = {
    "floor", "ceiling", "left wall", "right wall", "near end", "far end"};
constexpr const char* door_planes[] = {"doors left", "doors right"};

template <typename Names>
bool
isAmong(const Names& names, const std::string& name)
{
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

} // namespace

PlaneCase
makePlaneCase(const SimulatedCloud& cloud)
{
  PlaneCase result;
  result.name = cloud.name;
  result.input =
      makePlaneInput(plainPoints(cloud), cloud.sensorOrigins(), cloud.merged.view);
  result.truth.planes = cloud.merged.planes;
  result.truth.labels.reserve(cloud.size());
  for (const std::uint32_t label : cloud.merged.label)
    result.truth.labels.push_back(static_cast<std::int32_t>(label) - 1);
  return result;
}

bool
isMainPlane(const TruthPlane& plane)
{
  return isAmong(main_planes, plane.name);
}

bool
isDoorPlane(const TruthPlane& plane)
{
  return isAmong(door_planes, plane.name);
}

} // namespace pcl::acmap::bench
