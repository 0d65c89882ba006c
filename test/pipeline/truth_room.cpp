#include "truth_room.h"

#include <cmath>

namespace pcl::acmap::test {

std::string
roomTruth()
{
  return R"({"version": "0.1.0", "scene": "room", "planes": [
{"id": 0, "name": "floor", "coefficients": [0.0, -1.0, 0.0, 1.25], "area": 80.0, "points": 3000,
 "rectangles": [[[-2.0, 1.25, 0.0], [2.0, 1.25, 0.0], [2.0, 1.25, 20.0], [-2.0, 1.25, 20.0]]]},
{"id": 1, "name": "left wall", "coefficients": [1.0, 0.0, 0.0, 2.0], "area": 50.0, "points": 3000,
 "rectangles": [[[-2.0, 1.25, 0.0], [-2.0, 1.25, 12.0], [-2.0, -1.25, 12.0], [-2.0, -1.25, 0.0]],
                [[-2.0, 1.25, 12.0], [-2.0, 1.25, 20.0], [-2.0, -1.25, 20.0], [-2.0, -1.25, 12.0]]]},
{"id": 2, "name": "right wall", "coefficients": [-1.0, 0.0, 0.0, 2.0], "area": 50.0, "points": 3000,
 "rectangles": [[[2.0, 1.25, 20.0], [2.0, 1.25, 0.0], [2.0, -1.25, 0.0], [2.0, -1.25, 20.0]]]},
{"id": 3, "name": "far end", "coefficients": [0.0, 0.0, -1.0, 20.0], "area": 10.0, "points": 100,
 "rectangles": [[[-2.0, 1.25, 20.0], [2.0, 1.25, 20.0], [2.0, -1.25, 20.0], [-2.0, -1.25, 20.0]]]},
{"id": 4, "name": "board", "coefficients": [1.0, 0.0, 0.0, 1.95], "area": 1.0, "points": 80,
 "rectangles": [[[-1.95, 0.5, 5.0], [-1.95, 0.5, 6.0], [-1.95, -0.5, 6.0], [-1.95, -0.5, 5.0]]]},
{"id": 5, "name": "near end", "coefficients": [0.0, 0.0, 1.0, 0.0], "area": 10.0, "points": 0,
 "rectangles": [[[2.0, 1.25, 0.0], [-2.0, 1.25, 0.0], [-2.0, -1.25, 0.0], [2.0, -1.25, 0.0]]]}
]}
)";
}

Trajectory
roomWay()
{
  Trajectory way;
  for (int i = 0; i < 5; ++i) {
    way.stamps.push_back(0.8 * i);
    way.poses.emplace_back(Eigen::Translation3d(0, 0, 2.0 * i));
  }
  return way;
}

RoomSession::RoomSession(const std::string& truth)
{
  folder_.write("truth.json", truth);
  saveTrajectory(path("trajectory.txt"), roomWay());
}

PlanePatch
patchOf(const Eigen::Vector3d& corner,
        const Eigen::Vector3d& u,
        const Eigen::Vector3d& v)
{
  PlanePatch patch;
  const Eigen::Vector3d normal = u.cross(v).normalized();
  patch.coefficients << normal, -normal.dot(corner);
  patch.polygons.resize(1);
  for (const Eigen::Vector3d& point : {corner,
                                       Eigen::Vector3d(corner + u),
                                       Eigen::Vector3d(corner + u + v),
                                       Eigen::Vector3d(corner + v)})
    patch.polygons[0].outer.push_back(point.cast<float>());
  return patch;
}

PlanePatch
moved(const PlanePatch& patch, const Eigen::Isometry3d& motion)
{
  PlanePatch result = patch;
  const Eigen::Vector3d normal = motion.linear() * patch.coefficients.head<3>();
  const double offset = patch.coefficients[3] - normal.dot(motion.translation());
  result.coefficients << normal, offset;
  for (PlanePolygon& polygon : result.polygons) {
    for (Eigen::Vector3f& point : polygon.outer)
      point = (motion * point.cast<double>()).cast<float>();
    for (auto& hole : polygon.holes)
      for (Eigen::Vector3f& point : hole)
        point = (motion * point.cast<double>()).cast<float>();
  }
  return result;
}

Eigen::Isometry3d
turnAt(const Eigen::Vector3d& place, double angle)
{
  return Eigen::Translation3d(place) *
         Eigen::AngleAxisd(angle * M_PI / 180, Eigen::Vector3d::UnitY()) *
         Eigen::Translation3d(-place);
}

CompactMap
roomMap()
{
  CompactMap map;
  map.planes = {patchOf({-2, 1.25, 0}, {4, 0, 0}, {0, 0, 20}),
                patchOf({-2, 1.25, 0}, {0, 0, 20}, {0, -2.5, 0}),
                patchOf({2, 1.25, 20}, {0, 0, -20}, {0, -2.5, 0}),
                patchOf({-2, 1.25, 20}, {4, 0, 0}, {0, -2.5, 0})};
  return map;
}

MappedTrajectory
trueWay()
{
  const Trajectory way = roomWay();
  return {{0, 1, 2, 3, 4}, way.poses, way.poses};
}

} // namespace pcl::acmap::test
