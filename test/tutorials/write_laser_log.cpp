#include <pcl/core/random.h>

#include <Eigen/Geometry>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <limits>
#include <vector>

// Writes the laser log of the tutorial, share/logs/corridor_loop.log: a robot drives
// once around a block of rooms, with odometry drift.

namespace {

using Eigen::Vector2d;

constexpr double pi = 3.14159265358979323846;
constexpr double length = 24, depth = 14, corridor = 2; // metres
constexpr double range_noise = 0.01;                    // metres
constexpr double turn_drift = 0.005, way_drift = 1.02;  // radians per step; factor
constexpr int beams = 181;
constexpr double step = 0.5; // metres between two scans

/** \brief In the frame of the log: x forward, y to the left. */
struct Pose {
  Vector2d at;
  double theta = 0;
};

using Wall = std::pair<Vector2d, Vector2d>;

void
addPolygon(const std::vector<Vector2d>& corners, std::vector<Wall>& walls)
{
  for (std::size_t i = 0; i < corners.size(); ++i)
    walls.emplace_back(corners[i], corners[(i + 1) % corners.size()]);
}

/** \brief The corridor around the block; its outer walls have doors that are recessed
 * by 25 cm, at different positions in each wall. */
std::vector<Wall>
makeBuilding()
{
  const std::vector<Vector2d> turns = {
      {0, 0}, {length, 0}, {length, depth}, {0, depth}};
  std::vector<Vector2d> outer;
  for (std::size_t side = 0; side < 4; ++side) {
    const Vector2d from = turns[side], to = turns[(side + 1) % 4];
    const Vector2d along = (to - from).normalized();
    const Vector2d behind = 0.25 * Vector2d(along.y(), -along.x());
    outer.push_back(from);
    for (double door = 2.5 + 0.4 * static_cast<double>(side);
         door + 1 < (to - from).norm() - 1;
         door += 3.3 + 0.5 * static_cast<double>(side)) {
      const Vector2d left = from + door * along, right = left + 0.9 * along;
      outer.insert(outer.end(), {left, left + behind, right + behind, right});
    }
  }
  std::vector<Wall> walls;
  addPolygon(outer, walls);
  addPolygon({{corridor, corridor},
              {length - corridor, corridor},
              {length - corridor, depth - corridor},
              {corridor, depth - corridor}},
             walls);
  return walls;
}

double
rangeTo(const std::vector<Wall>& walls, const Vector2d& from, double angle)
{
  const Vector2d ray(std::cos(angle), std::sin(angle));
  const auto cross = [](const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : walls) {
    const double slant = cross(ray, b - a);
    const double range = cross(a - from, b - a) / slant;
    const double place = cross(a - from, ray) / slant;
    if (range > 0 && place >= 0 && place <= 1)
      nearest = std::min(nearest, range);
  }
  return nearest;
}

/** \brief One round along the centre of the corridor, with turns at its corners. */
std::vector<Pose>
makeWay()
{
  const double far = length - corridor / 2, near = corridor / 2;
  const std::vector<Vector2d> turns = {{near, near},
                                       {far, near},
                                       {far, depth - near},
                                       {near, depth - near},
                                       {near, near}};
  std::vector<Pose> way;
  for (std::size_t side = 0; side < 4; ++side) {
    const Vector2d leg = turns[side + 1] - turns[side];
    const double theta = static_cast<double>(side) * pi / 2;
    const int steps = static_cast<int>(leg.norm() / step);
    for (int i = 0; i < steps; ++i)
      way.push_back({turns[side] + leg * i / steps, theta});
    for (int i = 0; i < 4;
         ++i) // four of the five parts of the turn; the next leg does the last one
      way.push_back({turns[side + 1], theta + (i + 1) * pi / 10});
  }
  return way;
}

/** \brief The poses according to the wheels. */
std::vector<Pose>
withDrift(const std::vector<Pose>& way)
{
  std::vector<Pose> told = {way.front()};
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Pose& before = told.back();
    const Eigen::Rotation2Dd turned(before.theta - way[i - 1].theta);
    const double turn = std::remainder(way[i].theta - way[i - 1].theta, 2 * pi);
    told.push_back({before.at + turned * (way_drift * (way[i].at - way[i - 1].at)),
                    before.theta + turn + turn_drift});
  }
  return told;
}

void
writePose(std::ostream& log, const Pose& pose)
{
  log << " " << pose.at.x() << " " << pose.at.y() << " "
      << std::remainder(pose.theta, 2 * pi);
}

void
writeLog(std::ostream& log)
{
  const std::vector<Wall> walls = makeBuilding();
  const std::vector<Pose> way = makeWay(), told = withDrift(way);
  pcl::acmap::Random random(1);
  log << "# Simulated: once round a block of rooms, with drifting odometry.\n";
  for (std::size_t i = 0; i < way.size(); ++i) {
    log << std::fixed << std::setprecision(2) << "FLASER " << beams;
    for (int beam = 0; beam < beams; ++beam)
      log << " "
          << rangeTo(walls, way[i].at, way[i].theta + (beam - 90) * pi / 180) +
                 range_noise * random.normal();
    log << std::setprecision(4);
    writePose(log, told[i]);
    writePose(log, told[i]);
    log << " " << i << " robot " << i << "\n";
  }
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc != 2) {
    std::cerr << "usage: write_laser_log OUT.log\n";
    return 2;
  }
  std::ofstream file(argv[1]);
  writeLog(file);
  if (!file.flush()) {
    std::cerr << "write_laser_log: cannot write " << argv[1] << "\n";
    return 1;
  }
}
