#include <pcl/core/map_file.h>

#include "map/map_format.h"

#include <pcl/core/build_config.h>
#include <pcl/core/fields.h>
#include <pcl/core/file_format.h>
#include <pcl/core/impl/map_check.h>
#include <pcl/core/map_topology.h>
#include <pcl/core/output_file.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>

namespace pcl {

namespace {

using Json = nlohmann::ordered_json;

/** Converts a float to the double with the same shortest text, so that no digits are
 * written that the float does not have. */
double
shortest(float value)
{
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double same = 0;
  std::from_chars(text.data(), end, same);
  return static_cast<float>(same) == value ? same : value;
}

Json
jsonOf(const Eigen::Vector3d& vector)
{
  return {vector.x(), vector.y(), vector.z()};
}

Json
jsonOf(const Eigen::Vector4d& plane)
{
  return {plane[0], plane[1], plane[2], plane[3]};
}

template <int size>
Json
jsonOf(const Eigen::Matrix<double, size, size>& matrix)
{
  Json rows = Json::array();
  for (int row = 0; row < size; ++row) {
    Json& values = rows.emplace_back(Json::array());
    for (int column = 0; column < size; ++column)
      values.push_back(matrix(row, column));
  }
  return rows;
}

Json
jsonOf(const std::vector<Eigen::Vector3f>& loop)
{
  Json points = Json::array();
  for (const Eigen::Vector3f& p : loop)
    points.push_back({shortest(p.x()), shortest(p.y()), shortest(p.z())});
  return points;
}

Json
jsonOf(const PlanePolygon& polygon)
{
  Json holes = Json::array();
  for (const std::vector<Eigen::Vector3f>& hole : polygon.holes)
    holes.push_back(jsonOf(hole));
  return {{"outer", jsonOf(polygon.outer)}, {"holes", std::move(holes)}};
}

Json
jsonOf(const std::vector<PlanePolygon>& polygons)
{
  Json list = Json::array();
  for (const PlanePolygon& polygon : polygons)
    list.push_back(jsonOf(polygon));
  return list;
}

/** Adds what people call a part, if it is named.
 * \param[in] has_role false: its kind tells what it is */
void
addLabel(const SurfaceLabel& label, bool has_role, Json& json)
{
  if (label.name.empty())
    return;
  json["name"] = label.name;
  if (has_role)
    json["role"] = acmap::nameIn(acmap::surface_role_names, label.role);
  json["size"] = {label.size.x(), label.size.y()};
}

Json
jsonOf(const PlanePatch& plane, std::size_t id)
{
  Json json = {{"id", id},
               {"coefficients", jsonOf(plane.coefficients)},
               {"center", jsonOf(plane.center)},
               {"axes", {jsonOf(plane.axis_u), jsonOf(plane.axis_v)}},
               {"covariance", jsonOf(plane.covariance)},
               {"support", plane.support},
               {"effective_support", plane.effective_support},
               {"rmse", plane.rms},
               {"area", plane.area},
               {"polygons", jsonOf(plane.polygons)}};
  if (!plane.pose_modes.empty()) {
    Json& modes = json["pose_modes"];
    for (const Eigen::Vector3d& mode : plane.pose_modes)
      modes.push_back(jsonOf(mode));
  }
  addLabel(plane.label, true, json);
  return json;
}

Json
jsonOf(const CylinderPatch& cylinder, std::size_t id)
{
  Json json = {{"id", id},
               {"axis_point", jsonOf(cylinder.axis_point)},
               {"axis_direction", jsonOf(cylinder.axis_direction)},
               {"axes", {jsonOf(cylinder.axis_u), jsonOf(cylinder.axis_v)}},
               {"radius", cylinder.radius},
               {"extent", {cylinder.low, cylinder.high}},
               {"arc", cylinder.arc},
               {"hollow", cylinder.is_hollow},
               {"covariance", jsonOf(cylinder.covariance)},
               {"support", cylinder.support},
               {"rmse", cylinder.rms},
               {"area", cylinder.area},
               {"template", cylinder.template_id},
               {"saved_bits", cylinder.saved_bits}};
  addLabel(cylinder.label, true, json);
  return json;
}

Json
jsonOfAxes(const Eigen::Matrix3d& axes)
{
  return {jsonOf(Eigen::Vector3d(axes.col(0))),
          jsonOf(Eigen::Vector3d(axes.col(1))),
          jsonOf(Eigen::Vector3d(axes.col(2)))};
}

Json
jsonOf(const BoxFace& face)
{
  Json json = {{"kind", acmap::nameIn(acmap::box_face_kind_names, face.kind)}};
  if (face.kind != BoxFaceKind::Free)
    json["plane"] = face.plane;
  return json;
}

Json
jsonOf(const BoxPatch& box, std::size_t id)
{
  Json faces = Json::array();
  for (const BoxFace& face : box.faces)
    faces.push_back(jsonOf(face));
  Json json = {{"id", id},
               {"center", jsonOf(box.center)},
               {"axes", jsonOfAxes(box.axes)},
               {"size", jsonOf(box.size)},
               {"faces", std::move(faces)},
               {"template", box.template_id},
               {"covariance", jsonOf(box.covariance)},
               {"saved_bits", box.saved_bits}};
  if (!box.slant.isZero(0))
    json["slant"] = jsonOf(box.slant);
  if (!box.name.empty())
    json["name"] = box.name;
  return json;
}

Json
jsonOf(const RecessPatch& recess, std::size_t id)
{
  Json json = {{"id", id},
               {"center", jsonOf(recess.center)},
               {"axes", jsonOfAxes(recess.axes)},
               {"size", jsonOf(recess.size)},
               {"wall", recess.wall},
               {"leaf", recess.leaf},
               {"reaches_floor", recess.reaches_floor},
               {"template", recess.template_id},
               {"covariance", jsonOf(recess.covariance)},
               {"saved_bits", recess.saved_bits}};
  if (!recess.name.empty())
    json["name"] = recess.name;
  return json;
}

/** Adds size and places of a picture to its description. */
void
addPicture(const TexturePicture& picture, Json& json)
{
  json["width"] = picture.colors.width;
  json["height"] = picture.colors.height;
  const auto place = [&](const char* key, const std::optional<Eigen::Vector2i>& at) {
    if (at)
      json[key] = {at->x(), at->y()};
  };
  place("at", picture.image_place);
  if (picture.halvings > 0)
    json["halvings"] = picture.halvings;
  if (!picture.kinds_image.empty())
    json["kinds"] = picture.kinds_image;
  place("kinds_at", picture.kinds_place);
}

Json
jsonOf(const TextureChart& chart)
{
  Json json = {{"polygon", chart.polygon},
               {"image", chart.image},
               {"origin", jsonOf(chart.origin)},
               {"texel_u", jsonOf(chart.texel_u)},
               {"texel_v", jsonOf(chart.texel_v)}};
  addPicture(chart, json);
  return json;
}

/** A cylinder with its texture, if it has one. */
Json
jsonOfCylinder(const CompactMap& map, std::size_t id)
{
  Json json = jsonOf(map.cylinders[id], id);
  if (map.cylinder_pictures.empty() || map.cylinder_pictures[id].colors.width == 0)
    return json;
  Json& texture = json["texture"];
  texture["image"] = map.cylinder_pictures[id].image;
  addPicture(map.cylinder_pictures[id], texture);
  return json;
}

Json
jsonOf(double stamp, const Eigen::Isometry3d& pose)
{
  Eigen::Quaterniond rotation(pose.linear());
  rotation.normalize();
  if (rotation.w() < 0.0)
    rotation.coeffs() = -rotation.coeffs();
  return {{"stamp", stamp},
          {"position", jsonOf(Eigen::Vector3d(pose.translation()))},
          {"orientation", {rotation.x(), rotation.y(), rotation.z(), rotation.w()}}};
}

/** Charts of each plane in their order. */
std::vector<Json>
chartsOfPlanes(const CompactMap& map)
{
  std::vector<Json> charts(map.planes.size());
  for (const TextureChart& chart : map.charts)
    charts[chart.plane].push_back(jsonOf(chart));
  return charts;
}

/** One plane, or two. */
Json
jsonOfPlanes(const std::array<std::int32_t, 2>& planes)
{
  Json list = {planes[0]};
  if (planes[1] >= 0)
    list.push_back(planes[1]);
  return list;
}

Json
jsonOf(const MapEdge& edge)
{
  Json json = {{"vertices", edge.vertices},
               {"kind", acmap::nameIn(acmap::edge_kind_names, edge.kind)},
               {"planes", jsonOfPlanes(edge.planes)}};
  if (edge.kind == EdgeKind::Arc)
    json["cylinder"] = edge.cylinder;
  return json;
}

Json
jsonOf(const MapFace& face)
{
  return {{"plane", face.plane},
          {"polygon", face.polygon},
          {"outer", face.outer},
          {"holes", face.holes}};
}

Json
jsonOf(const MapRoom& room)
{
  Json json = {{"center", jsonOf(room.center)},
               {"area", room.area},
               {"seen_area", room.seen_area},
               {"planes", room.planes},
               {"openings", room.openings}};
  addLabel(room.label, false, json);
  return json;
}

Json
jsonOf(const MapOpening& opening)
{
  Json json = {{"from", jsonOf(opening.from)},
               {"to", jsonOf(opening.to)},
               {"bottom", opening.bottom},
               {"top", opening.top},
               {"kind", acmap::nameIn(acmap::opening_kind_names, opening.kind)},
               {"planes", jsonOfPlanes(opening.planes)},
               {"rooms", opening.rooms}};
  addLabel(opening.label, false, json);
  return json;
}

using Write = std::function<void(const std::string&)>;

/** Writes one element per line. */
void
writeLines(const Write& write,
           std::size_t count,
           const std::function<Json(std::size_t)>& line)
{
  for (std::size_t i = 0; i < count; ++i)
    write((i ? ",\n" : "\n") + line(i).dump());
}

/** Writes a list under a key. */
template <typename Item>
void
writeList(const Write& write, const char* key, const std::vector<Item>& items)
{
  write("\n],\"" + std::string(key) + "\":[");
  writeLines(write, items.size(), [&](std::size_t i) { return jsonOf(items[i]); });
}

bool
tellsEdges(const std::vector<PlanePatch>& planes)
{
  return std::any_of(planes.begin(), planes.end(), [](const PlanePatch& plane) {
    return std::any_of(plane.polygons.begin(),
                       plane.polygons.end(),
                       [](const PlanePolygon& one) { return !one.edges.empty(); });
  });
}

/** Writes vertices, edges and faces, if the planes tell what is beyond their edges. */
void
writeTopology(const Write& write, const std::vector<PlanePatch>& planes)
{
  if (!tellsEdges(planes))
    return;
  const MapTopology topology = topologyOf(planes);
  write("\n],\"vertices\":[");
  writeLines(write, topology.vertices.size(), [&](std::size_t i) {
    const Eigen::Vector3f& p = topology.vertices[i];
    return Json{shortest(p.x()), shortest(p.y()), shortest(p.z())};
  });
  writeList(write, "edges", topology.edges);
  writeList(write, "faces", topology.faces);
}

bool
hasPlanesAlone(const CompactMap& map)
{
  bool alone = map.charts.empty() && map.cylinders.empty() && map.boxes.empty() &&
               map.recesses.empty() && map.trajectory.poses.empty() &&
               map.rooms.empty() && map.openings.empty() && map.up.isZero(0);
  for (const std::vector<std::int32_t>& seen_from : map.observations)
    alone = alone && seen_from.empty();
  return alone;
}

} // namespace

void
acmap::writeMap(const CompactMap& map, const Write& write)
{
  requireConsistent(map);
  const std::vector<Json> charts = chartsOfPlanes(map);
  write("{\"version\":" + Json(ACMAP_VERSION).dump());
  if (!hasPlanesAlone(map)) // files with only planes are older than the format numbers
    write(",\"format\":" + std::to_string(file_formats::map));
  write(",\"unit\":\"m\",\"frame\":\"of the input\"");
  if (map.exposure != 1)
    write(",\"exposure\":" + Json(map.exposure).dump());
  write(",\"up\":" + (map.up.isZero(0) ? Json() : jsonOf(map.up)).dump());
  if (map.up.isZero(0) && !map.assumed_up.isZero(0))
    write(",\"assumed_up\":" + jsonOf(map.assumed_up).dump());
  write(",\"shift\":" + jsonOf(map.shift).dump());
  write(",\"planes\":[");
  writeLines(write, map.planes.size(), [&](std::size_t id) {
    Json plane = jsonOf(map.planes[id], id);
    if (!map.planes[id].proposed.empty())
      plane["proposed"] = jsonOf(map.planes[id].proposed);
    if (!map.observations.empty() && !map.observations[id].empty())
      plane["observations"] = map.observations[id];
    if (!charts[id].empty())
      plane["charts"] = charts[id];
    return plane;
  });
  if (!map.cylinders.empty()) {
    write("\n],\"cylinders\":[");
    writeLines(write, map.cylinders.size(), [&](std::size_t id) {
      return jsonOfCylinder(map, id);
    });
  }
  if (!map.boxes.empty()) {
    write("\n],\"boxes\":[");
    writeLines(write, map.boxes.size(), [&](std::size_t id) {
      return jsonOf(map.boxes[id], id);
    });
  }
  if (!map.recesses.empty()) {
    write("\n],\"recesses\":[");
    writeLines(write, map.recesses.size(), [&](std::size_t id) {
      return jsonOf(map.recesses[id], id);
    });
  }
  writeTopology(write, map.planes);
  if (!map.rooms.empty() || !map.openings.empty()) {
    writeList(write, "rooms", map.rooms);
    writeList(write, "openings", map.openings);
  }
  if (!map.trajectory.poses.empty()) {
    write("\n],\"trajectory\":[");
    writeLines(write, map.trajectory.poses.size(), [&](std::size_t i) {
      return jsonOf(map.trajectory.stamps[i], map.trajectory.poses[i]);
    });
  }
  write("\n]}\n");
}

void
saveMapFile(const std::string& path, const CompactMap& map)
{
  acmap::requireConsistent(map); // before the file is opened
  acmap::OutputFile file(path);
  acmap::writeMap(
      map, [&](const std::string& text) { file.write(text.data(), text.size()); });
  file.commit();
}

} // namespace pcl
