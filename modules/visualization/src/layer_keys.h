#pragma once

#include "layer_stage.h"
#include "measuring.h"
#include "overlay.h"
#include "replay.h"

#include <vtkInteractorStyleTerrain.h>

#include <functional>
#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief What there is of a scene: "998 507 points, 13 planes". */
std::string
describeScene(const LayeredScene& scene);

/** \brief Interactor style that turns the scene about the vertical, with keys that toggle
 * layers, show the card of a plane, the state before rectification and the steps of the
 * walls, measure, and fly along the trajectory. */
class LayerKeys : public vtkInteractorStyleTerrain {
public:
  static LayerKeys*
  New();

  vtkTypeMacro(LayerKeys, vtkInteractorStyleTerrain);

  /** \param[in] stage, scene, overlay must outlive this object
   * \param[in] tell may be empty */
  void
  attach(LayerStage& stage,
         const LayeredScene& scene,
         Overlay& overlay,
         const std::function<void(const std::string&)>& tell);

  void
  OnChar() override;

  void
  OnTimer() override;

  void
  OnLeftButtonDown() override;

  void
  OnLeftButtonUp() override;

private:
  /** \brief Calls a function and reports its exception, if any. */
  void
  attempt(const std::function<void()>& deed);

  void
  toggle(SceneLayer layer);

  void
  toggleBefore();

  /** \brief Moves the points to where they were before rectification, or back. */
  void
  startSlide(bool to_before);

  void
  advanceSlide();

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

  void
  toggleHelp();

  void
  measureNext();

  /** \brief Is an entry of the panel at a pixel? Then toggles its layer. */
  bool
  clickPanel(int column, int row);

  void
  showRows();

  /** \brief Shows text in the corner; an empty text hides it. */
  void
  caption(const std::string& text)
  {
    overlay_->setCard(text);
  }

  void
  startTimer();

  void
  stopTimer();

  void
  say(const std::string& text);

  LayerStage* stage_ = nullptr;
  const LayeredScene* scene_ = nullptr;
  std::function<void(const std::string&)> tell_;
  Overlay* overlay_ = nullptr;
  std::optional<Replay> replay_;
  std::optional<Measuring> measuring_;
  int timer_ = 0;
  std::optional<std::array<int, 2>> pressed_; ///< where a turn or a click began, pixels

  struct Slide {
    double time = 0; ///< seconds
    bool to_before = false;
  };
  std::optional<Slide> slide_;
};

} // namespace pcl::acmap
