#include "outline_maps.h"

#include "outline_picture.h"

#include <pcl/core/map_file.h>
#include <pcl/pipeline/plane_mapping.h>

#include <limits>

namespace pcl::acmap::bench {

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
  MappedPlanes found;
  mapping.compute(found);
  JudgedMap map{std::move(found.planes), 0};
  const PlaneMappingReport& report = mapping.getReport();
  if (report.planes)
    for (const auto& [step, seconds] : report.planes->seconds)
      if (step == "outlines")
        map.seconds += seconds;
  return map;
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
