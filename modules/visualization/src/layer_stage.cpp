#include "layer_stage.h"

#include "flight.h"
#include "layer_actors.h"
#include "map_drawing.h"
#include "map_faces.h"
#include "picture.h"
#include "scene_renderer.h"

#include <pcl/core/box_sides.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/map_pictures.h>

#include <algorithm>

namespace pcl {

namespace {

bool
hasPoints(const PCLPointCloud2& cloud)
{
  return cloud.width != 0 && cloud.height != 0;
}

bool
hasColors(const TexturePicture* picture)
{
  return !picture->colors.values.empty();
}

bool
hasFreeSides(const BoxPatch& box)
{
  return !freeSidesOf(box).empty();
}

/** \brief Prepares a view with at_pose; other views are unchanged.
 * \throws BadArgumentException when it sets two camera positions */
LayeredView
withoutPose(LayeredView view)
{
  if (!view.at_pose)
    return view;
  if (view.from || view.look || view.place != MapView::Place::Outside)
    throw acmap::BadArgument("a view from a pose has no other place of the eye");
  view.place = MapView::Place::Inside; // back faces are visible there
  return view;
}

} // namespace

std::set<SceneLayer>
layersOf(const LayeredScene& scene)
{
  std::set<SceneLayer> layers;
  if (hasPoints(scene.points) || hasPoints(scene.vertices))
    layers.insert(SceneLayer::Points);
  if (!scene.mesh.triangles.empty())
    layers.insert({SceneLayer::Mesh, SceneLayer::Normals});
  if (!scene.map.planes.empty() || !scene.map.cylinders.empty())
    layers.insert(SceneLayer::Planes);
  const auto pictures = acmap::picturesOf(scene.map);
  if (std::any_of(pictures.begin(), pictures.end(), hasColors))
    layers.insert(SceneLayer::Texture);
  if (!scene.map.trajectory.poses.empty())
    layers.insert(SceneLayer::Trajectory);
  if (std::any_of(scene.map.planes.begin(),
                  scene.map.planes.end(),
                  [](const PlanePatch& plane) { return !plane.proposed.empty(); }) ||
      std::any_of(scene.map.boxes.begin(), scene.map.boxes.end(), hasFreeSides))
    layers.insert(SceneLayer::Proposed);
  return layers;
}

std::set<SceneLayer>
usualLayers(const LayeredScene& scene)
{
  const std::set<SceneLayer> all = layersOf(scene);
  std::set<SceneLayer> usual;
  for (const SceneLayer layer :
       {SceneLayer::Texture, SceneLayer::Planes, SceneLayer::Mesh, SceneLayer::Points})
    if (usual.empty() && all.count(layer) != 0)
      usual.insert(layer);
  if (all.count(SceneLayer::Trajectory) != 0)
    usual.insert(SceneLayer::Trajectory);
  return usual;
}

namespace acmap {

LayerStage::LayerStage(const LayeredScene& scene, const LayeredView& view)
: scene_(scene)
, view_(withoutPose(view))
{
  std::set<SceneLayer> all = layersOf(scene);
  all.erase(SceneLayer::Trajectory); // alone it does not show a scene
  if (all.empty())
    throw acmap::InitFailed("nothing to show: the scene has no points and no planes");
  if (view.before && view.wall_step)
    throw acmap::BadArgument("the walls have no steps before rectification");
  if (!scene.map.planes.empty() || !scene.map.cylinders.empty())
    drawing_.emplace(scene.map, view_);
  else if (view.place == MapView::Place::Inside ||
           (view.place == MapView::Place::Plan && scene.map.trajectory.poses.empty()))
    throw acmap::BadArgument("a view from inside needs planes, a plan planes or a "
                             "trajectory, and there are none");
  camera_ = drawing_ ? drawing_->camera() : cameraOf(scene, view_);
  renderer_ = makeStage(camera_, true);

  shown_[Act::Map] = usualLayers(scene);
  shown_[Act::Before] = layersBefore(scene);
  shown_[Act::Walls] = {SceneLayer::Mesh};
  const Act first = view.before ? Act::Before : view.wall_step ? Act::Walls : Act::Map;
  require(first);
  if (!view.layers.empty())
    shown_[first].clear();
  act_ = first;
  for (const SceneLayer layer : view.layers)
    show(layer, true);
  if (view.wall_step)
    playStep(*view.wall_step);
  else
    play(first);
  if (view.at_pose)
    lookFrom(*view.at_pose);
}

void
LayerStage::require(Act act) const
{
  if (act == Act::Before && layersBefore(scene_).empty())
    throw acmap::BadArgument(
        scene_.trajectory_before.poses.empty()
            ? "there is nothing to show as before rectification: no trajectory_before"
            : "there is nothing to show as before rectification: " +
                  std::to_string(scene_.trajectory_before.poses.size()) +
                  " poses before, " +
                  std::to_string(scene_.map.trajectory.poses.size()) + " after");
  if (act == Act::Walls && wallSteps(scene_.mesh) == 0)
    throw acmap::BadArgument("there is no step of walls to show: no mesh that has "
                             "wall depths of more than one "
                             "step");
}

void
LayerStage::play(Act act)
{
  require(act);
  for (const SceneLayer layer : shown_[act])
    prepare(act, layer);
  act_ = act;
  update();
}

void
LayerStage::playStep(std::size_t step)
{
  require(Act::Walls);
  const std::size_t steps = wallSteps(scene_.mesh);
  if (step >= steps)
    throw acmap::BadArgument("there is no step " + std::to_string(step) +
                             " of the walls: they count from 0 to " +
                             std::to_string(steps - 1));
  auto& old = layers_[{Act::Walls, SceneLayer::Mesh}];
  if (old)
    renderer_->RemoveActor(old);
  old = nullptr;
  step_ = step;
  play(Act::Walls);
}

bool
LayerStage::isShown(SceneLayer layer) const
{
  return shown_.at(act_).count(layer) != 0;
}

void
LayerStage::show(SceneLayer layer, bool on)
{
  static const char* const names[] = {
      "points", "mesh", "normals", "planes", "texture", "trajectory", "proposed"};
  if (layersOfAct(act_).count(layer) == 0)
    throw acmap::BadArgument(std::string("there is nothing to show as ") +
                             names[static_cast<int>(layer) - 1] +
                             (act_ == Act::Before ? " before rectification" : ""));
  if (on)
    prepare(act_, layer);
  if (on)
    shown_[act_].insert(layer);
  else
    shown_[act_].erase(layer);
  update();
}

std::set<SceneLayer>
LayerStage::layersOfAct(Act act) const
{
  return act == Act::Before ? layersBefore(scene_) : layersOf(scene_);
}

LayerStage::Place
LayerStage::placeOf(Act act, SceneLayer layer)
{
  const bool differs =
      act == Act::Before || (act == Act::Walls && layer == SceneLayer::Mesh);
  return {differs ? act : Act::Map, layer};
}

void
LayerStage::prepare(Act act, SceneLayer layer)
{
  const Place place = placeOf(act, layer);
  if (layers_[place])
    return;
  const LayerMaking making = {scene_, view_, drawing_ ? &*drawing_ : nullptr, camera_};
  const auto assembly =
      assemblyOf(place.first == Act::Before  ? actorsBefore(making, layer)
                 : place.first == Act::Walls ? actorsOfStep(making, step_)
                                             : actorsOfLayer(making, layer));
  renderer_->AddActor(assembly);
  layers_[place] = assembly;
}

void
LayerStage::update()
{
  for (const auto& [place, assembly] : layers_)
    if (assembly)
      assembly->SetVisibility(place == placeOf(act_, place.second) &&
                              isShown(place.second));
  const bool has_surface = drawing_ || !scene_.mesh.triangles.empty();
  setBackground((has_surface && act_ != Act::Before) ||
                    view_.place == MapView::Place::Plan,
                renderer_);
}

const Trajectory&
LayerStage::trajectory() const
{
  return act_ == Act::Before ? scene_.trajectory_before : scene_.map.trajectory;
}

void
LayerStage::lookFrom(std::size_t pose)
{
  const auto& poses = trajectory().poses;
  if (pose >= poses.size())
    throw acmap::BadArgument("there is no pose " + std::to_string(pose) +
                             " to look from, of " + std::to_string(poses.size()));
  if (!poses[pose].matrix().allFinite())
    throw acmap::BadArgument("pose " + std::to_string(pose) + " is not finite");
  look(cameraAt(poses[pose]));
}

void
LayerStage::look(const Camera& camera)
{
  if (view_.place == MapView::Place::Plan) {
    // points that were cut for the plan are needed when the camera moves through the
    // scene
    view_.place = MapView::Place::Outside;
    for (auto& [place, assembly] : layers_)
      if (place.second == SceneLayer::Points && assembly) {
        renderer_->RemoveActor(assembly);
        assembly = nullptr;
      }
    play(act_);
  }
  setCamera(camera, renderer_);
  renderer_->ResetCameraClippingRange();
}

std::optional<std::size_t>
LayerStage::planeAt(double column, double row) const
{
  if (!drawing_ || act_ == Act::Before)
    return {};
  const auto at = [&](double depth) -> Eigen::Vector3d {
    double point[4];
    renderer_->SetDisplayPoint(column, row, depth);
    renderer_->DisplayToWorld();
    renderer_->GetWorldPoint(point);
    return Eigen::Vector3d(point[0], point[1], point[2]) / point[3];
  };
  const Eigen::Vector3d eye = at(0);
  const auto hit =
      firstHit(drawing_->drawnFaces(), eye, at(1) - eye, drawing_->hidesBacks());
  if (!hit)
    return {};
  return hit->plane;
}

void
LayerStage::addPictureMarks()
{
  if (view_.place != MapView::Place::Plan)
    return;
  if (drawing_ && act_ == Act::Map)
    drawing_->addPlanTo(renderer_);
  else
    addScaleBar(camera_, view_, renderer_);
}

} // namespace acmap
} // namespace pcl
