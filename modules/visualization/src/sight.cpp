#include "sight.h"

#include "ray.h"

#include <Eigen/Geometry>

namespace pcl::acmap {
namespace {

using Eigen::Vector3d;

/** Maximum number of poses of a trajectory that are tried. */
constexpr std::size_t max_poses = 16;

double
freeWay(const std::vector<MapFaces>& faces, const Vector3d& eye, const Vector3d& ahead)
{
  const auto hit = firstHit(faces, eye, ahead, false);
  // a ray that leaves through a gap in the walls does not count
  return hit ? hit->distance : 0;
}

std::vector<Vector3d>
eyesOf(const Trajectory& trajectory, const Vector3d& middle)
{
  std::vector<Vector3d> eyes;
  const std::size_t step = trajectory.poses.size() / max_poses + 1;
  for (std::size_t i = 0; i < trajectory.poses.size(); i += step)
    if (trajectory.poses[i].matrix().allFinite())
      eyes.push_back(trajectory.poses[i].translation());
  if (eyes.empty())
    eyes.push_back(middle);
  return eyes;
}

} // namespace

Sight
longestSight(const Trajectory& trajectory,
             const std::vector<MapFaces>& faces,
             const Vector3d& middle,
             const MapFrame& frame)
{
  const Vector3d across = frame.up.cross(frame.along);
  const std::vector<Vector3d> eyes = eyesOf(trajectory, middle);
  Sight best = {eyes[0], frame.along};
  double farthest = 0;
  for (const Vector3d& eye : eyes)
    for (const Vector3d& ahead :
         {frame.along, Vector3d(-frame.along), across, Vector3d(-across)})
      // also looks slightly to each side, so that a narrow gap does not win
      if (const double way =
              freeWay(faces, eye, ahead) +
              freeWay(faces, eye, (ahead + 0.1 * frame.up.cross(ahead)).normalized()) +
              freeWay(faces, eye, (ahead - 0.1 * frame.up.cross(ahead)).normalized());
          way > farthest * (1 + 1e-6)) {
        farthest = way;
        best = {eye, ahead};
      }
  return best;
}

} // namespace pcl::acmap
