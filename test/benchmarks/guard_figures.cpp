#include "bench.h"
#include "guard_buildings.h"
#include "rectification_runs.h"

#include <pcl/core/planar_scan.h>
#include <pcl/simulation/standard_scenes.h>

#include <atomic>
#include <cstdlib>
#include <functional>
#include <future>
#include <set>

namespace pcl::acmap::bench {
namespace {

/** What is unusual about a run. */
enum class GuardVariant {
  Plain,
  ThinnedScans,   ///< every second scan, and every second beam of it
  ShortRays,      ///< 5 m at most
  MovedFurniture, ///< some boxes are there during one half of the recording only
  ToldTooSmall,   ///< the odometry's noise is stated as a third of the usual one
  ToldTooLarge,   ///< as three times the usual one
  HeavyTails,     ///< one action in ten has four times the noise
  Bias            ///< turns are biased by four times as much, and lengths by 3 %
};

/** A planar laser over 180 degrees. */
struct Laser {
  int beams = 180;
  double reach = 20;   ///< metres
  double noise = 0.01; ///< metres, along a beam
  double lost = 0.01;  ///< share of the beams without an echo
};

/** Range of the nearest wall along a beam, metres; infinite if there is none. */
double
rangeOf(const std::vector<BuildingWall>& walls, const PlanarPose& from, double angle)
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
    if (range > 0 && share >= 0 && share <= 1)
      nearest = std::min(nearest, range);
  }
  return nearest;
}

std::vector<BuildingWall>
wallsDuring(const Building& building, WallTime half)
{
  std::vector<BuildingWall> walls;
  for (const BuildingWall& wall : building.walls)
    if (wall.time == WallTime::Always || wall.time == half)
      walls.push_back(wall);
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
    double range = rangeOf(walls, pose, angle) + laser.noise * random.normal();
    if (random.uniform() < laser.lost || !(range < laser.reach))
      range = laser.reach + 1;
    scan.ranges.push_back(static_cast<float>(range));
  }
  return scan;
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
    map.add(scanFrom(walls[2 * i < poses ? 0 : 1], building.path[i], laser, random),
            building.path[i]);
  return map;
}

/** Keeps every Nth scan, and of them the points for which \a keeps (point, number). */
template <typename Keeps>
RectificationMap
thinned(const RectificationMap& map, std::size_t every, const Keeps& keeps)
{
  RectificationMap thin;
  for (std::size_t i = 0; i < map.clouds.size(); i += every) {
    thin.truth.push_back(map.truth[i]);
    thin.clouds.emplace_back(new PointCloud<PointNormal>);
    std::vector<float>& weights = thin.weights.emplace_back();
    for (std::size_t p = 0; p < map.clouds[i]->size(); ++p)
      if (keeps((*map.clouds[i])[p], p)) {
        thin.clouds.back()->push_back((*map.clouds[i])[p]);
        weights.push_back(map.weights[i][p]);
      }
  }
  return thin;
}

const std::vector<RectificationMap>&
logs()
{
  static const std::vector<RectificationMap> maps = makeLogMaps();
  return maps;
}

const std::vector<RectificationMap>&
scenes()
{
  static const std::vector<RectificationMap> maps = [] {
    std::vector<RectificationMap> made;
    for (const char* name : {"corridor", "l_corridor", "loop"})
      made.push_back(makeSceneMap(standardScene(name)));
    return made;
  }();
  return maps;
}

/** \param[in] kind of a building, or the name of a log or of a scene */
RectificationMap
mapOf(const std::string& kind, GuardVariant variant, Random& random)
{
  std::vector<BuildingKind> kinds = buildingKinds();
  kinds.insert(kinds.end(), lookalikeKinds().begin(), lookalikeKinds().end());
  for (const BuildingKind& of_building : kinds)
    if (of_building.name == kind) {
      Building building = of_building.make(random);
      if (variant == GuardVariant::MovedFurniture)
        addFurniture(building, 20, true, random);
      Laser laser;
      laser.reach = building.reach;
      return scanBuilding(building, laser, random);
    }
  for (const RectificationMap& scene : scenes())
    if (scene.name == kind)
      return scene;
  return *std::find_if(
      logs().begin(), logs().end(), [&](auto& log) { return log.name == kind; });
}

/** A map with wrong poses, of which the guard judged the rectification. */
struct GuardRun {
  std::string kind; ///< of the building, or the name of a log
  std::uint64_t seed = 1;
  double level = 1; ///< factor of the usual drift
  RectificationRun run;
  double candidate = 0; ///< metres, aligned error of the poses that the verdict judged

  /** Is the map worse than before? Errors below half a bin, 0.05 m, are within the
   * accuracy of any map made of such bins: a map with less is as good as another.
   * \param[in] factor by which the error has to grow */
  bool
  isWorse(double factor = 1) const
  {
    constexpr double half_bin = 0.05; // metres
    return run.after.unaligned > factor * run.before.unaligned &&
           run.after.unaligned > half_bin;
  }
};

/** Makes and rectifies one map. Drift and variant follow from the seed: forty successive
 * seeds have each combination of five levels and eight variants. */
void
runCase(GuardRun& made)
{
  constexpr double levels[] = {0.5, 1, 2, 4, 8};
  made.level = levels[made.seed % 5];
  const auto variant = static_cast<GuardVariant>(made.seed / 5 % 8);
  std::uint64_t code = made.seed;
  for (const char letter : made.kind)
    code = 31 * code + static_cast<unsigned char>(letter);
  Random random(code);
  RectificationMap map = mapOf(made.kind, variant, random);
  if (variant == GuardVariant::ThinnedScans)
    map = thinned(map, 2, [](auto&, std::size_t p) { return p % 2 == 0; });
  if (variant == GuardVariant::ShortRays)
    map = thinned(
        map, 1, [](auto& point, auto) { return point.getVector3fMap().norm() < 5; });
  DriftModel drift = robotDrift(made.level);
  const bool is_biased = variant == GuardVariant::Bias;
  const double sign = random.uniform() < 0.5 ? -1 : 1;
  drift.is_heavy_tailed = variant == GuardVariant::HeavyTails;
  drift.turn_bias *= (is_biased ? 4 : 1) * sign;
  drift.length_scale = is_biased ? 1 + 0.03 * made.level * sign : 1;
  const double told = variant == GuardVariant::ToldTooSmall   ? 1.0 / 3
                      : variant == GuardVariant::ToldTooLarge ? 3.0
                                                              : 1.0;
  const std::vector<PlanarPose> truth = map.truth;
  made.run = rectifyMap(
      map, drifted(map.truth, drift, random), [&](Rectification& rectification) {
        OdometryNoise noise;
        for (double* part : {&noise.length,
                             &noise.length_per_metre,
                             &noise.turn,
                             &noise.turn_per_radian})
          *part *= told;
        rectification.setOdometryNoise(noise);
      });
  made.candidate = made.run.after.aligned;
  if (!made.run.report.refused_poses.empty())
    made.candidate =
        absoluteTrajectoryError(made.run.report.refused_poses, truth).aligned;
}

using GuardRuns = std::vector<GuardRun>;

/** Runs each kind with some seeds, two runs at a time. */
GuardRuns
runKinds(const std::vector<std::string>& kinds, std::uint64_t first_seed = 1)
{
  const char* const told = std::getenv("ACMAP_GUARD_RUNS");
  const std::uint64_t number = told ? std::strtoull(told, nullptr, 10) : 40;
  GuardRuns runs;
  for (std::uint64_t seed = first_seed; seed < first_seed + number; ++seed)
    for (const std::string& kind : kinds)
      runs.push_back({kind, seed, 1, {}});
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < runs.size(); i = next++)
      runCase(runs[i]);
  };
  const auto other = std::async(std::launch::async, work);
  work();
  return runs;
}

std::size_t
countOf(const GuardRuns& runs, const std::function<bool(const GuardRun&)>& is)
{
  return static_cast<std::size_t>(std::count_if(runs.begin(), runs.end(), is));
}

std::size_t
countOf(const GuardRuns& runs, RectificationOutcome outcome)
{
  return countOf(runs, [=](auto& one) { return one.run.report.outcome == outcome; });
}

void
printRuns(const std::string& name, const GuardRuns& runs)
{
  const auto ratios = valuesOf(runs, [](auto& one) { return one.run.ratio(); });
  const auto seconds = valuesOf(runs, [](auto& one) { return one.run.seconds; });
  std::vector<double> accepted;
  for (const GuardRun& one : runs)
    if (one.run.report.outcome == RectificationOutcome::Rectified)
      accepted.push_back(one.run.ratio());
  const std::size_t refused = countOf(runs, RectificationOutcome::Refused);
  Row() << name << runs.size()
        << atMost(countOf(runs, [](auto& one) { return one.isWorse(); }), 0, 0)
        << countOf(runs, [](auto& one) { return one.isWorse(1.05); }) << refused
        << figure(percent(refused, runs.size()), 1)
        << countOf(runs, RectificationOutcome::Kept) << figure(median(ratios), 3)
        << figure(quantile(ratios, 0.9), 3) << figure(largest(accepted), 3)
        << figure(median(seconds), 1) << figure(largest(seconds), 1);
}

/** One row for each value of a property of the runs. */
template <typename Property>
void
printBy(const std::string& name, const GuardRuns& runs, const Property& property)
{
  std::set<decltype(property(runs.front()))> values;
  for (const GuardRun& one : runs)
    values.insert(property(one));
  for (const auto& value : values) {
    GuardRuns some;
    for (const GuardRun& one : runs)
      if (property(one) == value)
        some.push_back(one);
    std::ostringstream title;
    title << name << value;
    printRuns(title.str(), some);
  }
}

void
printGroup(const std::vector<std::string>& kinds)
{
  const GuardRuns runs = runKinds(kinds);
  if (runs.empty())
    return;
  printHead("runs with | runs | accepted, worse than before | by 5 % | refused | % | "
            "kept | ratio, median | 90 % | worst accepted | CPU s, median | most");
  printRuns("all", runs);
  printBy("", runs, [](const GuardRun& one) { return one.kind; });
  printBy("drift x ", runs, [](const GuardRun& one) { return one.level; });
  std::cout << "\nAccepted and worse than before, or refused:\n\n";
  for (const GuardRun& one : runs)
    if (one.isWorse() || one.run.report.outcome == RectificationOutcome::Refused)
      std::cout << "- " << one.kind << ' ' << one.seed << ": drift x " << one.level
                << ", " << nameOf(one.run.report.outcome) << ", "
                << one.run.before.unaligned << " m before, " << one.run.after.unaligned
                << " m after, aligned " << one.run.before.aligned << " and "
                << one.run.after.aligned << " m\n";
}

const Section held_out_section("held_out", [] {
  std::vector<std::string> kinds;
  for (const BuildingKind& kind : buildingKinds())
    kinds.push_back(kind.name);
  printGroup(kinds);
});

/** Is a trajectory worse than before, as the verdict has it? */
bool
isWorseAligned(const GuardRun& one)
{
  return one.candidate > 1.1 * one.run.before.aligned + 0.05;
}

bool
isAccepted(const GuardRun& one)
{
  return one.run.report.outcome == RectificationOutcome::Rectified;
}

void
printVerdicts(const std::string& name, const GuardRuns& runs)
{
  const auto ofOutcome = [&](const auto& is, VerdictOutcome outcome) {
    return countOf(runs, [&](const GuardRun& one) {
      return is(one) && one.run.report.verdict &&
             one.run.report.verdict->outcome == outcome;
    });
  };
  const auto isBetter = [](const GuardRun& one) {
    return one.candidate < 0.5 * one.run.before.aligned;
  };
  const std::size_t better = countOf(runs, isBetter);
  const std::size_t accepted = countOf(
      runs, [&](const GuardRun& one) { return isBetter(one) && isAccepted(one); });
  const std::size_t within = countOf(runs, [](const GuardRun& one) {
    return one.run.report.verdict &&
           one.candidate <= one.run.report.verdict->e95 + 0.03;
  });
  const std::size_t judged = countOf(
      runs, [](const GuardRun& one) { return one.run.report.verdict.has_value(); });
  Row() << name << runs.size()
        << atMost(countOf(
                      runs,
                      [](auto& one) { return isAccepted(one) && isWorseAligned(one); }),
                  0,
                  0)
        << countOf(runs, isWorseAligned)
        << ofOutcome(isWorseAligned, VerdictOutcome::Contradicted)
        << ofOutcome(isWorseAligned, VerdictOutcome::Undetermined) << better
        << figure(percent(accepted, better), 1)
        << ofOutcome(isBetter, VerdictOutcome::Contradicted)
        << ofOutcome(isBetter, VerdictOutcome::Undetermined)
        << figure(percent(within, judged), 1);
}

void
printVerdictsOf(const std::vector<std::string>& kinds)
{
  const char* const told = std::getenv("ACMAP_GUARD_SEED");
  const std::uint64_t first_seed = told ? std::strtoull(told, nullptr, 10) : 81;
  const GuardRuns runs = runKinds(kinds, first_seed);
  printHead(
      "runs with | runs | worse and accepted | worse | contradicted | undetermined | "
      "better | accepted, % | contradicted | undetermined | within e95, %");
  printVerdicts("all", runs);
  for (const std::string& kind : kinds) {
    GuardRuns some;
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(some), [&](auto& one) {
      return one.kind == kind;
    });
    printVerdicts(kind, some);
  }
  const auto seconds = valuesOf(runs, [](auto& one) { return one.run.seconds; });
  std::cout << "\nCPU: median " << median(seconds) << " s, most " << largest(seconds)
            << " s. Worse and accepted, or better and not accepted:\n\n";
  for (const GuardRun& one : runs)
    if ((isAccepted(one) && isWorseAligned(one)) ||
        (!isAccepted(one) && one.candidate < 0.5 * one.run.before.aligned)) {
      std::cout << "- " << one.kind << ' ' << one.seed << ": drift x " << one.level
                << ", " << nameOf(one.run.report.outcome) << ", "
                << one.run.before.aligned << " m before, " << one.candidate
                << " m found";
      if (one.run.report.verdict)
        for (const std::string& reason : one.run.report.verdict->reasons)
          std::cout << "; " << reason;
      std::cout << '\n';
    }
}

const Section verdict_section("verdict", [] {
  std::vector<std::string> kinds;
  for (const auto* all : {&buildingKinds(), &lookalikeKinds()})
    for (const BuildingKind& kind : *all)
      kinds.push_back(kind.name);
  printVerdictsOf(kinds);
});

const Section space_section("space", [] {
  std::vector<std::string> names;
  for (const RectificationMap& scene : scenes())
    names.push_back(scene.name);
  printVerdictsOf(names);
});

const Section logs_section("logs", [] {
  std::vector<std::string> names;
  for (const RectificationMap& log : logs())
    names.push_back(log.name);
  printGroup(names);
});

} // namespace
} // namespace pcl::acmap::bench
