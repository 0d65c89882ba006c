#include "scenes_with_up.h"

#include <pcl/core/random.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace pcl::acmap::test {

namespace {

using Eigen::Vector3d;

/** Samples rectangles evenly, with noise along their normals. */
class Sampler {
public:
  Sampler(std::uint64_t seed, double density, double sigma)
  : random_(seed)
  , density_(density)
  , sigma_(sigma)
  {}

  double
  uniform(double least, double most)
  {
    return random_.uniform(least, most);
  }

  void
  addRectangle(const Vector3d& corner, const Vector3d& u, const Vector3d& v)
  {
    const Vector3d normal = u.cross(v).normalized();
    const auto count = static_cast<std::size_t>(density_ * u.cross(v).norm());
    for (std::size_t i = 0; i < count; ++i)
      points_.push_back(corner + uniform(0, 1) * u + uniform(0, 1) * v +
                        sigma_ * random_.normal() * normal);
  }

  /** Four sides and the top. */
  void
  addBox(const Vector3d& corner, const Vector3d& size)
  {
    const Vector3d x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
    addRectangle(corner + z, x, y);
    addRectangle(corner, x, z);
    addRectangle(corner + y, x, z);
    addRectangle(corner, y, z);
    addRectangle(corner + x, y, z);
  }

  SceneWithUp
  scene(const std::string& name, double turn)
  {
    SceneWithUp result;
    result.name = name;
    const Eigen::AngleAxisd about(turn, Vector3d::UnitZ());
    for (const Vector3d& point : points_)
      result.points.push_back(about * point);
    return result;
  }

private:
  Random random_;
  double density_, sigma_;
  std::vector<Vector3d> points_;
};

/** A room of this size, its furniture along the walls. */
void
addRoom(Sampler& sampler, const Vector3d& size, bool has_ceiling)
{
  const Vector3d x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
  sampler.addRectangle(Vector3d::Zero(), x, y);
  if (has_ceiling)
    sampler.addRectangle(z, x, y);
  sampler.addRectangle(Vector3d::Zero(), x, z);
  sampler.addRectangle(Vector3d::Zero(), y, z);
  sampler.addRectangle(x, y, z);
  for (int piece = 0; piece < 4; ++piece)
    sampler.addBox({sampler.uniform(0, size.x() - 1), sampler.uniform(0, 0.3), 0},
                   {sampler.uniform(0.4, 1),
                    sampler.uniform(0.4, 0.8),
                    sampler.uniform(0.4, 1.1)});
}

Sampler
samplerFor(std::uint64_t seed, std::uint64_t scene)
{
  return {100 * seed + scene, 400, 0.004};
}

SceneWithUp
makeRoom(std::uint64_t seed, const Vector3d& size, bool has_ceiling, double turn)
{
  Sampler sampler = samplerFor(seed, has_ceiling ? 1 : 2);
  addRoom(sampler, size, has_ceiling);
  return sampler.scene(has_ceiling ? "room" : "room without ceiling", turn);
}

SceneWithUp
makeFacade(std::uint64_t seed)
{
  Sampler sampler = samplerFor(seed, 3);
  const double width = sampler.uniform(10, 20), height = sampler.uniform(8, 14);
  sampler.addRectangle(Vector3d::Zero(), {width, 0, 0}, {0, 0, height});
  sampler.addRectangle({0, -3, 0}, {width, 0, 0}, {0, 3, 0});
  return sampler.scene("facade", sampler.uniform(0.2, 1.3));
}

SceneWithUp
makeRoofs(std::uint64_t seed)
{
  Sampler sampler(100 * seed + 4, 4, 0.03);
  sampler.addRectangle(Vector3d::Zero(), {120, 0, 0}, {0, 90, 0});
  for (int house = 0; house < 8; ++house) {
    const Vector3d corner(sampler.uniform(0, 105), sampler.uniform(0, 75), 0);
    sampler.addBox(corner, {12, 10, sampler.uniform(5, 12)});
  }
  return sampler.scene("roofs", sampler.uniform(0.2, 1.3));
}

SceneWithUp
makeCrate(std::uint64_t seed)
{
  Sampler sampler(100 * seed + 5, 20000, 0.001);
  sampler.addBox(Vector3d::Zero(), {0.8, 0.6, 0.5});
  sampler.addRectangle(Vector3d::Zero(), {0.8, 0, 0}, {0, 0.6, 0});
  return sampler.scene("crate", sampler.uniform(0.2, 1.3));
}

} // namespace

std::vector<SceneWithUp>
scenesWithUp(std::uint64_t seed)
{
  Random random(seed);
  const double turn = random.uniform(0.2, 1.3);
  const Vector3d room(random.uniform(3, 6), random.uniform(3, 5), 2.6);
  const Vector3d hall(random.uniform(15, 30), random.uniform(15, 30), 8);
  return {makeRoom(seed, room, true, turn),
          makeRoom(seed, room, true, 0),
          makeRoom(seed, room, false, turn),
          makeRoom(seed, room, false, 0),
          makeRoom(seed, hall, true, turn),
          makeFacade(seed),
          makeRoofs(seed),
          makeCrate(seed)};
}

SceneWithUp
turnedRoomWithoutCeiling(std::uint64_t seed)
{
  return makeRoom(seed, {4.5, 3.5, 2.4}, false, 0.4);
}

std::vector<Eigen::Matrix3d>
turnsToAxes()
{
  std::vector<Eigen::Matrix3d> turns;
  for (const Vector3d& axis : {Vector3d(Vector3d::UnitX()),
                               Vector3d(Vector3d::UnitY()),
                               Vector3d(Vector3d::UnitZ())})
    for (const double sign : {1.0, -1.0}) {
      const Vector3d up = sign * axis, next(up.y(), up.z(), up.x());
      Eigen::Matrix3d turn;
      turn << next, up.cross(next), up;
      turns.push_back(turn);
    }
  return turns;
}

} // namespace pcl::acmap::test
