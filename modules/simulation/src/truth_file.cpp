#include <pcl/core/build_config.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/file_format.h>
#include <pcl/core/impl/json_text.h>
#include <pcl/simulation/truth_file.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace pcl {

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

/** The first fields of every truth. */
Json
headOf(const SimulatedScene& scene, std::uint64_t seed, std::size_t observations)
{
  return {{"version", ACMAP_VERSION},
          {"format", acmap::file_formats::truth},
          {"scene", scene.name},
          {"seed", seed},
          {"observations", observations}};
}

/** The true planes in the map frame. */
Json
planesOf(const SimulatedScene& scene, const TruthPoints& points)
{
  Json json = Json::array();
  const std::vector<TruthPlane> planes = planesInMap(scene);
  if (points.of_label.size() != planes.size() + 1)
    throw acmap::BadArgument("the points are of ",
                             points.of_label.size(),
                             " labels, and the scene has ",
                             planes.size(),
                             " planes");
  for (std::size_t id = 0; id < planes.size(); ++id)
    json.push_back(jsonOf(planes[id], id, points.of_label[id + 1]));
  return json;
}

void
addSensor(const SimulatedScene& scene, Json& json)
{
  const RangeSensor& sensor = scene.sensor;
  if (!scene.depth_camera) {
    json["reach"] = sensor.reach;
    json["noise"] = {{"along", "ray"},
                     {"growth", sensor.noise_growth},
                     {"least", sensor.min_noise},
                     {"most", sensor.max_noise}};
    return;
  }
  const DepthCamera& camera = *scene.depth_camera;
  json["sensor"] = "kinect";
  json["reach"] = camera.farthest;
  json["noise"] = {{"along", "disparity"},
                   {"sigma", scene.rig.disparity_sigma},
                   {"step", camera.disparity_step},
                   {"window", camera.window}};
}

bool
isMeasurable(const SimulatedTruth& truth, std::size_t pixel)
{
  constexpr int neighbours =
      SimulatedTruth::in_horizontal | SimulatedTruth::in_vertical;
  return (truth.visible[pixel] & neighbours) != 0 &&
         (truth.visible[pixel] & SimulatedTruth::in_light) != 0;
}

} // namespace

void
addMeasurable(const SimulatedScene& scene,
              const SimulatedTruth& truth,
              double nearest,
              double farthest,
              TruthPoints& points)
{
  const TrinocularRig& rig = scene.rig;
  const bool has_horizontal = !truth.horizontal.values.empty();
  const DisparityImage& disparities =
      has_horizontal ? truth.horizontal : truth.vertical;
  const double baseline =
      has_horizontal ? rig.baseline_horizontal : rig.baseline_vertical;
  for (std::size_t i = 0; i < disparities.values.size(); ++i) {
    if (!isMeasurable(truth, i))
      continue;
    const double depth = rig.focal_length * std::abs(baseline) / disparities.values[i];
    if (!(depth >= nearest && depth <= farthest))
      continue;
    const auto surface = static_cast<std::size_t>(truth.surfaces[i]);
    ++points.all;
    ++points.of_label.at(
        static_cast<std::size_t>(scene.geometry.surfaces()[surface].plane + 1));
  }
}

void
saveFrameTruth(const std::string& path,
               const SimulatedScene& scene,
               const FramesOfTruth& frames,
               const TruthPoints& points)
{
  const SimulatedLight& light = frames.light;
  Json json = headOf(scene, frames.seed, frames.observations);
  json["patterns"] = frames.patterns;
  json["lines"] = frames.lines;
  json["frames"] = frames.are_raw ? "raw" : "rectified";
  json["light"] = {{"ambient", light.ambient},
                   {"projector_power", light.projector.power},
                   {"aperture", light.projector.aperture_radius},
                   {"exposure", light.exposure},
                   {"blur", light.blur},
                   {"vignetting", light.vignetting}};
  json["noise"] = {{"read", light.read_noise}, {"shot", light.shot_noise}};
  json["points"] = points.all;
  json["planes"] = planesOf(scene, points);
  acmap::saveJson(path, json, 1);
}

void
saveCloudTruth(const std::string& path,
               const SimulatedScene& scene,
               const SimulatedScene& building,
               std::uint64_t seed,
               std::size_t observations,
               const TruthPoints& points)
{
  Json json = headOf(scene, seed, observations);
  json["points"] = points.all;
  addSensor(scene, json);
  json["planes"] = planesOf(building, points);
  acmap::saveJson(path, json, 1);
}

} // namespace pcl
