#pragma once

#include "layer_stage.h"
#include "replay.h"

#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkTextActor.h>

#include <functional>
#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief Help text for the keys of a window with layers. */
extern const char* const layer_help;

/** \brief Interactor style with keys that toggle layers, show the card of a plane,
 * the state before rectification and the steps of the walls, and fly along the
 * trajectory. */
class LayerKeys : public vtkInteractorStyleTrackballCamera {
public:
  static LayerKeys*
  New();

  vtkTypeMacro(LayerKeys, vtkInteractorStyleTrackballCamera);

  /** \param[in] stage, scene must outlive this object
   * \param[in] tell may be empty */
  void
  attach(LayerStage& stage,
         const LayeredScene& scene,
         const std::function<void(const std::string&)>& tell);

  void
  OnChar() override;

  void
  OnTimer() override;

  void
  OnLeftButtonDown() override;

private:
  /** \brief Calls a function and reports its exception, if any. */
  void
  attempt(const std::function<void()>& deed);

  void
  toggle(SceneLayer layer);

  void
  toggleBefore();

  void
  toggleTexture();

  void
  stepOn();

  void
  stepBack();

  void
  toggleFlight();

  void
  stopFlight();

  void
  showCard();

  /** \brief Shows text in the corner; an empty text hides it. */
  void
  caption(const std::string& text);

  void
  say(const std::string& text);

  LayerStage* stage_ = nullptr;
  const LayeredScene* scene_ = nullptr;
  std::function<void(const std::string&)> tell_;
  std::optional<Replay> replay_;
  int timer_ = 0;
  vtkNew<vtkTextActor> card_;
};

} // namespace pcl::acmap
