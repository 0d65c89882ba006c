#include "fuzzed_mesh.h"

#include <utility>

namespace pcl::acmap::test {
namespace {

/** Adds two triangles for each square of a sheet of points; some squares are holes,
 * some have the other diagonal. */
void
addSheet(FuzzedBytes& bytes, std::int32_t columns, FuzzedMesh& mesh)
{
  const auto size = static_cast<std::int32_t>(mesh.points.size());
  for (std::int32_t a = 0; a + columns + 1 < size; ++a) {
    if (a % columns == columns - 1)
      continue;
    const std::uint8_t choice = bytes.byte();
    const std::int32_t b = a + 1, c = a + columns, d = c + 1;
    if ((choice & 15) == 15)
      continue;
    const bool is_turned = choice & 16;
    mesh.triangles.push_back({a, b, is_turned ? d : c});
    mesh.triangles.push_back({is_turned ? a : b, d, c});
    if (choice & 32)
      std::swap(mesh.triangles.back()[0], mesh.triangles.back()[1]);
  }
}

} // namespace

FuzzedMesh::FuzzedMesh(FuzzedBytes& bytes,
                       const PointStyle& style,
                       std::size_t max_points)
{
  const std::uint8_t shape = bytes.byte();
  const std::size_t size = bytes.byte() % (max_points + 1);
  const std::int32_t columns = 2 + (shape & 7);
  const bool is_sheet = shape & 8, is_level = shape & 16;
  for (std::size_t i = 0; i < size; ++i) {
    Eigen::Vector3f point;
    if (is_level) {
      const auto place = static_cast<std::int32_t>(i);
      point.x() = static_cast<float>(place % columns) * style.scale + style.far;
      point.y() = static_cast<float>(place / columns) * style.scale + style.far;
      point.z() = style.coordinate(bytes);
    }
    else
      point = style.point(bytes);
    points.push_back(point);
  }
  if (points.empty())
    return;
  if (is_sheet)
    addSheet(bytes, columns, *this);
  const std::size_t more = bytes.byte() % (is_sheet ? 4 : 64);
  const auto corner = [&] {
    return static_cast<std::int32_t>(bytes.byte() % points.size());
  };
  for (std::size_t i = 0; i < more; ++i)
    triangles.push_back({corner(), corner(), corner()});
}

SensorView
fuzzedSensors(FuzzedBytes& bytes,
              const PointStyle& style,
              std::size_t points,
              std::vector<std::int32_t>& views)
{
  const std::uint8_t choice = bytes.byte() & 3;
  if (choice == 0)
    return {};
  PointStyle finite = style;
  finite.has_odd = false;
  if (choice == 1)
    return SensorView(finite.point(bytes));
  std::vector<Eigen::Vector3f> origins;
  while (origins.size() < choice)
    origins.push_back(finite.point(bytes));
  while (views.size() < points)
    views.push_back(bytes.byte() % 5 - 1); // some are invalid numbers
  return {views.data(), sizeof(std::int32_t), std::move(origins)};
}

} // namespace pcl::acmap::test
