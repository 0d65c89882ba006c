#include <pcl/core/exceptions.h>
#include <pcl/core/trajectory.h>

#include "files/byte_source.h"
#include "files/text_number.h"
#include "files/trajectory_text.h"

#include <pcl/core/output_file.h>

#include <array>
#include <cmath>

namespace pcl {

namespace {

constexpr double rotation_slack = 0.01; // tolerance of a length that should be 1

using Row = std::array<double, 8>; // stamp tx ty tz qx qy qz qw

Row
readRow(std::string_view line, const acmap::ByteSource& source)
{
  Row row{};
  std::size_t count = 0;
  acmap::Words words(line);
  for (std::string_view word; words.next(word); ++count) {
    double value = 0;
    if (!acmap::parseNumber(word, value) || !std::isfinite(value))
      source.failAtLine(acmap::inQuotes(word) + " is no finite number");
    if (count < row.size())
      row[count] = value;
  }
  if (count != row.size())
    source.failAtLine("has " + std::to_string(count) +
                      " numbers, 8 are needed: stamp tx ty tz qx qy qz qw");
  return row;
}

void
appendRow(const Row& row, const acmap::ByteSource& source, Trajectory& trajectory)
{
  const Eigen::Quaterniond rotation(row[7], row[4], row[5], row[6]);
  const double length = rotation.norm();
  if (!(std::abs(length - 1.0) <= rotation_slack))
    source.failAtLine("the quaternion has length " + acmap::textOf(length) +
                      ", that of a rotation has 1");
  Eigen::Isometry3d pose(rotation.normalized());
  pose.translation() = Eigen::Vector3d(row[1], row[2], row[3]);
  trajectory.stamps.push_back(row[0]);
  trajectory.poses.push_back(pose);
}

std::string
textOfRow(double stamp, const Eigen::Isometry3d& pose)
{
  Eigen::Quaterniond rotation(pose.linear());
  rotation.normalize();
  if (rotation.w() < 0.0)
    rotation.coeffs() = -rotation.coeffs();
  const Eigen::Vector3d place = pose.translation();
  std::string text = acmap::textOf(stamp);
  for (const double value : {place.x(),
                             place.y(),
                             place.z(),
                             rotation.x(),
                             rotation.y(),
                             rotation.z(),
                             rotation.w()})
    text += " " + acmap::textOf(value + 0.0); // avoids -0
  return text + "\n";
}

} // namespace

Trajectory
acmap::readTrajectory(ByteSource& source)
{
  Trajectory trajectory;
  for (std::string_view line; source.readLine(line);) {
    line = line.substr(0, line.find('#'));
    std::string_view word;
    if (Words(line).next(word))
      appendRow(readRow(line, source), source, trajectory);
  }
  if (trajectory.poses.empty())
    source.fail("has no row of stamp tx ty tz qx qy qz qw");
  return trajectory;
}

Trajectory
loadTrajectory(const std::string& path)
{
  acmap::ByteSource source(path);
  return acmap::readTrajectory(source);
}

void
acmap::requireTrajectory(const Trajectory& trajectory)
{
  if (trajectory.stamps.size() != trajectory.poses.size())
    throw acmap::BadArgument("a trajectory of " +
                             std::to_string(trajectory.poses.size()) + " poses has " +
                             std::to_string(trajectory.stamps.size()) + " stamps");
  for (std::size_t i = 0; i < trajectory.poses.size(); ++i)
    if (!std::isfinite(trajectory.stamps[i]) || !isRigid(trajectory.poses[i]))
      throw acmap::BadArgument("pose " + std::to_string(i) +
                               " of a trajectory is no rigid motion, or its stamp "
                               "is not finite");
}

std::string
acmap::trajectoryText(const Trajectory& trajectory)
{
  requireTrajectory(trajectory);
  std::string text = "# stamp tx ty tz qx qy qz qw (T_map_camera; seconds, metres)\n";
  for (std::size_t i = 0; i < trajectory.poses.size(); ++i)
    text += textOfRow(trajectory.stamps[i], trajectory.poses[i]);
  return text;
}

void
saveTrajectory(const std::string& path, const Trajectory& trajectory)
{
  const std::string text = acmap::trajectoryText(trajectory);
  acmap::OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

} // namespace pcl
