#include "rectification_maps.h"

#include "simulated_clouds.h"
#include "test_data.h"
#include "timing.h"

#include <pcl/core/carmen_log.h>
#include <pcl/simulation/standard_scenes.h>

#include <iostream>

namespace pcl::acmap::bench {
namespace {

/** A log of which every Nth scan is used. */
struct LogPart {
  std::string name;
  std::size_t every;
};

RectificationMap
makeLogMap(const LogPart& part, const std::string& path)
{
  const CarmenLog log = loadCarmenLog(path);
  RectificationMap map;
  map.name = part.name;
  for (std::size_t i = 0; i < log.scans.size(); i += part.every) {
    PlanarScanPoints points = pointsOf(log.scans[i]);
    map.clouds.push_back(std::move(points.cloud));
    map.weights.push_back(std::move(points.weights));
    map.truth.push_back(log.scans[i].pose);
  }
  return map;
}

std::vector<RectificationMap>
makeMaps(const std::vector<LogPart>& parts)
{
  std::vector<RectificationMap> maps;
  for (const LogPart& part : parts) {
    const std::string file = "C_sequence/carmen2d/" + part.name + "-corrected.log.gz";
    if (test::hasTestData(file))
      maps.push_back(makeLogMap(part, test::testDataPath(file).string()));
    else
      std::cerr << file << " is not there\n";
  }
  return maps;
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

std::vector<RectificationMap>
makeLogMaps()
{
  return makeMaps({{"intel", 4}, {"csail", 2}, {"orebro", 1}});
}

std::vector<RectificationMap>
makeLongLogMaps()
{
  return makeMaps({{"infinite-corridor", 9}});
}

RectificationMap
makeSceneMap(const SimulatedScene& scene)
{
  constexpr double voxel = 0.06; // metres
  constexpr double usual = 0.05; // metres; a voxel of this size has weight 1
  constexpr float weight = voxel * voxel / (usual * usual);
  RectificationMap map;
  map.name = scene.name;
  map.bin_size = 0.05;
  for (std::size_t view = 0; view < scene.views.size(); ++view) {
    const SimulatedCloud seen = makeViewCloud(scene, view);
    Consolidation consolidation;
    ConsolidationReport report;
    const Cost cost =
        measureCost([&] { consolidation = consolidate(seen, voxel, report); });
    map.consolidation_seconds += cost.cpu;
    map.clouds.push_back(cloudOf(consolidation));
    map.weights.emplace_back(map.clouds.back()->size(), weight);
    map.truth.push_back(planarPartOf(scene.views[view]));
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

} // namespace pcl::acmap::bench
