#include "plane_file.h"

#include <pcl/core/build_config.h>
#include <pcl/core/output_file.h>

#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cstdlib>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

/** The double of the same shortest text, so that no digits appear that a float has not. */
double
shortest(float value)
{
  std::array<char, 40> text{};
  std::to_chars(text.data(), text.data() + text.size() - 1, value);
  double same = 0;
  std::from_chars(text.data(), text.data() + std::strlen(text.data()), same);
  return same;
}

Json
jsonOf(const Eigen::Vector3d& vector)
{
  return {vector.x(), vector.y(), vector.z()};
}

Json
jsonOf(const Eigen::Matrix3d& matrix)
{
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row)
    rows.push_back(jsonOf(Eigen::Vector3d(matrix.row(row))));
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
jsonOf(const PlanePatch& plane, std::size_t id)
{
  const Eigen::Vector4d& c = plane.coefficients;
  Json polygons = Json::array();
  for (const PlanePolygon& polygon : plane.polygons)
    polygons.push_back(jsonOf(polygon));
  return {{"id", id},
          {"coefficients", {c[0], c[1], c[2], c[3]}},
          {"center", jsonOf(plane.center)},
          {"axes", {jsonOf(plane.axis_u), jsonOf(plane.axis_v)}},
          {"covariance", jsonOf(plane.covariance)},
          {"support", plane.support},
          {"effective_support", plane.effective_support},
          {"rmse", plane.rms},
          {"area", plane.area},
          {"polygons", std::move(polygons)}};
}

} // namespace

void
savePlanes(const std::string& path, const std::vector<PlanePatch>& planes)
{
  OutputFile file(path);
  const auto write = [&](const std::string& text) {
    file.write(text.data(), text.size());
  };
  write("{\"version\":" + Json(ACMAP_VERSION).dump() +
        ",\"unit\":\"m\",\"frame\":\"of the input\",\"planes\":[");
  for (std::size_t id = 0; id < planes.size(); ++id)
    write((id ? ",\n" : "\n") + jsonOf(planes[id], id).dump());
  write("\n]}\n");
  file.commit();
}

} // namespace pcl::acmap
