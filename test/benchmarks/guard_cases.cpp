#include "guard_cases.h"

#include "guard_buildings.h"

#include <pcl/core/planar_scan.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace pcl::acmap::bench {
namespace {

constexpr double short_reach = 5; ///< metres

struct Laser {
  int beams = 180;             ///< over 180 degrees
  double reach = 20;           ///< metres
  double noise = 0.01;         ///< metres, along a beam
  double lost = 0.01;          ///< share of the beams without an echo
  double through_glass = 0.85; ///< share of the beams that pass
};

/** Range of the nearest wall along a beam, metres; infinite if there is none. Numbers
 * rather than vectors, because tests are compiled without optimization. */
double
rangeOf(const std::vector<BuildingWall>& walls,
        const PlanarPose& from,
        double angle,
        const Laser& laser,
        Random& random)
{
  const double way_x = std::sin(angle), way_z = std::cos(angle);
  double nearest = std::numeric_limits<double>::infinity();
  for (const BuildingWall& wall : walls) {
    const double* const a = wall.from.data();
    const double* const b = wall.to.data();
    const double along_x = b[0] - a[0], along_z = b[1] - a[1];
    const double x = a[0] - from.x, z = a[1] - from.z;
    const double slope = way_x * along_z - way_z * along_x;
    const double range = (x * along_z - z * along_x) / slope;
    const double share = (x * way_z - z * way_x) / slope;
    if (range > 0 && share >= 0 && share <= 1 && range < nearest &&
        !(wall.is_glass && random.uniform() < laser.through_glass))
      nearest = range;
  }
  return nearest;
}

std::vector<BuildingWall>
wallsDuring(const Building& building, WallTime half)
{
  std::vector<BuildingWall> walls;
  std::copy_if(building.walls.begin(),
               building.walls.end(),
               std::back_inserter(walls),
               [half](const BuildingWall& wall) {
                 return wall.time == WallTime::Always || wall.time == half;
               });
  return walls;
}

PlanarScan
scanFrom(const std::vector<BuildingWall>& walls,
         const PlanarPose& pose,
         const Laser& laser,
         Random& random)
{
  PlanarScan scan;
  scan.angle_step = M_PI / laser.beams;
  scan.first_angle = -M_PI / 2 + scan.angle_step / 2;
  scan.maximum_range = static_cast<float>(laser.reach);
  for (int i = 0; i < laser.beams; ++i) {
    const double angle = pose.theta + scan.first_angle + i * scan.angle_step;
    double range =
        rangeOf(walls, pose, angle, laser, random) + laser.noise * random.normal();
    if (random.uniform() < laser.lost || !(range < laser.reach))
      range = laser.reach + 1;
    scan.ranges.push_back(static_cast<float>(range));
  }
  return scan;
}

void
addScan(const PlanarScan& scan, const PlanarPose& truth, RectificationMap& map)
{
  PlanarScanPoints points = pointsOf(scan);
  map.clouds.push_back(std::move(points.cloud));
  map.weights.push_back(std::move(points.weights));
  map.truth.push_back(truth);
}

RectificationMap
scanBuilding(const Building& building, const Laser& laser, Random& random)
{
  RectificationMap map;
  const std::vector<BuildingWall> walls[2] = {
      wallsDuring(building, WallTime::FirstHalf),
      wallsDuring(building, WallTime::SecondHalf)};
  const std::size_t poses = building.path.size();
  for (std::size_t i = 0; i < poses; ++i)
    addScan(scanFrom(walls[2 * i < poses ? 0 : 1], building.path[i], laser, random),
            building.path[i],
            map);
  return map;
}

/** Keeps the points for which \a keeps (number of the scan, number of the point). */
template <typename Keeps>
void
thin(RectificationMap& map, const Keeps& keeps)
{
  for (std::size_t i = 0; i < map.clouds.size(); ++i) {
    const PointCloud<PointNormal>::Ptr kept(new PointCloud<PointNormal>);
    std::vector<float> weights;
    for (std::size_t p = 0; p < map.clouds[i]->size(); ++p)
      if (keeps((*map.clouds[i])[p], p)) {
        kept->push_back((*map.clouds[i])[p]);
        weights.push_back(map.weights[i][p]);
      }
    map.clouds[i] = kept;
    map.weights[i] = weights;
  }
}

void
keepEverySecondScan(RectificationMap& map)
{
  RectificationMap kept;
  for (std::size_t i = 0; i < map.clouds.size(); i += 2) {
    kept.clouds.push_back(map.clouds[i]);
    kept.weights.push_back(map.weights[i]);
    kept.truth.push_back(map.truth[i]);
  }
  thin(kept, [](const PointNormal&, std::size_t p) { return p % 2 == 0; });
  map.clouds.swap(kept.clouds);
  map.weights.swap(kept.weights);
  map.truth.swap(kept.truth);
}

void
shortenRays(RectificationMap& map)
{
  thin(map, [](const PointNormal& point, std::size_t) {
    return point.getVector3fMap().norm() < short_reach;
  });
}

/** Odometry as in \ref drifted, with the additions of a variant. */
std::vector<PlanarPose>
odometryOf(const GuardCase& at, Random& random)
{
  const DriftModel drift = robotDrift(at.level);
  const bool is_heavy = at.variant == GuardVariant::HeavyTails;
  const bool is_biased = at.variant == GuardVariant::Bias;
  const double sign = random.uniform() < 0.5 ? -1 : 1;
  const double bias = (is_biased ? 4 : 1) * sign * drift.turn_bias;
  const double scale = is_biased ? 1 + 0.03 * at.level * sign : 1;
  const std::vector<PlanarPose>& truth = at.map.truth;
  std::vector<PlanarPose> poses{truth.front()};
  for (std::size_t i = 1; i < truth.size(); ++i) {
    PlanarAction action = actionBetween(truth[i - 1], truth[i]);
    const double factor = is_heavy && random.uniform() < 0.1 ? 4 : 1;
    const double way = std::hypot(action.dx, action.dz);
    const double length = factor * (drift.length + drift.length_per_metre * way);
    const double turn =
        factor * (drift.turn + drift.turn_per_radian * std::abs(action.dtheta));
    action.dx = scale * action.dx + length * random.normal();
    action.dz = scale * action.dz + length * random.normal();
    action.dtheta += turn * random.normal() + bias;
    poses.push_back(moved(poses.back(), action));
  }
  return poses;
}

OdometryNoise
noiseToldTo(GuardVariant variant)
{
  const double factor = variant == GuardVariant::ToldTooSmall   ? 1.0 / 3
                        : variant == GuardVariant::ToldTooLarge ? 3.0
                                                                : 1.0;
  OdometryNoise told;
  for (double* const sigma :
       {&told.length, &told.length_per_metre, &told.turn, &told.turn_per_radian})
    *sigma *= factor;
  return told;
}

RectificationMap
mapOf(const GuardCase& at, Random& random)
{
  for (const BuildingKind& kind : buildingKinds())
    if (kind.name == at.kind) {
      Building building = kind.make(random);
      if (at.variant == GuardVariant::MovedFurniture)
        addFurniture(building, 20, true, random);
      Laser laser;
      laser.reach = building.reach;
      return scanBuilding(building, laser, random);
    }
  static const std::vector<RectificationMap> logs = makeLogMaps();
  for (const RectificationMap& log : logs)
    if (log.name == at.kind)
      return log;
  throw std::invalid_argument("no such kind of building: " + at.kind);
}

} // namespace

std::string
nameOf(GuardVariant variant)
{
  constexpr const char* names[] = {"plain",
                                   "thinned scans",
                                   "short rays",
                                   "moved furniture",
                                   "noise told / 3",
                                   "noise told x 3",
                                   "heavy tails",
                                   "bias"};
  return names[static_cast<int>(variant)];
}

double
driftLevelOf(std::uint64_t seed)
{
  constexpr double levels[] = {0.5, 1, 2, 4, 8};
  return levels[seed % 5];
}

GuardVariant
variantOf(std::uint64_t seed)
{
  return static_cast<GuardVariant>(seed / 5 % 8);
}

GuardCase
makeGuardCase(const std::string& kind, std::uint64_t seed)
{
  GuardCase made;
  made.kind = kind;
  made.seed = seed;
  made.level = driftLevelOf(seed);
  made.variant = variantOf(seed);
  std::uint64_t code = seed;
  for (const char letter : kind)
    code = 31 * code + static_cast<unsigned char>(letter);
  Random random(code);
  made.map = mapOf(made, random);
  made.map.name = kind;
  if (made.variant == GuardVariant::ThinnedScans)
    keepEverySecondScan(made.map);
  if (made.variant == GuardVariant::ShortRays)
    shortenRays(made.map);
  made.given = odometryOf(made, random);
  made.told = noiseToldTo(made.variant);
  return made;
}

} // namespace pcl::acmap::bench
