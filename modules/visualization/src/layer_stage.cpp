#include "layer_stage.h"

#include "flight.h"
#include "layer_actors.h"
#include "map_drawing.h"
#include "map_faces.h"
#include "picture.h"
#include "scale_bar.h"
#include "scene_renderer.h"
#include "snapping.h"

#include <pcl/core/box_sides.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/map_pictures.h>

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkPointPicker.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

namespace pcl {

namespace {

constexpr float size_on_surfaces = 3; // pixels of a point; it need not close up there

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
hasProposed(const PlanePatch& plane)
{
  return !plane.proposed.empty();
}

bool
hasFreeSides(const BoxPatch& box)
{
  return !freeSidesOf(box).empty();
}

/** \brief Three times the mean rmse of the planes, metres: how far a mesh and the planes
 * that were found in it are apart. */
double
roughnessOf(const CompactMap& map)
{
  constexpr double least = 0.005, most = 0.2; // metres
  double sum = 0, area = 0;
  for (const PlanePatch& plane : map.planes)
    if (std::isfinite(plane.rms * plane.area)) {
      sum += plane.rms * plane.area;
      area += plane.area;
    }
  return std::clamp(area > 0 ? 3 * sum / area : 0, least, most);
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
  if (acmap::countOf(scene, SceneLayer::Texture) > 0)
    layers.insert(SceneLayer::Texture);
  if (!scene.map.trajectory.poses.empty())
    layers.insert(SceneLayer::Trajectory);
  if (acmap::countOf(scene, SceneLayer::Proposed) > 0)
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

const char*
nameOf(SceneLayer layer)
{
  static const char* const names[] = {
      "points", "mesh", "normals", "planes", "texture", "trajectory", "proposed"};
  return names[static_cast<int>(layer) - 1];
}

std::size_t
countOf(const LayeredScene& scene, SceneLayer layer)
{
  const CompactMap& map = scene.map;
  switch (layer) {
  case SceneLayer::Points:
    return std::size_t{cloudOf(scene).width} * cloudOf(scene).height;
  case SceneLayer::Mesh:
    return scene.mesh.triangles.size();
  case SceneLayer::Normals:
    return std::size_t{scene.vertices.width} * scene.vertices.height;
  case SceneLayer::Planes:
    return map.planes.size() + map.cylinders.size();
  case SceneLayer::Texture: {
    const auto pictures = picturesOf(map);
    return static_cast<std::size_t>(
        std::count_if(pictures.begin(), pictures.end(), hasColors));
  }
  case SceneLayer::Trajectory:
    return map.trajectory.poses.size();
  case SceneLayer::Proposed:
    break;
  }
  return static_cast<std::size_t>(
             std::count_if(map.planes.begin(), map.planes.end(), hasProposed)) +
         static_cast<std::size_t>(
             std::count_if(map.boxes.begin(), map.boxes.end(), hasFreeSides));
}

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
    drawing_.emplace(scene.map, view_, pointsToSee(scene, view_));
  else if (view.place == MapView::Place::Inside ||
           (view.place == MapView::Place::Plan && scene.map.trajectory.poses.empty()))
    throw acmap::BadArgument("a view from inside needs planes, a plan planes or a "
                             "trajectory, and there are none");
  camera_ = drawing_ ? drawing_->camera() : cameraOf(scene, view_);
  renderer_ = makeStage(camera_);
  roughness_ = roughnessOf(scene.map);
  observer_ =
      renderer_->AddObserver(vtkCommand::StartEvent, this, &LayerStage::prepareFrame);

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

LayerStage::~LayerStage()
{
  renderer_->RemoveObserver(observer_);
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
  remove({Act::Walls, SceneLayer::Mesh});
  step_ = step;
  play(Act::Walls);
}

void
LayerStage::slide(double share)
{
  constexpr std::size_t most_points = 200000; // for a smooth motion
  require(Act::Before);
  const std::size_t points = std::size_t{scene_.points.width} * scene_.points.height;
  const LayerMaking making = {scene_, view_, drawing_ ? &*drawing_ : nullptr, camera_};
  const Trajectory poses = posesBetween(scene_, share);
  for (const SceneLayer layer : shown_.at(Act::Before)) {
    remove({Act::Before, layer});
    put({Act::Before, layer},
        actorsBefore(making, layer, poses, points / most_points + 1));
  }
  for (const auto& [place, assembly] : layers_)
    if (assembly)
      assembly->SetVisibility(place.first == Act::Before &&
                              shown_.at(Act::Before).count(place.second) != 0);
  shadeDepths(shown_.at(Act::Before).count(SceneLayer::Points) != 0, renderer_);
}

void
LayerStage::endSlide()
{
  for (const SceneLayer layer : layersBefore(scene_))
    remove({Act::Before, layer});
  play(act_);
}

void
LayerStage::remove(const Place& place)
{
  auto& old = layers_[place];
  if (old)
    renderer_->RemoveActor(old);
  old = nullptr;
}

void
LayerStage::put(const Place& place, const Actors& actors)
{
  const auto assembly = assemblyOf(actors);
  renderer_->AddActor(assembly);
  layers_[place] = assembly;
}

bool
LayerStage::isShown(SceneLayer layer) const
{
  return shown_.at(act_).count(layer) != 0;
}

void
LayerStage::show(SceneLayer layer, bool on)
{
  if (layersOfAct(act_).count(layer) == 0)
    throw acmap::BadArgument(std::string("there is nothing to show as ") +
                             nameOf(layer) +
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
  Actors actors = place.first == Act::Before
                      ? actorsBefore(making, layer, scene_.trajectory_before)
                  : place.first == Act::Walls ? actorsOfStep(making, step_)
                                              : actorsOfLayer(making, layer);
  if (layer == SceneLayer::Planes)
    plane_faces_ = actors;
  else if (layer == SceneLayer::Points)
    points_[place] = {actors.front(), actors.front()->GetProperty()->GetPointSize()};
  else if (layer == SceneLayer::Mesh && place.first == Act::Map)
    mesh_ = actors;
  for (const SurfaceOutline& outline : outlinesOfLayer(making, layer)) {
    actors.push_back(outline.lines);
    outlines_.push_back(outline);
  }
  put(place, actors);
}

void
LayerStage::update()
{
  for (const auto& [place, assembly] : layers_)
    if (assembly)
      assembly->SetVisibility(place == placeOf(act_, place.second) &&
                              isShown(place.second));
  const auto shows = [&](SceneLayer layer) { return isShown(layer); };
  const bool is_beneath = shows(SceneLayer::Points) || shows(SceneLayer::Mesh) ||
                          shows(SceneLayer::Texture);
  for (const auto& face : plane_faces_)
    face->GetProperty()->SetOpacity(is_beneath ? layer_opacity : 1);
  const bool is_on_surface = shows(SceneLayer::Mesh) || shows(SceneLayer::Planes) ||
                             shows(SceneLayer::Texture);
  for (const auto& [place, points] : points_)
    points.first->GetProperty()->SetPointSize(is_on_surface ? size_on_surfaces
                                                            : points.second);
  shadeDepths(shows(SceneLayer::Points), renderer_);
}

void
LayerStage::prepareFrame()
{
  constexpr double reach = 10; // times the distance of the first eye, without strays
  vtkCamera& camera = *renderer_->GetActiveCamera();
  const double around = reach * std::max((camera_.focus - camera_.position).norm(),
                                         camera_.parallel_height);
  double bounds[6];
  renderer_->ComputeVisiblePropBounds(bounds);
  for (int axis = 0; axis < 3; ++axis) {
    bounds[2 * axis] = std::max(bounds[2 * axis], camera_.focus[axis] - around);
    bounds[2 * axis + 1] = std::min(bounds[2 * axis + 1], camera_.focus[axis] + around);
  }
  if (bounds[0] <= bounds[1])
    renderer_->ResetCameraClippingRange(bounds);
  pushBack(mesh_, roughness_, camera);
  const bool hides = drawing_ && drawing_->hidesBacks();
  const Eigen::Vector3d eye(camera.GetPosition());
  for (const SurfaceOutline& outline : outlines_)
    outline.lines->SetVisibility(!hides || !outline.looksAway(eye));
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
    for (const auto& entry : layers_)
      if (entry.first.second == SceneLayer::Points)
        remove(entry.first);
    play(act_);
  }
  setCamera(camera, renderer_);
}

void
LayerStage::lookAtAll()
{
  setCamera(camera_, renderer_);
}

void
LayerStage::standUpright()
{
  constexpr double least_slant = 0.05; // radians from the vertical
  vtkCamera& camera = *renderer_->GetActiveCamera();
  const Eigen::Vector3d& up = camera_.vertical;
  const Eigen::Vector3d top(camera.GetViewUp()), focus(camera.GetFocalPoint());
  const Eigen::Vector3d ahead(camera.GetDirectionOfProjection());
  const Eigen::Vector3d heading = top - top.dot(up) * up;
  if (ahead.cross(up).norm() < least_slant && heading.norm() > least_slant) {
    const Eigen::Vector3d slanted = (ahead + 1.2 * least_slant * heading).normalized();
    camera.SetPosition(Eigen::Vector3d(focus - camera.GetDistance() * slanted).data());
  }
  camera.SetViewUp(up.data());
}

Eigen::Vector3d
LayerStage::worldAt(double column, double row, double depth) const
{
  double point[4];
  renderer_->SetDisplayPoint(column, row, depth);
  renderer_->DisplayToWorld();
  renderer_->GetWorldPoint(point);
  return Eigen::Vector3d(point[0], point[1], point[2]) / point[3];
}

Eigen::Vector3d
LayerStage::pixelOf(const Eigen::Vector3d& place) const
{
  renderer_->SetWorldPoint(place.x(), place.y(), place.z(), 1);
  renderer_->WorldToDisplay();
  return Eigen::Vector3d(renderer_->GetDisplayPoint());
}

std::optional<RayHit>
LayerStage::hitAt(double column, double row) const
{
  if (!drawing_ || act_ == Act::Before)
    return {};
  const Eigen::Vector3d eye = worldAt(column, row, 0);
  return firstHit(drawing_->drawnFaces(),
                  eye,
                  worldAt(column, row, 1) - eye,
                  drawing_->hidesBacks());
}

std::optional<std::size_t>
LayerStage::planeAt(double column, double row) const
{
  const auto hit = hitAt(column, row);
  if (!hit)
    return {};
  return hit->plane;
}

bool
LayerStage::isSeen(const Eigen::Vector3d& place) const
{
  constexpr double share = 0.99, slack = 0.03; // metres
  const Eigen::Vector3d pixel = pixelOf(place);
  const auto hit = hitAt(pixel.x(), pixel.y());
  if (!hit)
    return true;
  const Eigen::Vector3d eye = worldAt(pixel.x(), pixel.y(), 0);
  const double way = hit->distance * (worldAt(pixel.x(), pixel.y(), 1) - eye).norm();
  return way > share * (place - eye).norm() - slack;
}

std::optional<PickedPlace>
LayerStage::snappedAt(double column, double row) const
{
  if (!drawing_ || act_ == Act::Before)
    return {};
  const Eigen::Vector3d eye = worldAt(column, row, 0);
  const PixelRay ray = {{column, row}, eye, worldAt(column, row, 1) - eye};
  for (const SnapPlace& snap :
       snapPlaces(drawing_->outlineLines(), ray, [&](const auto& place) {
         return pixelOf(place);
       }))
    if (isSeen(snap.point))
      return PickedPlace{snap.point, snap.surface};
  return {};
}

std::optional<PickedPlace>
LayerStage::placeAt(double column, double row, bool snaps) const
{
  if (const auto snapped = snaps ? snappedAt(column, row) : std::nullopt)
    return snapped;
  if (const auto hit = hitAt(column, row)) {
    const Eigen::Vector3d eye = worldAt(column, row, 0);
    return PickedPlace{eye + hit->distance * (worldAt(column, row, 1) - eye),
                       hit->plane};
  }
  vtkNew<vtkPointPicker> picker;
  picker->SetTolerance(0.005); // of the diagonal of the window
  if (picker->Pick(column, row, 0, renderer_) == 0)
    return {};
  return PickedPlace{Eigen::Vector3d(picker->GetPickPosition()), {}};
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
