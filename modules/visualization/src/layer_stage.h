#pragma once

#include "map_drawing.h"
#include "map_faces.h"
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

const char*
nameOf(SceneLayer layer);

/** \brief How many points, triangles, vertices, surfaces or poses a layer has. */
std::size_t
countOf(const LayeredScene& scene, SceneLayer layer);

/** \brief A place under a pixel. */
struct PickedPlace {
  Eigen::Vector3d point;              ///< metres
  std::optional<std::size_t> surface; ///< as the plane in MapFaces; none: of points
};

/** \brief Layers with lights and a camera; each layer is created when it is first
 * shown. */
class LayerStage {
public:
  /** \param[in] scene must outlive this object
   * \throws as \ref saveSnapshot of layers */
  LayerStage(const LayeredScene& scene, const LayeredView& view);

  ~LayerStage();

  LayerStage(const LayerStage&) = delete;
  LayerStage&
  operator=(const LayerStage&) = delete;

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

  /** \brief Shows the layers of before rectification on their way to where they are after
   * it, whatever the act is; \ref endSlide shows the act again.
   * \param[in] share of the way, 0 to 1
   * \throws BadArgumentException when there is no state before */
  void
  slide(double share);

  void
  endSlide();

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

  void
  look(const Camera& camera);

  /** \brief Sets the first camera again. */
  void
  lookAtAll();

  /** \brief Makes the horizon level. A view straight up or down is tilted a little, so
   * that it can be turned about the vertical. */
  void
  standUpright();

  /** \brief The plane at a pixel; pixels are counted from the lower left. */
  std::optional<std::size_t>
  planeAt(double column, double row) const;

  /** \brief The visible corner of a plane next to a pixel, else its edge there, else the
   * surface or the point under the pixel.
   * \param[in] snaps false: the surface or the point alone */
  std::optional<PickedPlace>
  placeAt(double column, double row, bool snaps) const;

  /** \brief Upwards in the scene. */
  const Eigen::Vector3d&
  up() const
  {
    return camera_.vertical;
  }

  /** \brief The layers that the current act can show. */
  std::set<SceneLayer>
  layers() const
  {
    return layersOfAct(act_);
  }

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

  /** \brief What is under a pixel at a depth, 0 at the near plane to 1 at the far one. */
  Eigen::Vector3d
  worldAt(double column, double row, double depth) const;

  /** \brief Column, row and depth of a place. */
  Eigen::Vector3d
  pixelOf(const Eigen::Vector3d& place) const;

  /** \brief Is no plane before a place? */
  bool
  isSeen(const Eigen::Vector3d& place) const;

  std::optional<RayHit>
  hitAt(double column, double row) const;

  std::optional<PickedPlace>
  snappedAt(double column, double row) const;

  void
  require(Act act) const;

  void
  lookFrom(std::size_t pose);

  void
  prepare(Act act, SceneLayer layer);

  void
  put(const Place& place, const Actors& actors);

  void
  remove(const Place& place);

  void
  update();

  /** \brief Adapts to the camera what depends on it: the clipping range, which contains
   * all visible layers, the outlines of planes that look away, and how far the mesh is
   * pushed back. */
  void
  prepareFrame();

  const LayeredScene& scene_;
  LayeredView view_;
  std::optional<MapDrawing> drawing_; ///< empty if there are no planes
  Camera camera_;
  vtkSmartPointer<vtkRenderer> renderer_;
  Act act_ = Act::Map;
  std::size_t step_ = 0;
  std::map<Act, std::set<SceneLayer>> shown_;
  std::map<Place, vtkSmartPointer<vtkAssembly>> layers_;
  Actors plane_faces_;
  /** \brief The points, with the size at which they close up. */
  std::map<Place, std::pair<vtkSmartPointer<vtkActor>, float>> points_;
  std::vector<SurfaceOutline> outlines_;
  Actors mesh_;
  double roughness_ = 0; ///< of the planes, metres
  unsigned long observer_ = 0;
};

} // namespace pcl::acmap
