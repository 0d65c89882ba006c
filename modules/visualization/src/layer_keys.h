#pragma once

#include "layer_stage.h"

#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkTextActor.h>

#include <functional>
#include <string>

namespace pcl::acmap {

/** \brief What the keys of a window with layers do. */
extern const char* const layer_help;

/** \brief Lets keys turn layers off and on, and show the card of a plane. */
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
  OnLeftButtonDown() override;

private:
  void
  toggle(SceneLayer layer);

  void
  showCard();

  void
  say(const std::string& text);

  LayerStage* stage_ = nullptr;
  const LayeredScene* scene_ = nullptr;
  std::function<void(const std::string&)> tell_;
  vtkNew<vtkTextActor> card_;
};

} // namespace pcl::acmap
