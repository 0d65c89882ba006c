#include "comparison/plane_overlap.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/planar_pose.h>
#include <pcl/core/trajectory_error.h>
#include <pcl/pipeline/map_comparison.h>
#include <pcl/pipeline/observation_files.h>

#include <algorithm>
#include <cmath>

namespace pcl {

using namespace acmap;

namespace {

using Poses = std::vector<Eigen::Isometry3d>;

constexpr double max_angle = 3;    // degrees
constexpr double max_offset = 0.1; // metres
constexpr double degrees = 57.29577951308232;

Poses
truePosesOf(const MappedTrajectory& trajectory, const SessionTruth& truth)
{
  if (trajectory.observations.empty() ||
      trajectory.before.size() != trajectory.observations.size() ||
      trajectory.after.size() != trajectory.observations.size())
    throw acmap::BadArgument(
        "a way has " + std::to_string(trajectory.observations.size()) +
        " observations, " + std::to_string(trajectory.before.size()) +
        " poses before and " + std::to_string(trajectory.after.size()) +
        " after; as many of each, and at least one, are legal");
  Poses poses;
  for (const std::size_t observation : trajectory.observations) {
    if (observation >= truth.trajectory.poses.size())
      throw InputFileException(truth.trajectory_path + ": has " +
                               std::to_string(truth.trajectory.poses.size()) +
                               " poses, none of them of observation " +
                               std::to_string(observation) + " of the map");
    poses.push_back(truth.trajectory.poses[observation]);
  }
  return poses;
}

std::vector<PlanarPose>
onFloor(const Poses& poses, const Eigen::Isometry3d& T_truth_map)
{
  std::vector<PlanarPose> planar;
  for (const Eigen::Isometry3d& pose : poses)
    planar.push_back(planarPartOf(T_truth_map * pose));
  return planar;
}

AbsoluteTrajectoryError
errorOf(const Poses& found,
        const Poses& truth,
        const Eigen::Isometry3d& T_truth_map = Eigen::Isometry3d::Identity())
{
  return absoluteTrajectoryError(onFloor(found, T_truth_map),
                                 onFloor(truth, Eigen::Isometry3d::Identity()));
}

/** \brief T_truth_map that aligns the first pose with the true one. */
Eigen::Isometry3d
byFirst(const Poses& found, const Poses& truth)
{
  return truth.front() * found.front().inverse();
}

/** \brief T_truth_map, a rotation and a translation on the floor, that aligns the
 * positions best. If the camera did not move, the first poses are aligned. */
Eigen::Isometry3d
byTrajectory(const Poses& found, const Poses& truth)
{
  // metres, root mean square distance from the centroid
  constexpr double shortest = 1e-3;
  const auto count = static_cast<double>(found.size());
  Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = from;
  for (std::size_t i = 0; i < found.size(); ++i) {
    from += found[i].translation() / count;
    to += truth[i].translation() / count;
  }
  double sine = 0, cosine = 0, spread = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Eigen::Vector3d a = found[i].translation() - from;
    const Eigen::Vector3d b = truth[i].translation() - to;
    sine += a.z() * b.x() - a.x() * b.z();
    cosine += a.x() * b.x() + a.z() * b.z();
    spread += (b.x() * b.x() + b.z() * b.z()) / count;
  }
  if (!(spread > shortest * shortest))
    return byFirst(found, truth);
  Eigen::Isometry3d T_truth_map = isometryOf({0, 0, std::atan2(sine, cosine)});
  Eigen::Vector3d shift = to - T_truth_map.linear() * from;
  shift.y() = 0;
  T_truth_map.translation() = shift;
  return T_truth_map;
}

/** \brief Deviation of a found plane from a true one, if they may correspond. */
std::optional<PlaneDeviation>
deviationOf(const PlacedPlane& found, const TruePlane& truth)
{
  const Eigen::Vector3d normal = truth.coefficients.head<3>();
  const Eigen::Vector3d found_normal = found.coefficients.head<3>();
  PlaneDeviation deviation;
  deviation.angle = std::atan2(normal.cross(found_normal).norm(),
                               std::abs(normal.dot(found_normal))) *
                    degrees;
  if (!(deviation.angle <= max_angle))
    return std::nullopt;
  const PlaneOverlap overlap = overlapOf(found, truth);
  deviation.overlap = overlap.area;
  deviation.offset = std::abs(normal.dot(overlap.middle) + truth.coefficients[3]);
  if (!(2 * overlap.area > found.area && deviation.offset <= max_offset))
    return std::nullopt;
  return deviation;
}

/** \brief The corresponding plane of each true plane, for all planes, main or not. */
std::vector<PlaneDeviation>
matched(const CompactMap& map,
        const std::vector<TruePlane>& planes,
        const Eigen::Isometry3d& T_truth_map)
{
  std::vector<PlaneDeviation> matches(planes.size());
  std::vector<std::vector<PlacedPlane>> pieces(planes.size());
  for (std::size_t f = 0; f < map.planes.size(); ++f) {
    const PlacedPlane found = placed(map.planes[f], T_truth_map);
    std::optional<PlaneDeviation> nearest;
    std::size_t owner = 0;
    for (std::size_t t = 0; t < planes.size(); ++t) {
      const auto deviation = deviationOf(found, planes[t]);
      if (deviation && (!nearest || deviation->offset < nearest->offset)) {
        nearest = deviation;
        owner = t;
      }
    }
    if (nearest)
      pieces[owner].push_back(found);
    if (!nearest || nearest->overlap <= matches[owner].overlap)
      continue;
    matches[owner] = *nearest;
    matches[owner].finder = f;
  }
  for (std::size_t t = 0; t < planes.size(); ++t) {
    matches[t].name = planes[t].name;
    matches[t].cover = coverOf(pieces[t], planes[t]);
  }
  return matches;
}

/** \brief The deviation of the planes. */
MapDeviation
deviationOf(const CompactMap& map,
            const SessionTruth& truth,
            const Eigen::Isometry3d& T_truth_map)
{
  const std::vector<PlaneDeviation> all = matched(map, truth.planes, T_truth_map);
  MapDeviation deviation;
  for (const std::size_t t : truth.mainPlanes()) {
    const PlaneDeviation& plane = all[t];
    deviation.planes.push_back(plane);
    if (!plane.finder)
      continue;
    ++deviation.found;
    deviation.mean_angle += plane.angle;
    deviation.mean_offset += plane.offset;
    deviation.largest_angle = std::max(deviation.largest_angle, plane.angle);
    deviation.largest_offset = std::max(deviation.largest_offset, plane.offset);
  }
  const auto count = static_cast<double>(deviation.found);
  deviation.mean_angle /= count; // NaN if there are none
  deviation.mean_offset /= count;
  if (deviation.found == 0)
    deviation.largest_angle = deviation.largest_offset = deviation.mean_angle;
  return deviation;
}

} // namespace

MapFigures
compareWithTruth(const CompactMap& map,
                 const MappedTrajectory& trajectory,
                 const SessionTruth& truth)
{
  const Poses poses = truePosesOf(trajectory, truth);
  const Eigen::Isometry3d T_truth_first = byFirst(trajectory.after, poses);
  MapFigures figures;
  figures.aligned = deviationOf(map, truth, byTrajectory(trajectory.after, poses));
  figures.aligned.ate_before = errorOf(trajectory.before, poses).aligned;
  figures.aligned.ate_after = errorOf(trajectory.after, poses).aligned;
  figures.from_first = deviationOf(map, truth, T_truth_first);
  figures.from_first.ate_before =
      errorOf(trajectory.before, poses, byFirst(trajectory.before, poses)).unaligned;
  figures.from_first.ate_after =
      errorOf(trajectory.after, poses, T_truth_first).unaligned;
  return figures;
}

MapFigures
compareWithTruth(const CompactMap& map,
                 const ObservationSequence& observations,
                 const Trajectory& before,
                 const SessionTruth& truth)
{
  const std::vector<std::size_t> rows = trajectoryRows(
      truth.trajectory_path, observations.names(), truth.trajectory.poses.size());
  const Trajectory& after = map.trajectory;
  MappedTrajectory mapped;
  for (std::size_t i = 0, row = 0; i < observations.size() && row < after.poses.size();
       ++i) {
    if (observations.stamp(i) != after.stamps[row])
      continue;
    mapped.observations.push_back(rows[i]);
    mapped.after.push_back(after.poses[row]);
    mapped.before.push_back(before.poses.empty() ? after.poses[row]
                                                 : before.poses.at(i));
    ++row;
  }
  return compareWithTruth(map, mapped, truth);
}

} // namespace pcl
