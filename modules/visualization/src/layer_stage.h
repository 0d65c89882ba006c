#pragma once

#include "map_drawing.h"
#include "scene.h"

#include <pcl/visualization/layered_scene.h>

#include <vtkAssembly.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <map>
#include <optional>
#include <set>

namespace pcl::acmap {

/** \brief What is on the stage; each act has shown layers of its own. */
enum class Act {
  Map,    ///< the scene as it is
  Before, ///< as it was before rectification
  Walls   ///< a step of the making of the mesh
};

/** \brief Layers under lights and before a camera; each is made when it is first shown. */
class LayerStage {
public:
  /** \param[in] scene lives as long
   * \throws as \ref saveSnapshot of layers */
  LayerStage(const LayeredScene& scene, const LayeredView& view);

  vtkRenderer*
  renderer() const
  {
    return renderer_;
  }

  Act
  act() const
  {
    return act_;
  }

  /** \throws BadArgumentException when the scene has nothing for the act */
  void
  play(Act act);

  /** \brief Plays a step of the walls.
   * \throws BadArgumentException when there is no such step */
  void
  playStep(std::size_t step);

  std::size_t
  step() const
  {
    return step_;
  }

  /** \brief Whether it is shown in the act that is played. */
  bool
  isShown(SceneLayer layer) const;

  /** \throws BadArgumentException when the scene has nothing for the layer in this act */
  void
  show(SceneLayer layer, bool on);

  /** \brief The poses of the act that is played. */
  const Trajectory&
  trajectory() const;

  /** \brief Moves the eye; how far it sees follows from what is shown. */
  void
  look(const Camera& camera);

  /** \brief The plane seen at a pixel, counted from the lower left. */
  std::optional<std::size_t>
  planeAt(double column, double row) const;

  /** \brief What only pictures have, as their eye does not move. */
  void
  addPictureMarks();

private:
  using Place = std::pair<Act, SceneLayer>;

  std::set<SceneLayer>
  layersOfAct(Act act) const;

  /** \brief Under which act a layer is kept: acts share what looks the same in them. */
  static Place
  placeOf(Act act, SceneLayer layer);

  void
  require(Act act) const;

  void
  lookFrom(std::size_t pose);

  void
  prepare(Act act, SceneLayer layer);

  void
  update();

  const LayeredScene& scene_;
  LayeredView view_;
  std::optional<MapDrawing> drawing_; ///< where there are planes
  Camera camera_;
  vtkSmartPointer<vtkRenderer> renderer_;
  Act act_ = Act::Map;
  std::size_t step_ = 0;
  std::map<Act, std::set<SceneLayer>> shown_;
  std::map<Place, vtkSmartPointer<vtkAssembly>> layers_;
};

} // namespace pcl::acmap
