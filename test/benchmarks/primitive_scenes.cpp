#include "primitive_scenes.h"

#include "simulated_clouds.h"

#include <pcl/pipeline/plane_mapping.h>

#include <algorithm>
#include <map>
#include <memory>
#include <variant>

namespace pcl::acmap::bench {

std::vector<SceneBox>
boxesOf(const SimulatedScene& scene)
{
  const std::array<std::string, 6> names{
      " right", " left", " bottom", " top", " back", " front"};
  std::map<std::string, SceneBox> boxes;
  for (const TruthPlane& plane : scene.geometry.planes())
    for (std::size_t face = 0; face < names.size(); ++face) {
      const std::string& ending = names[face];
      if (plane.name.size() <= ending.size() ||
          plane.name.compare(
              plane.name.size() - ending.size(), ending.size(), ending) != 0)
        continue;
      const std::string name = plane.name.substr(0, plane.name.size() - ending.size());
      SceneBox& box = boxes[name];
      box.name = name;
      box.has_face[face] = true;
      for (const SimulatedRectangle& one : plane.rectangles)
        box.place.extend(one.corner)
            .extend(Eigen::Vector3d(one.corner + one.edge_u + one.edge_v));
    }
  constexpr std::size_t top = 3;
  std::vector<SceneBox> list;
  for (const auto& [name, box] : boxes)
    if (box.has_face[top])
      list.push_back(box);
  return list;
}

SimulatedScene
withoutSurfaces(SimulatedScene scene,
                const std::function<bool(const std::string& name)>& is_left_out,
                bool keeps_cylinders)
{
  SceneGeometry kept;
  const std::vector<TruthPlane>& planes = scene.geometry.planes();
  for (const SimulatedSurface& surface : scene.geometry.surfaces()) {
    const auto* const cylinder = std::get_if<SimulatedCylinder>(&surface.shape);
    if (cylinder && keeps_cylinders)
      kept.addCylinder(surface.name, *cylinder, surface.look, false);
    const auto* const shape = std::get_if<SimulatedRectangle>(&surface.shape);
    if (shape && !is_left_out(surface.name))
      kept.addRectangle(surface.name,
                        planes[static_cast<std::size_t>(surface.plane)].name,
                        *shape,
                        surface.look);
  }
  scene.geometry = kept;
  return scene;
}

SimulatedScene
withoutBoxes(const SimulatedScene& scene)
{
  const std::vector<SceneBox> boxes = boxesOf(scene);
  const auto isOfBox = [&](const std::string& name) {
    return std::any_of(boxes.begin(), boxes.end(), [&](const SceneBox& box) {
      return name.compare(0, box.name.size() + 1, box.name + " ") == 0;
    });
  };
  return withoutSurfaces(scene, isOfBox, false);
}

bool
isInSight(const SimulatedScene& scene, const Eigen::Vector3d& place)
{
  const TrinocularRig& rig = scene.rig;
  return std::any_of(
      scene.views.begin(), scene.views.end(), [&](const Eigen::Isometry3d& view) {
        const Eigen::Vector3d at = view.inverse() * place;
        const double column = rig.focal_length * at.x() / at.z() + rig.center_x,
                     row = rig.focal_length * at.y() / at.z() + rig.center_y;
        return at.z() > 0 && at.z() < scene.sensor.reach && column > 0 &&
               column < rig.width && row > 0 && row < rig.height;
      });
}

const CylinderPatch*
patchOf(const Eigen::Vector3d& point,
        const Eigen::Vector3d& axis,
        double radius,
        const std::vector<CylinderPatch>& patches)
{
  constexpr double parallel = 0.99; // 8 degrees
  const double tolerance = 0.25 * radius;
  const auto found =
      std::find_if(patches.begin(), patches.end(), [&](const CylinderPatch& patch) {
        return std::abs(axis.dot(patch.axis_direction)) > parallel &&
               std::abs(patch.radius - radius) < tolerance &&
               distanceToAxis(patch.axis_point, point, axis) < tolerance;
      });
  return found == patches.end() ? nullptr : &*found;
}

MappedPlanes
mapScene(const SimulatedScene& scene, bool searches_cylinders)
{
  const SimulatedCloud cloud = makeSceneCloud(scene);
  const auto file = std::make_shared<PointCloudFile>();
  file->cloud = cloudOf(cloud.merged);
  PlaneMapping mapping;
  mapping.setInputCloud(std::shared_ptr<const PointCloudFile>(file));
  mapping.setViewpoints(cloud.sensorOrigins());
  mapping.setComputeCylinders(searches_cylinders);
  MappedPlanes mapped;
  mapping.compute(mapped);
  return mapped;
}

} // namespace pcl::acmap::bench
