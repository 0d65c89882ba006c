#include "path_reader.h"

#include "yaml_values.h"

#include <cmath>

namespace pcl::acmap {

namespace {

constexpr std::size_t max_views = 100000;
constexpr std::size_t max_steps = 1000;

using Views = std::vector<Eigen::Isometry3d>;

/** \param[in] yaw about y, radians; positive turns z towards x */
Eigen::Isometry3d
poseOf(const Eigen::Vector3d& place, double yaw)
{
  Eigen::Isometry3d pose(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitY()));
  pose.translation() = place;
  return pose;
}

/** \brief Position of view \a i of \a count along its part of the path, in [0, 1]. */
double
fractionOf(std::size_t i, std::size_t count)
{
  return count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.0;
}

void
addPose(const YamlNode& node, Views& views)
{
  node.requireKeys({"at", "yaw"});
  views.push_back(poseOf(vectorOf(node.at("at")), angleOf(node.at("yaw"))));
}

void
addLine(const YamlNode& node, Views& views)
{
  constexpr std::size_t max_yaws = 1000;
  constexpr double shortest = 1e-3; // metres
  node.requireKeys({"from", "to", "views", "yaw"});
  const Eigen::Vector3d from = vectorOf(node.at("from"));
  const Eigen::Vector3d way = vectorOf(node.at("to")) - from;
  if (std::hypot(way.x(), way.z()) < shortest)
    node.fail("the line has no direction; use turn or pose");
  const double heading = std::atan2(way.x(), way.z());
  std::vector<double> yaws;
  if (const YamlNode* const list = node.find("yaw"))
    for (const YamlNode& yaw : list->list(1, max_yaws))
      yaws.push_back(angleOf(yaw));
  else
    yaws.push_back(0.0);
  const std::size_t count = node.at("views").count(1, max_views);
  for (std::size_t i = 0; i < count; ++i)
    views.push_back(
        poseOf(from + fractionOf(i, count) * way, heading + yaws[i % yaws.size()]));
}

void
addTurn(const YamlNode& node, Views& views)
{
  node.requireKeys({"at", "from", "to", "views"});
  const Eigen::Vector3d place = vectorOf(node.at("at"));
  const double from = angleOf(node.at("from"));
  const double way = angleOf(node.at("to")) - from;
  const std::size_t count = node.at("views").count(1, max_views);
  for (std::size_t i = 0; i < count; ++i)
    views.push_back(poseOf(place, from + fractionOf(i, count) * way));
}

} // namespace

Views
readPath(const YamlNode& path)
{
  Views views;
  for (const YamlNode& item : path.list(1, max_steps)) {
    const YamlNode& key = onlyKeyOf(item);
    const YamlNode& step = item.at(key.text());
    if (key.text() == "pose")
      addPose(step, views);
    else if (key.text() == "line")
      addLine(step, views);
    else if (key.text() == "turn")
      addTurn(step, views);
    else
      key.fail("'" + key.text() + "' is no part of a path; pose, line and turn are");
    if (views.size() > max_views)
      key.fail("the path has more than " + std::to_string(max_views) + " views");
  }
  return views;
}

} // namespace pcl::acmap
