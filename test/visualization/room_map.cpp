#include "room_map.h"

#include <Eigen/Geometry>

namespace pcl::acmap::test {
namespace {

using Eigen::Vector3d;
using Color = std::array<int, 3>;

constexpr double texel = 0.05; // metres

/** \brief A rectangle seen from its front: corner at the upper left, width to the
 * right, height down. */
struct RoomSheet {
  Vector3d corner, right, down;
  double width, height;

  Eigen::Vector3f
  at(double x, double y) const
  {
    return (corner + x * right + y * down).cast<float>();
  }
};

PlanePatch
planeOf(const RoomSheet& sheet)
{
  PlanePatch plane;
  const Vector3d normal = sheet.down.cross(sheet.right);
  plane.coefficients << normal, -normal.dot(sheet.corner);
  plane.center =
      sheet.corner + (sheet.width * sheet.right + sheet.height * sheet.down) / 2;
  plane.axis_u = sheet.right;
  plane.axis_v = normal.cross(sheet.right);
  plane.covariance = Vector3d(1e-6, 4e-6, 9e-6).asDiagonal();
  plane.support = 1000;
  plane.rms = 0.004;
  plane.area = sheet.width * sheet.height;
  plane.polygons.push_back({{sheet.at(0, 0),
                             sheet.at(0, sheet.height),
                             sheet.at(sheet.width, sheet.height),
                             sheet.at(sheet.width, 0)},
                            {}});
  return plane;
}

TextureChart
chartOf(const RoomSheet& sheet, std::size_t plane, const Color& color, bool marked)
{
  TextureChart chart;
  chart.plane = plane;
  chart.origin = sheet.corner;
  chart.texel_u = sheet.right * texel;
  chart.texel_v = sheet.down * texel;
  const int width = static_cast<int>(std::lround(sheet.width / texel));
  const int height = static_cast<int>(std::lround(sheet.height / texel));
  chart.colors.width = width;
  chart.colors.height = height;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const bool white = marked && row < height / 2 && column < width / 2;
      const bool dark = (row / 10 + column / 10) % 2 != 0;
      for (const int value : color)
        chart.colors.values.push_back(
            static_cast<std::uint8_t>(white ? 255 : value * (dark ? 6 : 10) / 10));
    }
  chart.kinds.assign(chart.colors.values.size() / 3, TexelKind::Seen);
  return chart;
}

} // namespace

CompactMap
makeRoomMap()
{
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  const RoomSheet sheets[] = {{{-3, -1.3, 2}, x, y, 6, 2.5},
                              {{3, -1.3, 2}, -z, y, 4, 2.5},
                              {{3, -1.3, -2}, -x, y, 6, 2.5},
                              {{-3, -1.3, -2}, z, y, 4, 2.5},
                              {{-3, 1.2, 2}, x, -z, 6, 4},
                              {{-3, -1.3, -2}, x, z, 6, 4}};
  const Color colors[] = {{230, 40, 40},
                          {40, 200, 40},
                          {50, 80, 240},
                          {230, 220, 40},
                          {200, 200, 200},
                          {40, 220, 220}};
  CompactMap map;
  for (std::size_t i = 0; i < 6; ++i) {
    map.planes.push_back(planeOf(sheets[i]));
    if (i != 4)
      map.charts.push_back(chartOf(sheets[i], i, colors[i], i < 4));
  }
  const RoomSheet& front = sheets[0];
  map.planes[0].polygons[0].outer = {front.at(0, 0),
                                     front.at(0, 2.5),
                                     front.at(4, 2.5),
                                     front.at(4, 0.5),
                                     front.at(5, 0.5),
                                     front.at(5, 2.5),
                                     front.at(6, 2.5),
                                     front.at(6, 0)};
  const RoomSheet& left = sheets[3];
  map.planes[3].polygons[0].holes.push_back(
      {left.at(1, 0.5), left.at(3, 0.5), left.at(3, 1.5), left.at(1, 1.5)});
  RoomSheet tile = sheets[4];
  tile.width = 3;
  map.charts.push_back(chartOf(tile, 4, {220, 220, 220}, false));
  tile.corner += 3 * tile.right;
  map.charts.push_back(chartOf(tile, 4, {110, 110, 110}, false));
  return map;
}

Trajectory
makeRoomWay()
{
  Trajectory way;
  for (int i = 0; i <= 10; ++i) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitY()).toRotationMatrix();
    pose.translation() = Vector3d(-2 + 0.4 * i, 0, 0.3 * std::sin(i));
    way.poses.push_back(pose);
    way.stamps.push_back(i);
  }
  return way;
}

} // namespace pcl::acmap::test
