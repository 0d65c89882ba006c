#include "merged_map.h"

#include "map_rows.h"

#include <pcl/core/cloud_fields.h>

namespace pcl::acmap {

SensorView
MergedMap::sensors() const
{
  const PCLPointField* const view = findField(file.cloud, "view");
  return SensorView(
      file.cloud.data.data() + view->offset, file.cloud.point_step, viewpoints);
}

MergedMap
mergeObservations(Tool& tool,
                  const ObservationSequence& sequence,
                  DepthSensor sensor,
                  bool skip_broken,
                  std::size_t most_points)
{
  MergedMap map;
  MapRows rows(0, true);
  rows.setMost(most_points);
  std::vector<std::string> remarks = sequence.remarks();
  std::vector<Eigen::Isometry3d> poses;
  tool.withProgress([&](const ProgressCallback& callback) {
    const Progress progress(callback);
    for (std::size_t i = 0; i < sequence.size(); ++i) {
      progress.tell(static_cast<double>(i) / static_cast<double>(sequence.size()),
                    "reading");
      try {
        const PosedObservation seen = sequence.load(i);
        remarks.insert(remarks.end(), seen.remarks.begin(), seen.remarks.end());
        PointCloudFile file = *seen.file;
        map.refined += refineIfQuantised(file, sensor, tool.threads()) ? 1 : 0;
        rows.append(
            file, seen.T_map_camera, static_cast<std::int32_t>(map.viewpoints.size()));
        poses.push_back(seen.T_map_camera);
        map.viewpoints.push_back(seen.T_map_camera.translation().cast<float>());
        ++map.observations;
      }
      catch (const InputFileException& error) {
        if (!skip_broken)
          throw;
        remarks.push_back("left out: " + std::string(error.what()));
      }
    }
  });
  for (const std::string& remark : remarks)
    tool.warn(remark);
  if (map.observations == 0)
    throw InputFileException("none of the observations can be read");
  sequence.requireDifferent(poses);
  if (rows.every() > 1)
    tool.warn("the map has more than " + std::to_string(most_points) +
              " points (--max-points): it is made of each " +
              std::to_string(rows.every()) + "th of them");
  map.file.cloud = rows.finish();
  return map;
}

PCLPointCloud2
thinned(const PCLPointCloud2& map)
{
  constexpr std::size_t most = 1000000;
  const std::size_t points = std::size_t{map.width} * map.height;
  return everyNth(map, points / most + 1);
}

} // namespace pcl::acmap
