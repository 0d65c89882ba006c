#include "truth_file.h"

#include <pcl/core/build_config.h>
#include <pcl/core/file_format.h>
#include <pcl/core/output_file.h>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

Json
jsonOf(const Eigen::Vector3d& point)
{
  return {point.x(), point.y(), point.z()};
}

Json
jsonOf(const TruthPlane& plane, std::size_t id, std::size_t points)
{
  Json rectangles = Json::array();
  for (const SimulatedRectangle& r : plane.rectangles)
    rectangles.push_back({jsonOf(r.corner),
                          jsonOf(r.corner + r.edge_u),
                          jsonOf(r.corner + r.edge_u + r.edge_v),
                          jsonOf(r.corner + r.edge_v)});
  const Eigen::Vector4d& c = plane.coefficients;
  return {{"id", id},
          {"name", plane.name},
          {"coefficients", {c[0], c[1], c[2], c[3]}},
          {"area", plane.area()},
          {"points", points},
          {"rectangles", rectangles}};
}

} // namespace

Json
truthHead(const SimulatedScene& scene, std::uint64_t seed, std::size_t observations)
{
  return {{"version", ACMAP_VERSION},
          {"format", file_formats::truth},
          {"scene", scene.name},
          {"seed", seed},
          {"observations", observations}};
}

Json
truthPlanes(const SimulatedScene& scene, const PointCounts& counts)
{
  Json json = Json::array();
  const std::vector<TruthPlane> planes = planesInMap(scene);
  for (std::size_t id = 0; id < planes.size(); ++id)
    json.push_back(jsonOf(planes[id], id, counts.of_label[id + 1]));
  return json;
}

void
saveTruth(const std::string& path, const Json& truth)
{
  const std::string text =
      truth.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
  OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

} // namespace pcl::acmap
