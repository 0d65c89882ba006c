#include "plane_meshes.h"

#include <pcl/core/random.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

int
verticesAlong(double length)
{
  return static_cast<int>(std::lround(length / grid)) + 1;
}

VotingMesh
movedBy(VotingMesh mesh, const Eigen::Isometry3f& motion)
{
  for (PointXYZ& point : mesh.cloud)
    point.getVector3fMap() = motion * point.getVector3fMap();
  return mesh;
}

} // namespace

VotingMesh
makeWall(double width, double height)
{
  return makePlaneMesh(verticesAlong(width), verticesAlong(height), grid);
}

VotingMesh
placedAt(const VotingMesh& mesh, double x, double y, double z)
{
  Eigen::Isometry3f motion = Eigen::Isometry3f::Identity();
  motion.translation() = Eigen::Vector3d(x, y, z).cast<float>();
  return movedBy(mesh, motion);
}

VotingMesh
together(VotingMesh mesh, const VotingMesh& other)
{
  const auto first = static_cast<std::int32_t>(mesh.cloud.size());
  mesh.cloud += other.cloud;
  for (const TriangleMesh::Triangle& t : other.faces.triangles)
    mesh.faces.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return mesh;
}

VotingMesh
withNoise(VotingMesh mesh, const Eigen::Vector3f& axis, double sigma)
{
  Random random(17);
  for (PointXYZ& point : mesh.cloud)
    point.getVector3fMap() += static_cast<float>(sigma * random.normal()) * axis;
  return mesh;
}

VotingMesh
without(const VotingMesh& mesh, const std::function<bool(const PointXYZ&)>& is_out)
{
  VotingMesh rest;
  std::vector<std::int32_t> numbers;
  for (const PointXYZ& point : mesh.cloud) {
    numbers.push_back(is_out(point) ? -1
                                    : static_cast<std::int32_t>(rest.cloud.size()));
    if (numbers.back() >= 0)
      rest.cloud.push_back(point);
  }
  for (TriangleMesh::Triangle triangle : mesh.faces.triangles) {
    for (std::int32_t& corner : triangle)
      corner = numbers[static_cast<std::size_t>(corner)];
    if (*std::min_element(triangle.begin(), triangle.end()) >= 0)
      rest.faces.triangles.push_back(triangle);
  }
  return rest;
}

VotingMesh
makeBoards(double distance)
{
  const VotingMesh board = makeWall(2, 1.5);
  return together(board, placedAt(board, 0, 0, distance));
}

VotingMesh
makeThinWall(double thickness)
{
  const VotingMesh side = makeWall(2, 2);
  return together(side, turnedOver(placedAt(side, 0, 0, -thickness)));
}

VotingMesh
makeDoor(double depth)
{
  constexpr double wall = 1.5, door = 0.9;
  const double length = 2 * (wall + depth) + door; // of the profile that is extruded
                                                   // along y
  const auto place = [=](double u, double v) {
    const double along = u + length / 2;
    const double in = std::clamp(along - wall, 0.0, depth);
    const double out = std::clamp(along - wall - depth - door, 0.0, depth);
    return Eigen::Vector3d(along - in - out, v, out - in);
  };
  return makeSheetMesh(verticesAlong(length), verticesAlong(2), grid, place);
}

VotingMesh
makeCurvedWall(double radius, double sigma, double spacing)
{
  Random random(3);
  const auto place = [&](double u, double v) {
    const double range = radius + sigma * random.normal();
    return Eigen::Vector3d(
        range * std::sin(u / radius), v, range * std::cos(u / radius) - radius);
  };
  return makeSheetMesh(static_cast<int>(std::lround(4 / spacing)) + 1,
                       static_cast<int>(std::lround(2.5 / spacing)) + 1,
                       spacing,
                       place);
}

VotingMesh
makeCornerMesh()
{
  constexpr double middle = 1 + grid / 2;
  const VotingMesh floor = placedAt(makeWall(2, 2), middle, middle, 0);
  VotingMesh all = floor;
  Eigen::Isometry3f turn = Eigen::Isometry3f::Identity();
  for (int k = 0; k < 2; ++k) {
    turn.rotate(Eigen::AngleAxisf(2 * static_cast<float>(M_PI) / 3,
                                  Eigen::Vector3f::Ones().normalized()));
    all = together(all, movedBy(floor, turn));
  }
  return all;
}

} // namespace pcl::acmap::test
