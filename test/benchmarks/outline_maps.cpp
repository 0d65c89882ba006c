#include "outline_maps.h"

#include "cpu_time.h"
#include "outline_picture.h"
#include "simulated_clouds.h"

#include <pcl/core/map_file.h>
#include <pcl/pipeline/plane_mapping.h>

#include <limits>

namespace pcl::acmap::bench {

JudgedCloud
observeScene(const SimulatedScene& scene)
{
  const SimulatedCloud all = makeSceneCloud(scene);
  const auto file = std::make_shared<PointCloudFile>();
  file->cloud = cloudOf(all.merged);
  return {file, all.sensorOrigins()};
}

JudgedMap
readJudgedMap(const std::string& name, const OutlineOptions& options)
{
  return {loadMapFile(options.from + "/" + name + ".json").planes,
          std::numeric_limits<double>::quiet_NaN()};
}

JudgedMap
findJudgedMap(const JudgedCloud& cloud)
{
  PlaneMapping mapping;
  mapping.setInputCloud(cloud.cloud);
  mapping.setViewpoints(cloud.viewpoints);
  double begin = 0, seconds = 0; // wall time would tell of the machine's other load
  bool is_outlining = false;
  mapping.setProgressCallback([&](double, const std::string& step) {
    if (is_outlining)
      seconds += processSeconds() - begin;
    is_outlining = step == "outlines";
    begin = processSeconds();
    return true;
  });
  MappedPlanes found;
  mapping.compute(found);
  return {std::move(found.planes), seconds};
}

void
keepJudgedMap(const std::string& name,
              const OutlineOptions& options,
              const JudgedMap& map)
{
  if (!options.save.empty()) {
    CompactMap saved;
    saved.planes = map.planes;
    saveMapFile(options.save + "/" + name + ".json", saved);
  }
  if (!options.pictures.empty())
    saveOutlinePicture(options.pictures + "/" + name + ".png", map.planes);
}

} // namespace pcl::acmap::bench
