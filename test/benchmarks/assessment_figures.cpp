#include "bench.h"
#include "bench_data.h"
#include "boxed_hall.h"
#include "facade.h"
#include "scan_judgement.h"

#include <pcl/core/noise_scale.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/random.h>
#include <pcl/pipeline/plane_mapping.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace pcl::acmap::bench {
namespace {

using Eigen::Vector3d;

/** A hall with things in it, about a sensor at the origin. */
test::BoxedHall
drawHall(Random& random)
{
  test::BoxedHall hall{
      {Vector3d(
           -random.uniform(3, 15), -random.uniform(3, 15), -random.uniform(0.8, 2.2)),
       Vector3d(random.uniform(3, 15), random.uniform(3, 15), random.uniform(1, 5))},
      {}};
  const int things = static_cast<int>(random.uniform(2, 9));
  for (int k = 0; k < things; ++k) {
    const double turn = random.uniform(0, 2 * M_PI), away = random.uniform(2, 10);
    const Vector3d low(
        away * std::cos(turn), away * std::sin(turn), hall.walls.min().z());
    const Vector3d size(
        random.uniform(0.5, 2), random.uniform(0.5, 2), random.uniform(0.4, 2.5));
    const Eigen::AlignedBox3d thing =
        Eigen::AlignedBox3d(low, low + size).intersection(hall.walls);
    if (!thing.isEmpty() && thing.exteriorDistance(Vector3d::Zero().eval()) > 0.5)
      hall.things.push_back(thing);
  }
  return hall;
}

/** A turn of a scanner with beams at even angles, tilted by up to 8 degrees. */
PointCloud<PointXYZ>::Ptr
scanOf(const test::BoxedHall& hall, int beams, double noise, Random& random)
{
  const int columns = static_cast<int>(random.uniform(700, 1900));
  const double low = random.uniform(-30, -12) * degree,
               high = random.uniform(5, 30) * degree;
  const Eigen::AngleAxisd tilt(
      random.uniform(0, 8) * degree,
      Vector3d(random.normal(), random.normal(), 0).normalized());
  const PointCloud<PointXYZ>::Ptr scan(new PointCloud<PointXYZ>);
  for (int column = 0; column < columns; ++column)
    for (int beam = 0; beam < beams; ++beam) {
      const double turn = 2 * M_PI * (column + 0.37) / columns,
                   rise = low + beam * (high - low) / (beams - 1) + 1e-7;
      const Vector3d ray(std::cos(rise) * std::cos(turn),
                         std::cos(rise) * std::sin(turn),
                         std::sin(rise));
      const double range =
          hall.range(Vector3d::Zero(), tilt * ray) + noise * random.normal();
      PointXYZ point;
      point.getVector3fMap() = (range * ray).cast<float>();
      scan->push_back(point);
    }
  return scan;
}

void
printBeams(const std::string& name,
           const PlaneMapping& mapping,
           const MappedPlanes& found)
{
  const test::ScanJudgement judged = test::judgeScan(found);
  const auto& assessment = mapping.getReport().assessment;
  Row row;
  row << name
      << (assessment && assessment->sensors.outcome == SensorOutcome::Proved ? "proved"
                                                                             : "no")
      << found.planes.size() << figure(judged.area, 1)
      << atLeast(centi * judged.facing / std::max(judged.area, 1e-9), 99, 1)
      << atMost(judged.through_sensor, 0, 0)
      << figure(centi * judged.unsupported / std::max(judged.area, 1e-9), 1);
}

void
printAllBeams()
{
  printHead("scan | its sensor | planes | area in m² | of it facing the sensor in % | "
            "planes through the sensor | outlines over twice their triangles in %");
  for (const char* name :
       {"H_field/clouds/multibeam_room.ply", "H_field/clouds/rings_near_horizon.ply"})
    if (const std::optional<std::string> path = pathOfData(name)) {
      PlaneMapping mapping;
      mapping.setInputCloud(
          std::make_shared<const PointCloudFile>(loadPointCloud(*path)));
      MappedPlanes found;
      mapping.compute(found);
      printBeams(name, mapping, found);
    }
  for (std::uint64_t seed = 101; seed <= 118; ++seed) {
    Random random(seed);
    const int beams = 16 << (seed % 3);
    const double noise = random.uniform(0, 0.03);
    PlaneMapping mapping;
    mapping.setInputCloud(scanOf(drawHall(random), beams, noise, random));
    MappedPlanes found;
    mapping.compute(found);
    printBeams("hall " + std::to_string(seed) + ", " + std::to_string(beams) +
                   " beams, " + std::to_string(static_cast<int>(milli * noise)) + " mm",
               mapping,
               found);
  }
}

std::string
stepsOf(const Report& report)
{
  std::string text;
  for (const auto& [step, seconds] : report.seconds)
    text += (text.empty() ? "" : ", ") +
            std::to_string(static_cast<int>(std::lround(milli * seconds)));
  return text;
}

void
printTimes()
{
  printHead("cloud | points | planes with all before them in s | of it the assessment "
            "in % | its points, sensors, noise, up in ms");
  for (const char* name : {"E_meshing/office1.pcd",
                           "H_field/clouds/multibeam_room.ply",
                           "H_field/clouds/facade_z_up.ply",
                           "C_sequence/pcl_room_scans/room_scan1.pcd",
                           "F_planes/navvis_room1/room1_gt_fine.pcd",
                           "D_large/wtc37_corridor_1M.ply.xz",
                           "D_large/grenoble_room_5.2M.ply.xz"})
    if (const std::optional<std::string> path = pathOfData(name)) {
      const auto file = std::make_shared<const PointCloudFile>(loadMaybePacked(*path));
      PlaneMapping mapping;
      mapping.setInputCloud(file);
      MappedPlanes found;
      mapping.compute(found);
      const PlaneMappingReport& report = mapping.getReport();
      double all = 0, assessment = 0;
      for (const auto& [step, seconds] : report.seconds) {
        all += seconds;
        assessment += step == "assessment" ? seconds : 0;
      }
      Row row;
      row << name << file->points().size() << figure(all, 2)
          << atMost(centi * assessment / all, 10, 1)
          << (report.assessment ? stepsOf(*report.assessment) : no_value);
    }
}

void
printFacades()
{
  constexpr double near = 0.2, far = 1;
  constexpr std::uint64_t facades = 200;
  std::size_t told = 0, wrong = 0;
  for (std::uint64_t seed = 1; seed <= facades; ++seed) {
    Random random(seed);
    const double sigma = random.uniform(0.002, 0.008);
    const std::vector<Eigen::Vector3f> facade = test::makeFacade(sigma, random);
    const NoiseScale scale =
        measureNoiseScale({facade.data(), sizeof(Eigen::Vector3f), facade.size()}, {});
    const double error = std::abs(scale.sigma - sigma) / sigma;
    told += error <= near;
    wrong += scale.is_determined && error > far;
  }
  printHead("facades | noise within 20 % | more than twice the true one");
  Row row;
  row << facades << told << atMost(wrong, 0, 0);
}

const Section beams("beams", printAllBeams);
const Section times("time", printTimes);
const Section facades("facades", printFacades);

} // namespace
} // namespace pcl::acmap::bench
