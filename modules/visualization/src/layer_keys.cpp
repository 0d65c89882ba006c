#include "layer_keys.h"

#include <pcl/exceptions.h>
#include <pcl/visualization/plane_card.h>

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkTextProperty.h>

namespace pcl::acmap {

const char* const layer_help =
    "1 points   2 mesh   3 normals   4 planes   5 texture   "
    "6 trajectory: on and off\n"
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
  if (key >= '1' && key <= '6')
    toggle(static_cast<SceneLayer>(key - '0'));
  else if (key == 'p')
    showCard();
  else if (key == 'h')
    say(layer_help);
  else
    vtkInteractorStyleTrackballCamera::OnChar();
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
LayerKeys::toggle(SceneLayer layer)
{
  try {
    stage_->show(layer, !stage_->isShown(layer));
  }
  // an exception must not pass through the window's loop
  catch (const PCLException& e) {
    say(std::string(e.what()) + "\n");
  }
  Interactor->Render();
}

void
LayerKeys::showCard()
{
  const int* const place = Interactor->GetEventPosition();
  const auto plane = stage_->planeAt(place[0], place[1]);
  if (plane) {
    const std::string card = planeCard(scene_->map.planes[*plane], *plane);
    card_->SetInput(card.substr(0, card.size() - 1).c_str()); // no empty last line
    say(card);
  }
  else
    say("no plane there\n");
  card_->SetVisibility(plane.has_value());
  Interactor->Render();
}

void
LayerKeys::say(const std::string& text)
{
  if (tell_)
    tell_(text);
}

} // namespace pcl::acmap
