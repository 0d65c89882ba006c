#pragma once

#include "camera.h"

#include <pcl/visualization/mesh_snapshot.h>

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <string>

namespace pcl::acmap {

/** \brief An empty scene with lights and a camera.
 * \param[in] light bright background, for surfaces; points need a dark one */
vtkSmartPointer<vtkRenderer>
makeStage(const Camera& camera, bool light);

/** \brief Sets a bright background for surfaces or a dark one for points. */
void
setBackground(bool light, vtkRenderer* renderer);

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
