#include "facing_table.h"

#include <pcl/core/impl/rigid_alignment.h>
#include <pcl/mapping/impl/levelling_kernel.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl::acmap {

namespace {

using Eigen::Vector3d;
using Poses = std::vector<Eigen::Isometry3d>;
using Surfaces = std::vector<ObservedSurface>;

constexpr double many_turns = 30 * 3.14159265358979323846 / 180; // radians

/** An expected up direction, and why it is expected. */
struct Expectation {
  Vector3d up;
  std::string reason;
};

/** The mean direction of an axis of the sensors in the map; the axis itself if the
 * sensors have it in all directions. */
Vector3d
meanDirection(const Poses& poses, const Vector3d& axis)
{
  Vector3d sum = Vector3d::Zero();
  for (const Eigen::Isometry3d& pose : poses)
    sum += pose.linear() * axis;
  return sum.norm() > 0.5 * static_cast<double>(poses.size()) ? sum.normalized() : axis;
}

bool
areCameras(const Surfaces& observations)
{
  constexpr double nearly_all = 0.99;
  double weight = 0, in_front = 0;
  for (const ObservedSurface& seen : observations) {
    weight += seen.weight;
    in_front += seen.in_front;
  }
  return weight == 0 || in_front >= nearly_all * weight;
}

/** How much the sensor turned about an axis, and in total, radians. */
struct Turns {
  double about = 0, total = 0;

  double
  share() const
  {
    return total > 0 ? about / total : 0;
  }
};

Turns
turnsAbout(const Poses& poses, const Vector3d& axis)
{
  Turns turns;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const Eigen::AngleAxisd turn(
        Eigen::Matrix3d(poses[i].linear() * poses[i - 1].linear().transpose()));
    turns.total += std::abs(turn.angle());
    turns.about += std::abs(turn.angle() * turn.axis().dot(axis));
  }
  return turns;
}

/** Sum of squared distances from the mean position along an axis, square metres. */
double
movedAlong(const Poses& poses, const Vector3d& axis)
{
  Vector3d mean = Vector3d::Zero();
  for (const Eigen::Isometry3d& pose : poses)
    mean += pose.translation() / static_cast<double>(poses.size());
  double sum = 0;
  for (const Eigen::Isometry3d& pose : poses)
    sum += std::pow((pose.translation() - mean).dot(axis), 2);
  return sum;
}

/** Extent and orientation of the surfaces of a map. */
struct MapShape {
  std::vector<FacingArea> facings;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

  double
  areaAlong(const Vector3d& axis) const
  {
    constexpr double nearly = 0.97;
    double area = 0;
    for (const FacingArea& facing : facings)
      area += std::abs(facing.normal.dot(axis)) > nearly ? facing.area : 0;
    return area;
  }
};

MapShape
shapeOf(const Surfaces& observations, const Poses& poses)
{
  FacingTable facings;
  Vector3d sum = Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  double weight = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const ObservedSurface& seen = observations[i];
    const Eigen::Matrix3d turn = poses[i].linear();
    const Vector3d shift = poses[i].translation();
    for (const FacingArea& facing : seen.facings)
      facings.add(turn * facing.normal, facing.area);
    const Vector3d turned = turn * seen.sum;
    squares += turn * seen.squares * turn.transpose() + turned * shift.transpose() +
               shift * turned.transpose() + seen.weight * shift * shift.transpose();
    sum += turned + seen.weight * shift;
    weight += seen.weight;
  }
  MapShape shape{facings.facings()};
  if (weight > 0)
    shape.covariance = squares / weight - sum * sum.transpose() / (weight * weight);
  return shape;
}

/** Which of two axes of a sensor that looks around is vertical. */
Expectation
expectationOfScanners(const Poses& poses, const MapShape& map)
{
  const Vector3d z = meanDirection(poses, Vector3d::UnitZ());
  const Vector3d y = meanDirection(poses, -Vector3d::UnitY());
  const Turns about_z = turnsAbout(poses, z), about_y = turnsAbout(poses, y);
  if (about_z.total > many_turns) {
    if (about_z.share() > 0.8 && about_y.share() < 0.5)
      return {z, "the sensor turned about its z axis"};
    if (about_y.share() > 0.8 && about_z.share() < 0.5)
      return {y, "the sensor turned about its y axis"};
  }
  const double along_z = movedAlong(poses, z), along_y = movedAlong(poses, y);
  if (along_z > 1 && along_y < 0.1 * along_z)
    return {y, "the sensor did not move along its y axis"};
  if (along_y > 1 && along_z < 0.1 * along_y)
    return {z, "the sensor did not move along its z axis"};
  const bool is_thin_along_z = z.dot(map.covariance * z) < y.dot(map.covariance * y);
  return is_thin_along_z && map.areaAlong(z) > map.areaAlong(y)
             ? Expectation{z, "the map is thin along z"}
             : Expectation{y, "-y points up unless the map shows otherwise"};
}

Vector3d
nearestAxis(const Vector3d& direction)
{
  int axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return std::copysign(1.0, direction[axis]) * Vector3d::Unit(axis);
}

/** Normals of points deviate by their noise, which is symmetric. */
UpEstimate
estimateFromNormals(const std::vector<FacingArea>& facings, const Vector3d& expected)
{
  UpEstimate found = estimateUp(facings, expected, 2 * up_tolerance);
  if (found.share >= min_up_share)
    found.up = refineUp(facings, found.up, 3 * up_tolerance);
  return found;
}

/** Standard deviation of an estimated direction, radians: that of the normals, of which
 * neighbouring ones share points, by the root of their number. */
double
uncertaintyOf(const std::vector<FacingArea>& facings,
              const UpEstimate& found,
              const Surfaces& observations)
{
  constexpr double alike = 4;                   // normals that count as one
  constexpr double cell = 2 * up_tolerance / 5; // within the cells of the facings
  double squares = 0, area = 0, points = 0;
  for (const FacingArea& facing : facings) {
    const double cosine = std::min(1.0, std::abs(facing.normal.dot(found.up)));
    const double off = std::min(std::acos(cosine), std::asin(cosine));
    if (off > 3 * up_tolerance)
      continue;
    squares += facing.area * off * off;
    area += facing.area;
  }
  for (const ObservedSurface& seen : observations)
    points += static_cast<double>(seen.points - seen.invalid_points);
  return area > 0 && points > 0 ? std::sqrt((squares / area + cell * cell) /
                                            (points * found.share / alike))
                                : 0;
}

} // namespace

Eigen::Quaterniond
levelMap(const Surfaces& observations,
         const Poses& poses,
         const std::optional<Vector3d>& given,
         MapLevellingReport& report)
{
  report.observations = poses.size();
  if (given) {
    report.found = true;
    report.up = *given;
    report.reason = "it was given";
  }
  else {
    const MapShape map = shapeOf(observations, poses);
    const Expectation expected =
        areCameras(observations) ? Expectation{meanDirection(poses, -Vector3d::UnitY()),
                                               "the y axis of cameras points down"}
                                 : expectationOfScanners(poses, map);
    const UpEstimate found = estimateFromNormals(map.facings, expected.up);
    report.share = found.share;
    report.uncertainty = uncertaintyOf(map.facings, found, observations);
    report.found = found.share >= min_up_share;
    report.up = report.found ? found.up : nearestAxis(expected.up);
    report.reason = report.found
                        ? expected.reason
                        : "less than a third of the surface is horizontal or vertical "
                          "with respect to any direction near " +
                              std::string("the expected one: ") + expected.reason;
  }
  report.axis = nearestAxis(report.up);
  if (!report.found)
    report.remarks.push_back("the map was not levelled: " + report.reason);
  const double tilt = std::acos(std::min(1.0, report.up.dot(report.axis)));
  if (!given && (isLevel(report.up, report.axis) || tilt < 3 * report.uncertainty))
    report.up = report.axis;
  if (report.up == report.axis)
    return Eigen::Quaterniond::Identity();
  report.tilt = tilt;
  return smallestRotation(report.up, report.axis);
}

Vector3d
verticalOf(const Surfaces& observations,
           const Poses& poses,
           const std::optional<Vector3d>& given,
           EntropyRectificationReport& report)
{
  MapLevellingReport levelling;
  levelMap(observations, poses, given, levelling);
  report.up = levelling.up;
  report.is_up_found = levelling.found;
  report.up_reason = levelling.reason;
  const bool has_points =
      std::any_of(observations.begin(), observations.end(), [](const auto& seen) {
        return seen.points > seen.invalid_points;
      });
  if (!levelling.found && has_points) {
    std::ostringstream text;
    text << "the up direction is undetermined, " << levelling.up.transpose()
         << " is assumed (setUpDirection): " << levelling.reason;
    report.remarks.push_back(text.str());
  }
  return levelling.up;
}

} // namespace pcl::acmap
