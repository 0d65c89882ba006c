#include "layer_keys.h"

#include "layer_actors.h"

#include <pcl/core/exceptions.h>
#include <pcl/visualization/plane_card.h>

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iterator>

namespace pcl::acmap {

namespace {

constexpr int tick = 40;              // milliseconds
constexpr double slide_seconds = 1.6; // from before to after rectification

const char* const layer_help =
    "1 to 7, or a click on a name: a layer on and off\n"
    "left button: turn   middle: move   right, wheel: nearer and farther\n"
    "r: all in view   w, s: wires, surfaces\n"
    "m: measure between points, between planes, end\n"
    "p or shift and click: the card of the plane under the mouse\n"
    "t: planes with and without texture\n"
    "b: before and after rectification\n"
    "space: fly along the trajectory, and stop\n"
    "n, N: next and previous step of the walls that made the mesh\n"
    "h: this help, on and off   q: end\n";

const char* const hint = "left: turn   middle: move   wheel: zoom   m: measure   "
                         "p: what is this   h: help   q: end";

Color
colorOf(SceneLayer layer)
{
  switch (layer) {
  case SceneLayer::Points:
    return {0.20, 0.40, 0.70};
  case SceneLayer::Mesh:
    return {0.60, 0.60, 0.58};
  case SceneLayer::Normals:
    return {0.10, 0.55, 0.25};
  case SceneLayer::Planes:
    return {0.95, 0.60, 0.25};
  case SceneLayer::Texture:
    return {0.55, 0.40, 0.30};
  case SceneLayer::Trajectory:
    return trajectory_color;
  case SceneLayer::Proposed:
    break;
  }
  return {0.36, 0.56, 0.84};
}

/** "998 507" */
std::string
grouped(std::size_t count)
{
  std::string text = std::to_string(count);
  for (std::size_t i = text.size(); i > 3; i -= 3)
    text.insert(i - 3, " ");
  return text;
}

/** Does a plane lie in a side of a box? */
bool
isSideOf(const BoxPatch& box, std::size_t plane)
{
  return std::any_of(box.faces.begin(), box.faces.end(), [&](const BoxFace& face) {
    return face.kind == BoxFaceKind::Seen &&
           static_cast<std::size_t>(face.plane) == plane;
  });
}

} // namespace

std::string
describeScene(const LayeredScene& scene)
{
  std::string text;
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0)
      text += (text.empty() ? "" : ", ") + grouped(count) + " " + what +
              (count > 1 ? "s" : "");
  };
  add(countOf(scene, SceneLayer::Points), "point");
  add(scene.mesh.triangles.size(), "triangle");
  add(scene.map.planes.size(), "plane");
  add(scene.map.cylinders.size(), "cylinder");
  add(scene.map.trajectory.poses.size(), "pose");
  return text;
}

vtkStandardNewMacro(LayerKeys);

void
LayerKeys::attach(LayerStage& stage,
                  const LayeredScene& scene,
                  Overlay& overlay,
                  const std::function<void(const std::string&)>& tell)
{
  stage_ = &stage;
  scene_ = &scene;
  overlay_ = &overlay;
  tell_ = tell;
  replay_.emplace(stage);
  measuring_.emplace(stage, scene.map);
  overlay.setCamera(stage.renderer());
  overlay.setHint(hint);
  showRows();
}

void
LayerKeys::OnChar()
{
  const char key = Interactor->GetKeyCode();
  if (key >= '1' && key <= '7')
    attempt([&] { toggle(static_cast<SceneLayer>(key - '0')); });
  else if (key == 'b')
    attempt([&] { toggleBefore(); });
  else if (key == 't')
    attempt([&] { toggleTexture(); });
  else if (key == 'n')
    attempt([&] { stepOn(); });
  else if (key == 'N')
    attempt([&] { stepBack(); });
  else if (key == ' ')
    attempt([&] { toggleFlight(); });
  else if (key == 'p')
    showCard();
  else if (key == 'h')
    toggleHelp();
  else if (key == 'm')
    measureNext();
  else if (key == 'r')
    attempt([&] { stage_->lookAtAll(); });
  else if (std::strchr("wsqe", key))
    vtkInteractorStyleTerrain::OnChar();
}

void
LayerKeys::OnTimer()
{
  if (slide_) {
    advanceSlide();
    return;
  }
  if (!replay_ || !replay_->isRunning()) {
    vtkInteractorStyleTerrain::OnTimer();
    return;
  }
  replay_->advance(tick / 1000.0);
  caption(replay_->describe());
  if (!replay_->isRunning()) {
    stopFlight();
    say("end of the trajectory\n");
  }
  Interactor->Render();
}

void
LayerKeys::OnLeftButtonDown()
{
  const int* const place = Interactor->GetEventPosition();
  pressed_.reset();
  if (Interactor->GetShiftKey())
    showCard();
  else if (!clickPanel(place[0], place[1])) {
    pressed_ = {place[0], place[1]};
    stage_->standUpright();
    vtkInteractorStyleTerrain::OnLeftButtonDown();
  }
}

void
LayerKeys::OnLeftButtonUp()
{
  constexpr int still = 3; // pixels: a click, not a turn
  vtkInteractorStyleTerrain::OnLeftButtonUp();
  const int* const place = Interactor->GetEventPosition();
  if (measuring_->between() == Measuring::Between::Nothing || !pressed_ ||
      std::abs(place[0] - (*pressed_)[0]) > still ||
      std::abs(place[1] - (*pressed_)[1]) > still)
    return;
  measuring_->pick(place[0], place[1]);
  caption(measuring_->told());
  Interactor->Render();
}

void
LayerKeys::attempt(const std::function<void()>& deed)
{
  try {
    deed();
  }
  // exceptions must not propagate through the event loop of the window
  catch (const PCLException& e) {
    say(std::string(e.what()) + "\n");
  }
  showRows();
  Interactor->Render();
}

void
LayerKeys::toggle(SceneLayer layer)
{
  stage_->show(layer, !stage_->isShown(layer));
}

void
LayerKeys::toggleBefore()
{
  const bool before = stage_->act() == Act::Before;
  stage_->play(before ? Act::Map : Act::Before);
  stopFlight();
  replay_->leave();
  startSlide(!before);
  caption(before ? "after rectification" : "before rectification");
  say(before ? "after rectification\n" : "before rectification\n");
}

void
LayerKeys::startSlide(bool to_before)
{
  if (slide_)
    stage_->endSlide();
  slide_ = Slide{0, to_before};
  startTimer();
}

void
LayerKeys::advanceSlide()
{
  slide_->time += tick / 1000.0;
  const double t = std::min(1.0, slide_->time / slide_seconds);
  const double smooth = t * t * (3 - 2 * t);
  if (t < 1)
    stage_->slide(slide_->to_before ? 1 - smooth : smooth);
  else {
    slide_.reset();
    if (!replay_->isRunning())
      stopTimer();
    stage_->endSlide();
  }
  Interactor->Render();
}

void
LayerKeys::toggleTexture()
{
  if (stage_->act() == Act::Before)
    throw acmap::BadArgument("there is no texture before rectification");
  const bool textured = stage_->isShown(SceneLayer::Texture);
  stage_->show(textured ? SceneLayer::Planes : SceneLayer::Texture, true);
  stage_->show(textured ? SceneLayer::Texture : SceneLayer::Planes, false);
  say(textured ? "planes without texture\n" : "planes with texture\n");
}

void
LayerKeys::stepOn()
{
  const bool is_first = stage_->act() != Act::Walls;
  if (!is_first && stage_->step() + 1 == wallSteps(scene_->mesh)) {
    say("this is the last step of the walls; N goes back\n");
    return;
  }
  stage_->playStep(is_first ? 0 : stage_->step() + 1);
  say(describeWalls(scene_->mesh, stage_->step()));
}

void
LayerKeys::stepBack()
{
  if (stage_->act() != Act::Walls) {
    say("no step of the walls is shown; n shows the first\n");
    return;
  }
  if (stage_->step() > 0) {
    stage_->playStep(stage_->step() - 1);
    say(describeWalls(scene_->mesh, stage_->step()));
    return;
  }
  stage_->play(Act::Map);
  say("no step of the walls\n");
}

void
LayerKeys::toggleFlight()
{
  if (replay_->isRunning()) {
    stopFlight();
    return;
  }
  replay_->start();
  caption(replay_->describe());
  if (replay_->isRunning())
    startTimer();
}

void
LayerKeys::stopFlight()
{
  replay_->stop();
  if (!slide_)
    stopTimer();
}

void
LayerKeys::startTimer()
{
  if (timer_ == 0)
    timer_ = Interactor->CreateRepeatingTimer(tick);
}

void
LayerKeys::stopTimer()
{
  if (timer_ != 0)
    Interactor->DestroyTimer(timer_);
  timer_ = 0;
}

void
LayerKeys::showCard()
{
  const int* const place = Interactor->GetEventPosition();
  const auto plane = stage_->planeAt(place[0], place[1]);
  if (plane) {
    const CompactMap& map = scene_->map;
    const std::size_t planes = map.planes.size();
    std::string card =
        *plane < planes ? planeCard(map, *plane) : cylinderCard(map, *plane - planes);
    for (std::size_t box = 0; box < map.boxes.size(); ++box)
      if (isSideOf(map.boxes[box], *plane))
        card += boxCard(map.boxes[box], box);
    for (std::size_t recess = 0; recess < map.recesses.size(); ++recess)
      if (static_cast<std::size_t>(map.recesses[recess].leaf) == *plane)
        card += recessCard(map.recesses[recess], recess);
    caption(card.substr(0, card.size() - 1)); // without the last line break
    say(card);
  }
  else {
    caption({});
    say("no plane there\n");
  }
  Interactor->Render();
}

void
LayerKeys::toggleHelp()
{
  const bool is_shown = overlay_->hasNotice();
  overlay_->setNotice(is_shown ? "" : layer_help);
  if (!is_shown)
    say(layer_help);
  Interactor->Render();
}

void
LayerKeys::measureNext()
{
  measuring_->measureNext();
  caption(measuring_->told());
  Interactor->Render();
}

bool
LayerKeys::clickPanel(int column, int row)
{
  const auto entry = overlay_->rowAt(column, row);
  if (!entry)
    return false;
  const std::set<SceneLayer> layers = layersOf(*scene_);
  attempt([&] { toggle(*std::next(layers.begin(), static_cast<long>(*entry))); });
  return true;
}

void
LayerKeys::showRows()
{
  std::vector<LayerRow> rows;
  for (const SceneLayer layer : layersOf(*scene_))
    rows.push_back({static_cast<char>('0' + static_cast<int>(layer)),
                    nameOf(layer),
                    grouped(countOf(*scene_, layer)),
                    colorOf(layer),
                    stage_->isShown(layer)});
  overlay_->setRows(rows);
}

void
LayerKeys::say(const std::string& text)
{
  if (tell_)
    tell_(text);
}

} // namespace pcl::acmap
