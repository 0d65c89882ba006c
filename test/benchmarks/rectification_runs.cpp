#include "rectification_runs.h"

#include "bench.h"
#include "bench_data.h"
#include "simulated_clouds.h"

#include <pcl/core/carmen_log.h>
#include <pcl/core/random.h>
#include <pcl/simulation/standard_scenes.h>

namespace pcl::acmap::bench {

namespace {

/** \param[in] every of which of its scans one is used */
void
addLog(const std::string& name, std::size_t every, std::vector<RectificationMap>& maps)
{
  const auto path = pathOfData("C_sequence/carmen2d/" + name + "-corrected.log.gz");
  if (!path)
    return;
  const CarmenLog log = loadCarmenLog(*path);
  RectificationMap& map = maps.emplace_back();
  map.name = name;
  for (std::size_t i = 0; i < log.scans.size(); i += every)
    map.add(log.scans[i], log.scans[i].pose);
}

PointCloud<PointNormal>::Ptr
cloudOf(const Consolidation& consolidation)
{
  const auto cloud = std::make_shared<PointCloud<PointNormal>>();
  cloud->reserve(consolidation.representatives.size());
  for (const Representative& representative : consolidation.representatives) {
    PointNormal point;
    point.getVector3fMap() = representative.point;
    point.getNormalVector3fMap() = representative.normal;
    point.curvature = representative.curvature;
    cloud->push_back(point);
  }
  return cloud;
}

} // namespace

void
RectificationMap::add(const PlanarScan& scan, const PlanarPose& pose)
{
  PlanarScanPoints points = pointsOf(scan);
  clouds.push_back(std::move(points.cloud));
  weights.push_back(std::move(points.weights));
  truth.push_back(pose);
}

void
RectificationMap::addView(const PointView& points,
                          const SensorView& sensors,
                          const PlanarPose& pose)
{
  constexpr double voxel = 0.06; // metres
  constexpr double usual = 0.05; // metres; a voxel of this size has weight 1
  ConsolidationSettings settings;
  settings.voxel_size = voxel;
  settings.threads = 1;
  ConsolidationReport report;
  clouds.push_back(cloudOf(
      consolidatePoints(points, sensors, ColorView(), settings, Progress(), report)));
  weights.emplace_back(clouds.back()->size(),
                       static_cast<float>(voxel * voxel / (usual * usual)));
  truth.push_back(pose);
  bin_size = 0.05;
}

std::vector<RectificationMap>
makeLogMaps()
{
  std::vector<RectificationMap> maps;
  addLog("intel", 4, maps);
  addLog("csail", 2, maps);
  addLog("orebro", 1, maps);
  return maps;
}

std::vector<RectificationMap>
makeLongLogMaps()
{
  std::vector<RectificationMap> maps;
  addLog("infinite-corridor", 9, maps);
  return maps;
}

RectificationMap
makeSceneMap(const SimulatedScene& scene)
{
  RectificationMap map;
  map.name = scene.name;
  for (std::size_t view = 0; view < scene.views.size(); ++view) {
    const SimulatedCloud seen = makeViewCloud(scene, view);
    map.addView(seen.points(), seen.sensors(), planarPartOf(scene.views[view]));
  }
  return map;
}

SimulatedScene
bareCorridor()
{
  constexpr std::size_t views = 40;
  constexpr double step = 0.6, look_aside = M_PI / 6; // metres, radians
  constexpr double begin = -10, length = 50, half = 1.2, floor = 1.25, ceiling = -1.45;
  const Eigen::Vector3d across(2 * half, 0, 0), along(0, 0, length);
  const Eigen::Vector3d up(0, ceiling - floor, 0);
  SimulatedScene scene = standardScene("corridor");
  scene.name = "bare corridor";
  SceneGeometry& geometry = scene.geometry = SceneGeometry();
  geometry.addRectangle("floor", "floor", {{-half, floor, begin}, across, along}, {});
  geometry.addRectangle(
      "ceiling", "ceiling", {{-half, ceiling, begin}, along, across}, {});
  geometry.addRectangle("left", "left", {{-half, floor, begin}, along, up}, {});
  geometry.addRectangle(
      "right", "right", {{half, floor, begin + length}, -along, up}, {});
  scene.views.clear();
  for (std::size_t view = 0; view < views; ++view)
    scene.views.push_back(isometryOf({0,
                                      step * static_cast<double>(view),
                                      view % 2 == 0 ? look_aside : -look_aside}));
  return scene;
}

DriftModel
robotDrift(double level)
{
  return {0.002 * level, 0.02 * level, 0.004 * level, 0.01 * level, 0.0015 * level};
}

DriftModel
cameraDrift()
{
  DriftModel drift;
  drift.length_per_metre = 0.01;
  drift.turn = 0.2 * degree;
  return drift;
}

std::vector<PlanarPose>
drifted(const std::vector<PlanarPose>& truth, const DriftModel& drift, Random& random)
{
  std::vector<PlanarPose> poses{truth.front()};
  for (std::size_t i = 1; i < truth.size(); ++i) {
    PlanarAction action = actionBetween(truth[i - 1], truth[i]);
    const double factor = drift.is_heavy_tailed && random.uniform() < 0.1 ? 4 : 1;
    const double way = std::hypot(action.dx, action.dz);
    const double length = factor * (drift.length + drift.length_per_metre * way);
    const double turn =
        factor * (drift.turn + drift.turn_per_radian * std::abs(action.dtheta));
    action.dx = drift.length_scale * action.dx + length * random.normal();
    action.dz = drift.length_scale * action.dz + length * random.normal();
    action.dtheta += turn * random.normal() + drift.turn_bias;
    poses.push_back(moved(poses.back(), action));
  }
  return poses;
}

std::vector<PlanarPose>
drifted(const std::vector<PlanarPose>& truth,
        const DriftModel& drift,
        std::uint64_t seed)
{
  Random random(seed);
  return drifted(truth, drift, random);
}

RectificationRun
rectifyMap(const RectificationMap& map,
           const std::vector<PlanarPose>& given,
           const std::function<void(Rectification&)>& configure)
{
  Rectification rectification;
  rectification.setNumberOfThreads(1);
  rectification.setBinSize(map.bin_size);
  if (configure)
    configure(rectification);
  for (std::size_t i = 0; i < map.clouds.size(); ++i)
    rectification.addPointCloud(map.clouds[i], isometryOf(given[i]), map.weights[i]);
  RectificationRun run;
  run.name = map.name;
  run.given = given;
  run.seconds = measureThread([&] { rectification.compute(); });
  for (std::size_t i = 0; i < given.size(); ++i)
    run.found.push_back(planarPartOf(rectification.getPose(i)));
  run.report = rectification.getReport();
  run.before = absoluteTrajectoryError(given, map.truth);
  run.after = absoluteTrajectoryError(run.found, map.truth);
  return run;
}

std::vector<Eigen::Isometry3d>
isometriesOf(const std::vector<PlanarPose>& poses)
{
  std::vector<Eigen::Isometry3d> result;
  for (const PlanarPose& pose : poses)
    result.push_back(isometryOf(pose));
  return result;
}

std::vector<PlanarPose>
planarPartsOf(const std::vector<Eigen::Isometry3d>& poses)
{
  std::vector<PlanarPose> result;
  for (const Eigen::Isometry3d& pose : poses)
    result.push_back(planarPartOf(pose));
  return result;
}

Eigen::Isometry3d
motionOf(const Eigen::Matrix4f& matrix)
{
  Eigen::Isometry3d motion(matrix.cast<double>());
  motion.linear() = Eigen::Quaterniond(motion.linear()).normalized().toRotationMatrix();
  return motion;
}

} // namespace pcl::acmap::bench
