#include "consolidation/sensor_fit.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

bool
hasNormal(const Representative& representative)
{
  return !std::isnan(representative.normal.x());
}

/** Is at most 5 % of the surface seen edge-on? */
bool
isSeenFromItsFront(const LargeVector<Representative>& representatives,
                   const SensorView& sensors)
{
  using Counts = std::pair<std::size_t, std::size_t>; // edge-on, all
  const auto [edge_on, seen] = parallelReduceChunks(
      representatives.size(),
      Counts{0, 0},
      [&](std::size_t begin, std::size_t end) {
        Counts counts{0, 0};
        for (std::size_t i = begin; i < end; ++i) {
          const Representative& r = representatives[i];
          const Eigen::Vector3f* sensor = sensors[static_cast<std::size_t>(r.witness)];
          if (!sensor || !hasNormal(r))
            continue;
          constexpr float grazing = 0.05f;
          ++counts.second;
          counts.first +=
              std::abs(r.normal.dot((*sensor - r.point).normalized())) < grazing;
        }
        return counts;
      },
      [](Counts& sum, const Counts& next) {
        sum.first += next.first;
        sum.second += next.second;
      });
  return 20 * edge_on <= seen;
}

/** The nearest surface in each direction from a sensor. */
class NearestSurfaces {
public:
  explicit NearestSurfaces(const Eigen::Vector3f& sensor)
  : sensor_(sensor)
  , cells_(std::size_t{rows} * columns, nullptr)
  {}

  void
  add(const Representative& representative)
  {
    const Representative*& nearest = cells_[cellOf(representative)];
    if (!nearest || rangeOf(representative) < rangeOf(*nearest))
      nearest = &representative;
  }

  /** Is a surface in front of the plane of another one, in its direction? */
  bool
  hides(const Representative& representative, double edge) const
  {
    constexpr double voxels = 3, share_of_range = 0.1;
    const Representative& nearest = *cells_[cellOf(representative)];
    const double range = rangeOf(representative);
    const double distance =
        std::abs((nearest.point - representative.point).dot(representative.normal));
    return distance > std::max(voxels * edge, share_of_range * range);
  }

private:
  static constexpr int rows = 120, columns = 240; // of 1.5 degrees

  double
  rangeOf(const Representative& representative) const
  {
    return (representative.point - sensor_).norm();
  }

  /** Cells of a row are about as wide as they are high. */
  std::size_t
  cellOf(const Representative& representative) const
  {
    constexpr double pi = 3.14159265358979323846;
    const Eigen::Vector3d way = (representative.point - sensor_).cast<double>();
    const double height = std::asin(std::clamp(way.z() / way.norm(), -1.0, 1.0));
    const int row = std::clamp(
        static_cast<int>(std::floor((height / pi + 0.5) * rows)), 0, rows - 1);
    const double middle = ((row + 0.5) / rows - 0.5) * pi;
    const int number = std::max(1, static_cast<int>(columns * std::cos(middle)));
    const double turn = std::atan2(way.y(), way.x()) / (2 * pi) + 0.5;
    const int column =
        std::clamp(static_cast<int>(std::floor(turn * number)), 0, number - 1);
    return static_cast<std::size_t>(row * columns + column);
  }

  Eigen::Vector3f sensor_;
  std::vector<const Representative*> cells_;
};

/** Is at most 25 % of a sample of the surface hidden from a sensor? */
bool
isMostlyInSight(const LargeVector<Representative>& representatives,
                const Eigen::Vector3f& sensor,
                double edge)
{
  constexpr std::size_t wanted = 1 << 18;
  const std::size_t stride = representatives.size() / wanted + 1;
  NearestSurfaces nearest(sensor);
  std::size_t hidden = 0, seen = 0;
  const auto visit = [&](const auto& function) {
    for (std::size_t i = 0; i < representatives.size(); i += stride)
      if (hasNormal(representatives[i]) && representatives[i].point != sensor)
        function(representatives[i]);
  };
  visit([&](const Representative& r) { nearest.add(r); });
  visit([&](const Representative& r) {
    ++seen;
    hidden += nearest.hides(r, edge);
  });
  return 4 * hidden <= seen;
}

} // namespace

bool
fitTheirSensors(const LargeVector<Representative>& representatives,
                const SensorView& sensors,
                double edge)
{
  if (!sensors.isKnown() || !isSeenFromItsFront(representatives, sensors))
    return false;
  const Eigen::Vector3f* const single = sensors.single();
  return !single || isMostlyInSight(representatives, *single, edge);
}

} // namespace pcl::acmap
