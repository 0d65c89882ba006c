#pragma once

#include <pcl/visualization/mesh_snapshot.h>

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <string>

namespace pcl::acmap {

/** \brief A window of the view's size with a scene, not yet rendered. */
vtkSmartPointer<vtkRenderWindow>
makeWindow(vtkRenderer* renderer, const SceneView& view);

/** \brief Draws a scene into a PNG file.
 * \throws OutputFileException */
void
savePicture(const std::string& path, vtkRenderer* renderer, const SceneView& view);

} // namespace pcl::acmap
