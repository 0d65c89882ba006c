#pragma once

#include "camera.h"

#include <pcl/visualization/mesh_snapshot.h>

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>

namespace pcl::acmap {

/** Colour behind a scene: that of the page. */
constexpr std::array<double, 3> background = {0.914, 0.933, 0.953};

/** \brief An empty scene with lights and a camera. */
vtkSmartPointer<vtkRenderer>
makeStage(const Camera& camera);

/** \brief Darkens what lies behind its neighbours in the picture, which gives points,
 * that have no lighting, a shape. */
void
shadeDepths(bool on, vtkRenderer* renderer);

/** \brief Sets the camera of a renderer. */
void
setCamera(const Camera& camera, vtkRenderer* renderer);

/** \brief A window of the view's size with a scene, not yet rendered. */
vtkSmartPointer<vtkRenderWindow>
makeWindow(vtkRenderer* renderer, const SceneView& view);

/** \brief Draws a scene into a PNG file.
 * \throws OutputFileException */
void
savePicture(const std::string& path, vtkRenderer* renderer, const SceneView& view);

} // namespace pcl::acmap
