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

/** \brief The state that is shown; each act has its own set of visible layers. */
enum class Act {
  Map,    ///< the scene after rectification
  Before, ///< before rectification
  Walls   ///< a step of the construction of the mesh
};

/** \brief Layers with lights and a camera; each layer is created when it is first
 * shown. */
class LayerStage {
public:
  /** \param[in] scene must outlive this object
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

  /** \throws BadArgumentException when the scene has no data for the act */
  void
  play(Act act);

  /** \brief Shows a step of the walls.
   * \throws BadArgumentException when there is no such step */
  void
  playStep(std::size_t step);

  std::size_t
  step() const
  {
    return step_;
  }

  /** \brief Is the layer visible in the current act? */
  bool
  isShown(SceneLayer layer) const;

  /** \throws BadArgumentException when the scene has no data for the layer in this
   * act */
  void
  show(SceneLayer layer, bool on);

  /** \brief The poses of the current act. */
  const Trajectory&
  trajectory() const;

  /** \brief Sets the camera; the clipping range is computed from the visible layers. */
  void
  look(const Camera& camera);

  /** \brief The plane at a pixel; pixels are counted from the lower left. */
  std::optional<std::size_t>
  planeAt(double column, double row) const;

  /** \brief Adds annotations of a plan, which only still pictures have. */
  void
  addPictureMarks();

private:
  using Place = std::pair<Act, SceneLayer>;

  std::set<SceneLayer>
  layersOfAct(Act act) const;

  /** \brief Key under which a layer is cached: acts share layers that look the same in
   * them. */
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
  std::optional<MapDrawing> drawing_; ///< empty if there are no planes
  Camera camera_;
  vtkSmartPointer<vtkRenderer> renderer_;
  Act act_ = Act::Map;
  std::size_t step_ = 0;
  std::map<Act, std::set<SceneLayer>> shown_;
  std::map<Place, vtkSmartPointer<vtkAssembly>> layers_;
};

} // namespace pcl::acmap
