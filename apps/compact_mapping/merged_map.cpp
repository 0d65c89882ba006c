#include "merged_map.h"

#include "cloud_fields.h"
#include "memory.h"

namespace pcl::acmap {

namespace {

struct Row {
  float x, y, z;
  std::uint32_t rgb;
  std::int32_t view;
};

PCLPointCloud2
emptyMap()
{
  return layoutWith(PCLPointCloud2(),
                    {{"x", PCLPointField::FLOAT32},
                     {"y", PCLPointField::FLOAT32},
                     {"z", PCLPointField::FLOAT32},
                     {"rgb", PCLPointField::FLOAT32},
                     {"view", PCLPointField::INT32}});
}

void
append(const PosedObservation& seen, std::int32_t view, PCLPointCloud2& map)
{
  const PointView points = seen.file.points();
  const PCLPointField* const color = findColor(seen.file.cloud);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f point = points[i];
    if (!point.allFinite())
      continue;
    const Eigen::Vector3f place =
        (seen.T_map_camera * point.cast<double>()).cast<float>();
    Row row{place.x(), place.y(), place.z(), 0, view};
    if (color)
      std::memcpy(&row.rgb,
                  &seen.file.cloud.data[i * seen.file.cloud.point_step + color->offset],
                  sizeof row.rgb);
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(&row);
    map.data.insert(map.data.end(), bytes, bytes + sizeof row);
  }
}

} // namespace

SensorView
MergedMap::sensors() const
{
  const PCLPointField* const view = findField(file.cloud, "view");
  return SensorView(
      file.cloud.data.data() + view->offset, file.cloud.point_step, viewpoints);
}

MergedMap
mergeObservations(Tool& tool, const PosedFolder& folder, bool skip_broken)
{
  MergedMap map;
  map.file.cloud = emptyMap();
  std::vector<std::string> remarks;
  std::vector<Eigen::Isometry3d> poses;
  tool.withProgress([&](const ProgressCallback& callback) {
    const Progress progress(callback);
    for (std::size_t i = 0; i < folder.size(); ++i) {
      progress.tell(static_cast<double>(i) / static_cast<double>(folder.size()),
                    "reading");
      try {
        const PosedObservation seen = folder.load(i, remarks);
        requireMemory(map.file.cloud.data.size() +
                          seen.file.points().size() * sizeof(Row),
                      "merging the observations");
        append(seen, static_cast<std::int32_t>(map.viewpoints.size()), map.file.cloud);
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
  folder.requireDifferent(poses);
  resizeRows(map.file.cloud, map.file.cloud.data.size() / sizeof(Row));
  return map;
}

} // namespace pcl::acmap
