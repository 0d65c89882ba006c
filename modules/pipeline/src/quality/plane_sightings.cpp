#include <pcl/core/impl/cloud_fields.h>
#include <pcl/pipeline/plane_sightings.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <tuple>
#include <unordered_map>

namespace pcl {

namespace {

using Eigen::Vector3d;

constexpr std::size_t max_points = 2000000, max_rays = 20000;

/** \brief Cell of a plane and observation. */
struct SightingKey {
  std::int32_t u, v, view;

  bool
  operator==(const SightingKey& other) const
  {
    return std::tie(u, v, view) == std::tie(other.u, other.v, other.view);
  }

  bool
  operator<(const SightingKey& other) const
  {
    return std::tie(u, v, view) < std::tie(other.u, other.v, other.view);
  }
};

struct SightingHash {
  std::size_t
  operator()(const SightingKey& key) const
  {
    std::size_t hash = 0;
    for (const std::int32_t part : {key.u, key.v, key.view})
      hash = hash * 1000003 + static_cast<std::uint32_t>(part);
    return hash;
  }
};

/** \brief Sums of signed distances. */
struct DistanceSums {
  std::uint32_t points = 0;
  double sum = 0, squares = 0;
};

using SumsOfPlane = std::unordered_map<SightingKey, DistanceSums, SightingHash>;

std::vector<PlaneSighting>
listOf(const SumsOfPlane& sums)
{
  std::vector<std::pair<SightingKey, DistanceSums>> sorted(sums.begin(), sums.end());
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return a.first < b.first;
  });
  std::vector<PlaneSighting> list;
  list.reserve(sorted.size());
  for (const auto& [key, one] : sorted) {
    const double number = one.points, mean = one.sum / number;
    list.push_back({{key.u, key.v},
                    key.view,
                    one.points,
                    mean,
                    std::sqrt(std::max(0.0, one.squares / number - mean * mean))});
  }
  return list;
}

} // namespace

PlaneSightings
collectSightings(const CloudRows& cloud,
                 const PointLabels& labels,
                 const std::vector<PlanePatch>& planes,
                 const std::vector<Eigen::Vector3f>& viewpoints)
{
  PlaneSightings sightings;
  sightings.planes.resize(planes.size());
  if (!cloud || labels.size() != cloud.size() || labels.size() == 0)
    return sightings;
  const PCLPointField* const field =
      acmap::findField(cloud.layout(), "view", PCLPointField::INT32);
  if (field)
    sightings.observations = viewpoints.size();
  const acmap::PointView points = acmap::requirePoints(cloud);
  const std::size_t step = cloud.layout().point_step;
  const std::size_t every = (labels.size() + max_points - 1) / max_points;
  const std::size_t every_ray = every * ((labels.size() / every) / max_rays + 1);
  std::vector<SumsOfPlane> sums(planes.size());
  for (std::size_t i = 0; i < labels.size(); i += every) {
    const Eigen::Vector3f& point = points[i];
    std::int32_t view = 0;
    if (field)
      std::memcpy(&view, cloud.data() + i * step + field->offset, sizeof view);
    if (!point.allFinite() || view < 0)
      continue;
    const auto place = static_cast<std::size_t>(view);
    if (i % every_ray == 0 && place < viewpoints.size() &&
        viewpoints[place].allFinite())
      sightings.rays.push_back({viewpoints[place], point, labels[i]});
    if (labels[i] < 0 || static_cast<std::size_t>(labels[i]) >= planes.size())
      continue;
    const PlanePatch& plane = planes[static_cast<std::size_t>(labels[i])];
    const Vector3d arm = point.cast<double>() - plane.center;
    const auto cellOf = [&](const Vector3d& axis) {
      constexpr double farthest = 1e8; // cells
      return static_cast<std::int32_t>(std::floor(
          std::clamp(arm.dot(axis) / PlaneSightings::cell_size, -farthest, farthest)));
    };
    const double distance = plane.coefficients.dot(point.cast<double>().homogeneous());
    DistanceSums& one = sums[static_cast<std::size_t>(labels[i])]
                            [{cellOf(plane.axis_u), cellOf(plane.axis_v), view}];
    ++one.points;
    one.sum += distance;
    one.squares += distance * distance;
  }
  for (std::size_t plane = 0; plane < planes.size(); ++plane)
    sightings.planes[plane] = listOf(sums[plane]);
  return sightings;
}

} // namespace pcl
