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

/** \brief What the keys of a window with layers do. */
extern const char* const layer_help;

/** \brief Lets keys turn layers off and on, show the card of a plane, what was before
 * rectification, the steps of the walls, and fly along the trajectory. */
class LayerKeys : public vtkInteractorStyleTrackballCamera {
public:
  static LayerKeys*
  New();

  vtkTypeMacro(LayerKeys, vtkInteractorStyleTrackballCamera);

  /** \param[in] stage, scene live as long
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
  /** \brief Does what may not be possible, and says so where it is not. */
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

  /** \brief Shows text in the corner; none hides it. */
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
