#pragma once

#include "map_drawing.h"
#include "scene.h"

#include <pcl/visualization/layered_scene.h>

#include <vtkAssembly.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <map>
#include <optional>

namespace pcl::acmap {

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

  bool
  isShown(SceneLayer layer) const;

  /** \throws BadArgumentException when the scene has nothing for the layer */
  void
  show(SceneLayer layer, bool on);

  /** \brief The plane seen at a pixel, counted from the lower left. */
  std::optional<std::size_t>
  planeAt(double column, double row) const;

  /** \brief What only pictures have, as their eye does not move. */
  void
  addPictureMarks();

private:
  Actors
  make(SceneLayer layer) const;

  Scene
  sceneOf(const PCLPointCloud2& cloud, const TriangleMesh& mesh) const;

  /** \brief The cloud that stands for the layer of the points. */
  const PCLPointCloud2&
  cloud() const;

  Camera
  cameraOfScene() const;

  bool
  hidesCeilings() const;

  const LayeredScene& scene_;
  LayeredView view_;
  std::optional<MapDrawing> drawing_; ///< where there are planes
  Camera camera_;
  vtkSmartPointer<vtkRenderer> renderer_;
  std::map<SceneLayer, vtkSmartPointer<vtkAssembly>> layers_;
};

} // namespace pcl::acmap
