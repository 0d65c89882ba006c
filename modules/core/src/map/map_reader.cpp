#include "files/byte_source.h"
#include "files/json_cursor.h"
#include "map/map_format.h"

#include <pcl/core/file_format.h>
#include <pcl/core/impl/chart_clip.h>
#include <pcl/core/map_file.h>
#include <pcl/core/map_topology.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace pcl {

namespace {

using acmap::JsonCursor;

constexpr double rotation_slack = 0.01; // tolerance of the length of a quaternion
// the messages of the parser quote words of any length
constexpr std::size_t longest_text = 200;

nlohmann::json
parseText(acmap::ByteSource& source)
{
  std::string text(source.remaining(), '\0');
  source.read(text.data(), text.size());
  try {
    return nlohmann::json::parse(text);
  }
  catch (const nlohmann::json::exception& error) {
    source.fail("is no JSON: " + std::string(error.what()).substr(0, longest_text));
  }
}

void
requireKnownFormat(const JsonCursor& file, const std::string& path)
{
  if (file.has("format")) {
    const JsonCursor format = file.at("format");
    const auto number = format.integer(1, std::numeric_limits<std::int64_t>::max());
    const std::string fault = acmap::faultOfFormat(static_cast<std::uint64_t>(number),
                                                   acmap::file_formats::map);
    if (!fault.empty())
      throw InputFileException(path + ": " + fault);
  }
  if (file.has("unit") && file.at("unit").text() != "m")
    file.at("unit").fail("is not \"m\"");
}

void
requireNone(const std::string& fault, const JsonCursor& value)
{
  if (!fault.empty())
    value.fail(fault);
}

std::vector<Eigen::Vector3f>
loopOf(const JsonCursor& points)
{
  std::vector<Eigen::Vector3f> loop;
  loop.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const JsonCursor point = points[i];
    point.requireSize(3);
    loop.emplace_back(
        point[0].floatNumber(), point[1].floatNumber(), point[2].floatNumber());
  }
  requireNone(acmap::faultOfLoop(loop), points);
  return loop;
}

PlanePolygon
polygonOf(const JsonCursor& json)
{
  PlanePolygon polygon;
  polygon.outer = loopOf(json.at("outer"));
  const JsonCursor holes = json.at("holes");
  for (std::size_t i = 0; i < holes.size(); ++i)
    polygon.holes.push_back(loopOf(holes[i]));
  return polygon;
}

std::vector<PlanePolygon>
polygonsOf(const JsonCursor& json)
{
  std::vector<PlanePolygon> polygons;
  for (std::size_t i = 0; i < json.size(); ++i)
    polygons.push_back(polygonOf(json[i]));
  return polygons;
}

template <int size>
Eigen::Matrix<double, size, size>
covarianceOf(const JsonCursor& json)
{
  Eigen::Matrix<double, size, size> matrix;
  json.requireSize(size);
  for (int row = 0; row < size; ++row) {
    const JsonCursor values = json[static_cast<std::size_t>(row)];
    values.requireSize(size);
    for (int column = 0; column < size; ++column)
      matrix(row, column) = values[static_cast<std::size_t>(column)].numberOrNan();
  }
  return matrix;
}

/** \param[in] names of the kinds, in their order
 * \param[in] fault after the name of a value that is none of them */
template <typename Kind, std::size_t count>
Kind
kindOf(const JsonCursor& json,
       const std::array<const char*, count>& names,
       const char* fault)
{
  const auto kind = std::find(names.begin(), names.end(), json.text());
  if (kind == names.end())
    json.fail(fault);
  return static_cast<Kind>(kind - names.begin());
}

/** Files of before have no names. */
SurfaceLabel
labelOf(const JsonCursor& json)
{
  SurfaceLabel label;
  if (!json.has("name"))
    return label;
  label.name = json.at("name").text();
  if (json.has("role"))
    label.role = kindOf<SurfaceRole>(
        json.at("role"),
        acmap::surface_role_names,
        "is no role: other, floor, ceiling, wall, door leaf or furniture");
  if (json.has("size")) {
    const JsonCursor size = json.at("size");
    size.requireSize(2);
    label.size = {size[0].numberOrNan(), size[1].numberOrNan()};
  }
  return label;
}

constexpr auto max_integer = std::numeric_limits<std::int64_t>::max();

/** \param[in] what the items of the list, in the plural */
void
requireNumber(const JsonCursor& id, std::size_t number, const std::string& what)
{
  if (id.integer(0, max_integer) != static_cast<std::int64_t>(number))
    id.fail("is not " + std::to_string(number) + ": " + what +
            " are numbered in their order");
}

PlanePatch
planeOf(const JsonCursor& json, std::size_t number)
{
  PlanePatch plane;
  const JsonCursor coefficients = json.at("coefficients");
  plane.coefficients = coefficients.vector<4>();
  requireNone(acmap::faultOfCoefficients(plane.coefficients), coefficients);
  requireNumber(json.at("id"), number, "planes");
  plane.center = json.at("center").vector<3>();
  const JsonCursor axes = json.at("axes");
  axes.requireSize(2);
  plane.axis_u = axes[0].vector<3>();
  plane.axis_v = axes[1].vector<3>();
  plane.covariance = covarianceOf<3>(json.at("covariance"));
  plane.support = static_cast<std::size_t>(json.at("support").integer(0, max_integer));
  plane.effective_support = json.at("effective_support").numberOrNan();
  plane.rms = json.at("rmse").numberOrNan();
  plane.area = json.at("area").number();
  plane.polygons = polygonsOf(json.at("polygons"));
  if (json.has("proposed"))
    plane.proposed = polygonsOf(json.at("proposed"));
  if (json.has("pose_modes")) {
    const JsonCursor modes = json.at("pose_modes");
    for (std::size_t k = 0; k < modes.size(); ++k)
      plane.pose_modes.push_back(modes[k].vector<3>());
  }
  plane.label = labelOf(json);
  return plane;
}

std::int32_t
templateOf(const JsonCursor& json)
{
  return static_cast<std::int32_t>(
      json.integer(0, std::numeric_limits<std::int32_t>::max() - 1));
}

CylinderPatch
cylinderOf(const JsonCursor& json, std::size_t number)
{
  CylinderPatch cylinder;
  requireNumber(json.at("id"), number, "cylinders");
  cylinder.axis_point = json.at("axis_point").vector<3>();
  cylinder.axis_direction = json.at("axis_direction").vector<3>();
  const JsonCursor axes = json.at("axes"), extent = json.at("extent");
  axes.requireSize(2);
  cylinder.axis_u = axes[0].vector<3>();
  cylinder.axis_v = axes[1].vector<3>();
  cylinder.radius = json.at("radius").number();
  extent.requireSize(2);
  cylinder.low = extent[0].number();
  cylinder.high = extent[1].number();
  cylinder.arc = json.at("arc").number();
  cylinder.is_hollow = json.at("hollow").boolean();
  cylinder.covariance = covarianceOf<5>(json.at("covariance"));
  cylinder.support =
      static_cast<std::size_t>(json.at("support").integer(0, max_integer));
  cylinder.rms = json.at("rmse").numberOrNan();
  cylinder.area = json.at("area").number();
  cylinder.template_id = templateOf(json.at("template"));
  cylinder.saved_bits = json.at("saved_bits").number();
  cylinder.label = labelOf(json);
  return cylinder;
}

std::string
imageNameOf(const JsonCursor& json)
{
  std::string name = json.text();
  requireNone(acmap::faultOfImageName(name), json);
  return name;
}

Eigen::Vector2i
placeOf(const JsonCursor& json)
{
  json.requireSize(2);
  Eigen::Vector2i place;
  for (const Eigen::Index i : {0, 1})
    place[i] = static_cast<std::int32_t>(
        json[static_cast<std::size_t>(i)].integer(0, acmap::maximum_texels));
  return place;
}

/** Reads size and places of a picture. */
void
readPicture(const JsonCursor& json, TexturePicture& picture)
{
  picture.image = imageNameOf(json.at("image"));
  if (json.has("at"))
    picture.image_place = placeOf(json.at("at"));
  if (json.has("halvings"))
    picture.halvings = static_cast<std::int32_t>(
        json.at("halvings").integer(0, std::numeric_limits<std::int32_t>::max()));
  if (json.has("kinds"))
    picture.kinds_image = imageNameOf(json.at("kinds"));
  if (json.has("kinds_at"))
    picture.kinds_place = placeOf(json.at("kinds_at"));
  for (const auto& [key, side] :
       {std::pair{"width", &picture.colors.width}, {"height", &picture.colors.height}})
    *side = static_cast<std::int32_t>(json.at(key).integer(1, acmap::maximum_texels));
  requireNone(acmap::faultOfPlace(picture), json);
}

TextureChart
chartOf(const JsonCursor& json, std::size_t plane, std::size_t polygons)
{
  TextureChart chart;
  chart.plane = plane;
  const auto polygon =
      json.at("polygon").integer(0, std::numeric_limits<std::int64_t>::max());
  chart.polygon = static_cast<std::size_t>(polygon);
  if (chart.polygon >= polygons)
    json.at("polygon").fail("is " + std::to_string(polygon) + ", the plane has " +
                            std::to_string(polygons));
  chart.origin = json.at("origin").vector<3>();
  chart.texel_u = json.at("texel_u").vector<3>();
  chart.texel_v = json.at("texel_v").vector<3>();
  readPicture(json, chart);
  requireNone(acmap::faultOfFrame(chart), json);
  return chart;
}

std::vector<std::int32_t>
observationsOf(const JsonCursor& json, std::size_t poses)
{
  constexpr std::int64_t maximum = std::numeric_limits<std::int32_t>::max();
  const std::int64_t last = poses ? static_cast<std::int64_t>(poses) - 1 : maximum;
  std::vector<std::int32_t> numbers;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const auto number = static_cast<std::int32_t>(json[i].integer(0, last));
    if (!numbers.empty() && number <= numbers.back())
      json[i].fail("is not above the one before");
    numbers.push_back(number);
  }
  return numbers;
}

/** The plane of an edge or an opening, and the other one or -1.
 * \param[in] count of the planes of the map */
std::array<std::int32_t, 2>
planesOf(const JsonCursor& json, std::size_t count)
{
  std::array<std::int32_t, 2> planes{-1, -1};
  if (json.size() < 1 || json.size() > 2)
    json.fail("are " + std::to_string(json.size()) + ", 1 or 2 are needed");
  for (std::size_t k = 0; k < json.size(); ++k)
    planes[k] = static_cast<std::int32_t>(
        json[k].integer(0, static_cast<std::int64_t>(count) - 1));
  return planes;
}

/** Reads the edges of a map into its polygons. The vertices must be those of the
 * polygons in the order of \ref topologyOf. */
void
readEdges(const JsonCursor& file, CompactMap& map)
{
  std::vector<PlanePatch>& planes = map.planes;
  const MapTopology topology = topologyOf(planes);
  const JsonCursor vertices = file.at("vertices");
  vertices.requireSize(topology.vertices.size());
  for (std::size_t i = 0; i < topology.vertices.size(); ++i) {
    const JsonCursor point = vertices[i];
    point.requireSize(3);
    const Eigen::Vector3f place(
        point[0].floatNumber(), point[1].floatNumber(), point[2].floatNumber());
    if (place != topology.vertices[i])
      point.fail("is not that point of the polygons");
  }
  const JsonCursor edges = file.at("edges");
  const auto last = static_cast<std::int64_t>(topology.vertices.size()) - 1;
  std::map<std::array<std::int32_t, 2>, MapEdge> known;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    MapEdge edge;
    const JsonCursor item = edges[i];
    const JsonCursor ends = item.at("vertices");
    ends.requireSize(2);
    for (std::size_t k = 0; k < 2; ++k)
      edge.vertices[k] = static_cast<std::int32_t>(ends[k].integer(0, last));
    edge.planes = planesOf(item.at("planes"), planes.size());
    edge.kind = kindOf<EdgeKind>(
        item.at("kind"),
        acmap::edge_kind_names,
        "is no kind of an edge: open, crease, contact, rim, frontier or arc");
    if (edge.kind == EdgeKind::Arc)
      edge.cylinder = static_cast<std::int32_t>(
          item.at("cylinder")
              .integer(0, static_cast<std::int64_t>(map.cylinders.size()) - 1));
    known.emplace(edge.vertices, edge);
  }
  for (const MapFace& face : topology.faces) {
    PlanePatch& plane = planes[static_cast<std::size_t>(face.plane)];
    PlanePolygon& polygon = plane.polygons[static_cast<std::size_t>(face.polygon)];
    std::vector<std::vector<std::int32_t>> loops = face.holes;
    loops.insert(loops.begin(), face.outer);
    for (const std::vector<std::int32_t>& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto [low, high] = std::minmax(loop[i], loop[(i + 1) % loop.size()]);
        const auto edge = known.find({low, high});
        if (edge == known.end())
          edges.fail("have none from vertex " + std::to_string(low) + " to " +
                     std::to_string(high));
        const auto& [ends, kind, sides, cylinder] = edge->second;
        polygon.edges.push_back({kind,
                                 kind == EdgeKind::Arc    ? cylinder
                                 : sides[0] == face.plane ? sides[1]
                                                          : sides[0]});
      }
  }
}

/** \param[in] count of what the indices are of */
std::vector<std::int32_t>
indicesOf(const JsonCursor& json, std::size_t count)
{
  std::vector<std::int32_t> indices;
  for (std::size_t i = 0; i < json.size(); ++i)
    indices.push_back(static_cast<std::int32_t>(
        json[i].integer(0, static_cast<std::int64_t>(count) - 1)));
  return indices;
}

BoxFace
boxFaceOf(const JsonCursor& json, std::size_t planes)
{
  BoxFace face;
  face.kind =
      kindOf<BoxFaceKind>(json.at("kind"),
                          acmap::box_face_kind_names,
                          "is no kind of a face: free, seen, snapped or slanted");
  if (face.kind != BoxFaceKind::Free)
    face.plane = static_cast<std::int32_t>(
        json.at("plane").integer(0, static_cast<std::int64_t>(planes) - 1));
  return face;
}

/** Reads what a box and a recess have in common. */
template <typename Patch>
void
readBlock(const JsonCursor& json, Patch& patch)
{
  patch.center = json.at("center").vector<3>();
  const JsonCursor axes = json.at("axes");
  axes.requireSize(3);
  for (std::size_t axis = 0; axis < 3; ++axis)
    patch.axes.col(static_cast<Eigen::Index>(axis)) = axes[axis].vector<3>();
  patch.size = json.at("size").vector<3>();
  patch.template_id = templateOf(json.at("template"));
  patch.covariance = covarianceOf<9>(json.at("covariance"));
  patch.saved_bits = json.at("saved_bits").number();
  if (json.has("name"))
    patch.name = json.at("name").text();
}

BoxPatch
boxOf(const JsonCursor& json, std::size_t number, std::size_t planes)
{
  BoxPatch box;
  requireNumber(json.at("id"), number, "boxes");
  readBlock(json, box);
  const JsonCursor faces = json.at("faces");
  faces.requireSize(box.faces.size());
  for (std::size_t side = 0; side < box.faces.size(); ++side)
    box.faces[side] = boxFaceOf(faces[side], planes);
  if (json.has("slant"))
    box.slant = json.at("slant").vector<4>();
  return box;
}

RecessPatch
recessOf(const JsonCursor& json, std::size_t number, std::size_t planes)
{
  RecessPatch recess;
  requireNumber(json.at("id"), number, "recesses");
  readBlock(json, recess);
  const auto last = static_cast<std::int64_t>(planes) - 1;
  recess.wall = static_cast<std::int32_t>(json.at("wall").integer(0, last));
  recess.leaf = static_cast<std::int32_t>(json.at("leaf").integer(0, last));
  recess.reaches_floor = json.at("reaches_floor").boolean();
  return recess;
}

MapRoom
roomOf(const JsonCursor& json, std::size_t planes, std::size_t openings)
{
  MapRoom room;
  room.center = json.at("center").vector<3>();
  room.area = json.at("area").number();
  room.seen_area = json.at("seen_area").number();
  room.planes = indicesOf(json.at("planes"), planes);
  room.openings = indicesOf(json.at("openings"), openings);
  room.label = labelOf(json);
  return room;
}

MapOpening
openingOf(const JsonCursor& json, std::size_t planes, std::size_t rooms)
{
  MapOpening opening;
  opening.from = json.at("from").vector<3>();
  opening.to = json.at("to").vector<3>();
  opening.bottom = json.at("bottom").numberOrNan();
  opening.top = json.at("top").numberOrNan();
  opening.kind = kindOf<OpeningKind>(json.at("kind"),
                                     acmap::opening_kind_names,
                                     "is no kind of an opening: door or window");
  opening.planes = planesOf(json.at("planes"), planes);
  const JsonCursor sides = json.at("rooms");
  sides.requireSize(2);
  for (std::size_t k = 0; k < 2; ++k)
    opening.rooms[k] = static_cast<std::int32_t>(
        sides[k].integer(-1, static_cast<std::int64_t>(rooms) - 1));
  opening.label = labelOf(json);
  return opening;
}

void
readRooms(const JsonCursor& file, CompactMap& map)
{
  const JsonCursor rooms = file.at("rooms"), openings = file.at("openings");
  for (std::size_t i = 0; i < rooms.size(); ++i)
    map.rooms.push_back(roomOf(rooms[i], map.planes.size(), openings.size()));
  for (std::size_t i = 0; i < openings.size(); ++i)
    map.openings.push_back(openingOf(openings[i], map.planes.size(), rooms.size()));
}

void
appendPose(const JsonCursor& json, Trajectory& trajectory)
{
  const JsonCursor orientation = json.at("orientation");
  const Eigen::Quaterniond rotation(orientation.vector<4>());
  if (!(std::abs(rotation.norm() - 1.0) <= rotation_slack))
    orientation.fail("is no rotation: its length is not 1");
  Eigen::Isometry3d pose(rotation.normalized());
  pose.translation() = json.at("position").vector<3>();
  trajectory.stamps.push_back(json.at("stamp").number());
  trajectory.poses.push_back(pose);
}

} // namespace

CompactMap
acmap::readMap(const std::string& name, ByteSource& source)
{
  const nlohmann::json json = parseText(source);
  const JsonCursor file(json, name);
  requireKnownFormat(file, name);
  const JsonCursor planes = file.at("planes");
  CompactMap map;
  if (file.has("trajectory")) {
    const JsonCursor poses = file.at("trajectory");
    for (std::size_t i = 0; i < poses.size(); ++i)
      appendPose(poses[i], map.trajectory);
  }
  if (file.has("exposure")) {
    map.exposure = file.at("exposure").number();
    requireNone(faultOfExposure(map.exposure), file.at("exposure"));
  }
  for (const auto& [key, up] :
       {std::pair("up", &map.up), std::pair("assumed_up", &map.assumed_up)})
    if (file.hasValue(key)) {
      *up = file.at(key).vector<3>();
      requireNone(faultOfUp(*up), file.at(key));
    }
  if (file.has("shift"))
    map.shift = file.at("shift").vector<3>();
  map.observations.resize(planes.size());
  std::int64_t texels = 0;
  const auto addTexels = [&](const TexturePicture& picture, const JsonCursor& at) {
    texels += std::int64_t{picture.colors.width} * picture.colors.height;
    requireNone(faultOfTexels(texels), at);
  };
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const JsonCursor plane = planes[i];
    map.planes.push_back(planeOf(plane, i));
    if (plane.has("observations"))
      map.observations[i] =
          observationsOf(plane.at("observations"), map.trajectory.poses.size());
    if (!plane.has("charts"))
      continue;
    const JsonCursor charts = plane.at("charts");
    for (std::size_t k = 0; k < charts.size(); ++k) {
      map.charts.push_back(chartOf(charts[k], i, map.planes[i].polygons.size()));
      addTexels(map.charts.back(), charts[k]);
    }
  }
  if (file.has("cylinders")) {
    const JsonCursor cylinders = file.at("cylinders");
    bool has_pictures = false;
    for (std::size_t i = 0; i < cylinders.size(); ++i) {
      map.cylinders.push_back(cylinderOf(cylinders[i], i));
      requireNone(faultOfCylinder(map, i), cylinders[i]);
      TexturePicture& picture = map.cylinder_pictures.emplace_back();
      if (!cylinders[i].has("texture"))
        continue;
      has_pictures = true;
      readPicture(cylinders[i].at("texture"), picture);
      addTexels(picture, cylinders[i]);
    }
    if (!has_pictures)
      map.cylinder_pictures.clear();
  }
  if (file.has("boxes")) {
    const JsonCursor boxes = file.at("boxes");
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      map.boxes.push_back(boxOf(boxes[i], i, map.planes.size()));
      requireNone(faultOfBox(map, i), boxes[i]);
    }
  }
  if (file.has("recesses")) {
    const JsonCursor recesses = file.at("recesses");
    for (std::size_t i = 0; i < recesses.size(); ++i) {
      map.recesses.push_back(recessOf(recesses[i], i, map.planes.size()));
      requireNone(faultOfRecess(map, i), recesses[i]);
    }
  }
  if (file.has("edges") && file.has("vertices"))
    readEdges(file, map);
  if (file.has("rooms") && file.has("openings"))
    readRooms(file, map);
  return map;
}

CompactMap
loadMapFile(const std::string& path)
{
  acmap::ByteSource source(path);
  return acmap::readMap(path, source);
}

} // namespace pcl
