#include "layer_keys.h"

#include "layer_actors.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/surface_sentence.h>
#include <pcl/visualization/plane_card.h>

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkTextProperty.h>

#include <algorithm>

namespace pcl::acmap {

namespace {

constexpr int tick = 40; // milliseconds

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

const char* const layer_help =
    "1 points   2 mesh   3 normals   4 planes   5 texture   "
    "6 trajectory   7 proposed: on and off\n"
    "b: before and after rectification   t: planes with and without texture\n"
    "n, N: next and previous step of the walls that made the mesh\n"
    "space: fly along the trajectory, and stop\n"
    "p or shift and click: the card of the plane under the "
    "mouse\n"
    "r: all in view   w, s: wires, surfaces   h: this help   "
    "q: end\n";

vtkStandardNewMacro(LayerKeys);

void
LayerKeys::attach(LayerStage& stage,
                  const LayeredScene& scene,
                  const std::function<void(const std::string&)>& tell)
{
  constexpr int font_pixels = 16;
  constexpr int border = 12;
  stage_ = &stage;
  scene_ = &scene;
  tell_ = tell;
  replay_.emplace(stage);
  vtkTextProperty* const text = card_->GetTextProperty();
  text->SetFontFamilyToCourier();
  text->SetFontSize(font_pixels);
  text->SetColor(0.1, 0.1, 0.1);
  text->SetBackgroundColor(1, 1, 1);
  text->SetBackgroundOpacity(0.8);
  card_->SetPosition(border, border);
  card_->VisibilityOff();
  stage.renderer()->AddActor2D(card_);
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
    say(layer_help);
  else
    vtkInteractorStyleTrackballCamera::OnChar();
}

void
LayerKeys::OnTimer()
{
  if (!replay_ || !replay_->isRunning()) {
    vtkInteractorStyleTrackballCamera::OnTimer();
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
  if (Interactor->GetShiftKey())
    showCard();
  else
    vtkInteractorStyleTrackballCamera::OnLeftButtonDown();
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
  caption({});
  say(before ? "after rectification\n" : "before rectification\n");
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
    timer_ = Interactor->CreateRepeatingTimer(tick);
}

void
LayerKeys::stopFlight()
{
  replay_->stop();
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
        *plane < planes
            ? describePlane(map, *plane) + "\n" + planeCard(map.planes[*plane], *plane)
            : describeCylinder(map, *plane - planes) + "\n" +
                  cylinderCard(map.cylinders[*plane - planes], *plane - planes);
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
LayerKeys::caption(const std::string& text)
{
  card_->SetInput(text.c_str());
  card_->SetVisibility(!text.empty());
}

void
LayerKeys::say(const std::string& text)
{
  if (tell_)
    tell_(text);
}

} // namespace pcl::acmap
