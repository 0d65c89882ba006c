#include "points_before.h"

#include "scene.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pcl {
namespace {

const PCLPointField*
viewField(const PCLPointCloud2& cloud)
{
  const PCLPointField* const field = acmap::fieldNamed(cloud, "view");
  return field && field->datatype == PCLPointField::INT32 ? field : nullptr;
}

/** \brief For each observation, the motion that undoes its rectification; NaN if a pose
 * is not finite. */
std::vector<Eigen::Isometry3f>
motionsOf(const Trajectory& after, const Trajectory& before)
{
  std::vector<Eigen::Isometry3f> motions;
  for (std::size_t i = 0; i < after.poses.size(); ++i)
    motions.push_back((before.poses[i] * after.poses[i].inverse()).cast<float>());
  return motions;
}

void
requireInside(const PCLPointField& field, const PCLPointCloud2& cloud)
{
  if (std::size_t{field.offset} + 4 > cloud.point_step ||
      cloud.data.size() < std::size_t{cloud.point_step} * cloud.width * cloud.height)
    throw BadArgumentException("field " + field.name + " is not inside of the cloud");
}

} // namespace

std::set<SceneLayer>
layersBefore(const LayeredScene& scene)
{
  std::set<SceneLayer> layers;
  const std::size_t poses = scene.trajectory_before.poses.size();
  if (poses == 0 || poses != scene.map.trajectory.poses.size())
    return layers;
  layers.insert(SceneLayer::Trajectory);
  if (scene.points.width != 0 && acmap::hasViews(scene.points))
    layers.insert(SceneLayer::Points);
  return layers;
}

namespace acmap {

bool
hasViews(const PCLPointCloud2& cloud)
{
  return viewField(cloud) != nullptr;
}

PCLPointCloud2
pointsBefore(const LayeredScene& scene)
{
  const PCLPointField* fields[4] = {};
  const char* const names[] = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis)
    fields[axis] = fieldNamed(scene.points, names[axis]);
  fields[3] = viewField(scene.points);
  for (const PCLPointField* const field : fields) {
    if (!field)
      throw BadArgumentException("points without x y z and view have no place before");
    requireInside(*field, scene.points);
  }
  PCLPointCloud2 cloud = scene.points;
  const auto motions = motionsOf(scene.map.trajectory, scene.trajectory_before);
  const std::size_t size = std::size_t{cloud.width} * cloud.height;
  for (std::size_t i = 0; i < size; ++i) {
    std::uint8_t* const bytes = cloud.data.data() + i * cloud.point_step;
    std::int32_t view = 0;
    std::memcpy(&view, bytes + fields[3]->offset, sizeof view);
    Eigen::Vector3f point;
    for (std::size_t axis = 0; axis < 3; ++axis)
      std::memcpy(&point[axis], bytes + fields[axis]->offset, sizeof(float));
    if (view < 0 || static_cast<std::size_t>(view) >= motions.size())
      point.setConstant(NAN);
    else
      point = motions[static_cast<std::size_t>(view)] * point;
    for (std::size_t axis = 0; axis < 3; ++axis)
      std::memcpy(bytes + fields[axis]->offset, &point[axis], sizeof(float));
  }
  return cloud;
}

} // namespace acmap
} // namespace pcl
