#include "bench.h"
#include "cylinder_scenes.h"
#include "half_seen_room.h"
#include "primitive_scenes.h"

#include <pcl/pipeline/plane_mapping.h>
#include <pcl/segmentation/cylinder_hypothesis_clustering.h>

#include <iomanip>
#include <map>
#include <utility>

namespace pcl::acmap::bench {
namespace {

std::vector<CylinderPatch>
findCylinders(const test::CylinderView& view)
{
  CylinderHypothesisClustering<PointXYZ> clustering;
  clustering.setInputCloud(view.cloud);
  clustering.setSourceCloud(view.cloud);
  std::vector<CylinderPatch> patches;
  clustering.segment(patches);
  return patches;
}

const Section half_seen_section("half_seen", [] {
  constexpr std::size_t seeds = 20;
  printHead("noise mm | found | spurious | median radius error mm | largest mm | CPU s "
            "a scene");
  for (const auto& [sigma, reach] :
       {std::pair(0.003, 0.4), std::pair(0.01, 2.0), std::pair(0.02, 5.0)}) {
    std::size_t all = 0, found = 0, spurious = 0;
    std::vector<double> errors;
    const double begin = processSeconds();
    for (std::size_t seed = 0; seed < seeds; ++seed) {
      const test::CylinderView view = test::seeColumns(sigma, seed);
      const std::vector<CylinderPatch> patches = findCylinders(view);
      std::size_t right = 0;
      for (const test::SceneCylinder& truth : view.cylinders)
        if (const CylinderPatch* patch =
                patchOf(truth.point, truth.axis, truth.radius, patches)) {
          ++right;
          errors.push_back(milli * std::abs(patch->radius - truth.radius));
        }
      all += view.cylinders.size();
      found += right;
      spurious += patches.size() - std::min(patches.size(), right);
    }
    const double seconds = (processSeconds() - begin) / seeds;
    Row() << figure(milli * sigma, 0) << atLeast(found, all, 0)
          << atMost(spurious, 0, 0) << figure(median(errors), 2)
          << atMost(largest(errors), reach, 2) << figure(seconds, 2);
  }
});

/** Counts over rooms of one kind. */
struct RoomCounts {
  std::size_t columns = 0, found = 0, spurious = 0, strips = 0;
  std::vector<double> errors; ///< of the radius, millimetres
};

bool
isStrip(const PlanePatch& plane, const test::SceneCylinder& column)
{
  return std::abs(plane.coefficients.head<3>().dot(column.axis)) < 0.5 &&
         distanceToAxis(plane.center, column.point, column.axis) < 1.2 * column.radius;
}

void
countRoom(const test::HalfSeenRoom& room, RoomCounts& counts)
{
  PlaneMapping mapping;
  mapping.setInputCloud(room.cloud);
  mapping.setComputeCylinders(true);
  MappedPlanes found;
  mapping.compute(found);
  std::size_t right = 0;
  for (const test::SceneCylinder& column : room.columns) {
    if (const CylinderPatch* const patch =
            patchOf(column.point, column.axis, column.radius, found.cylinders)) {
      ++right;
      counts.errors.push_back(milli * std::abs(patch->radius - column.radius));
    }
    for (const PlanePatch& plane : found.planes)
      counts.strips += isStrip(plane, column) ? 1 : 0;
  }
  counts.columns += room.columns.size();
  counts.found += right;
  counts.spurious += found.cylinders.size() - std::min(found.cylinders.size(), right);
}

/** Rooms of which nobody knows how they were made: unlike those of half_seen, by the whole
 * chain from points to planes, with and without a sensor. */
const Section rooms_section("rooms", [] {
  constexpr std::uint64_t seeds = 8;
  printHead(
      "noise mm | points a m2 | sensor | found | spurious | strips | median radius "
      "error mm | largest mm");
  for (const double sigma : {0.001, 0.003, 0.01, 0.015})
    for (const double density : {500.0, 1700.0, 5000.0})
      for (const bool has_sensor : {false, true}) {
        RoomCounts counts;
        for (std::uint64_t seed = 0; seed < seeds; ++seed) {
          const test::HalfSeenRoom room = test::makeHalfSeenRoom(
              {sigma, density, seed % 2 == 1, seed % 4 > 1, 500 + seed});
          if (has_sensor)
            room.cloud->sensor_origin_.head<3>() = room.sensor;
          countRoom(room, counts);
        }
        Row() << figure(milli * sigma, 0) << figure(density, 0)
              << (has_sensor ? "known" : "unknown")
              << atLeast(counts.found, counts.columns, 0)
              << atMost(counts.spurious, 0, 0) << atMost(counts.strips, 0, 0)
              << figure(median(counts.errors), 2) << figure(largest(counts.errors), 2);
      }
});

const Section sigma_section("sigma", [] {
  constexpr std::uint64_t seeds = 20;
  printHead("noise mm | radius cm | fits | rms of error over told sigma");
  for (const double sigma : {0.003, 0.01, 0.02}) {
    std::map<double, std::vector<double>> squares; // of each radius, over the variance
    for (std::uint64_t seed = 100; seed < 100 + seeds; ++seed) {
      const test::CylinderView view = test::seeColumns(sigma, seed);
      const std::vector<CylinderPatch> patches = findCylinders(view);
      for (const test::SceneCylinder& truth : view.cylinders)
        if (const CylinderPatch* const patch =
                patchOf(truth.point, truth.axis, truth.radius, patches))
          squares[truth.radius].push_back(std::pow(patch->radius - truth.radius, 2) /
                                          patch->covariance(4, 4));
    }
    for (const auto& [radius, ratios] : squares) {
      const double ratio = std::sqrt(meanOf(ratios));
      std::ostringstream text;
      text << std::fixed << std::setprecision(2) << ratio << " (0.8 to 1.25)";
      const bool is_right = ratio >= 0.8 && ratio <= 1.25;
      Row() << figure(milli * sigma, 0) << figure(centi * radius, 0) << ratios.size()
            << (is_right ? text.str() : "**" + text.str() + "**");
    }
  }
});

} // namespace
} // namespace pcl::acmap::bench
