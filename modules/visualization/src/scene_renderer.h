#pragma once

#include "camera.h"
#include "scene.h"

#include <pcl/visualization/mesh_snapshot.h>

#include <vtkActor.h>
#include <vtkAssembly.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace pcl::acmap {

using Actors = std::vector<vtkSmartPointer<vtkActor>>;

/** \brief Points in their colours, or blue if they have none. */
vtkSmartPointer<vtkActor>
actorOfPoints(const Scene& scene);

/** \brief Points in their colours; without colours they are darker with increasing
 * depth. */
vtkSmartPointer<vtkActor>
actorOfPoints(const Scene& scene, const Camera& camera);

/** \brief Flat-shaded front and back faces. The two sides are separate actors, because
 * vertex colours would override the tint of the back faces. */
Actors
actorsOfMesh(const Scene& scene, bool hide_backs);

vtkSmartPointer<vtkActor>
actorOfBoundary(const Scene& scene);

vtkSmartPointer<vtkActor>
actorOfNormals(const Scene& scene);

/** \brief Creates a renderer with the scene, lights and the camera. */
vtkSmartPointer<vtkRenderer>
makeRenderer(const Scene& scene, const Camera& camera, const SceneView& view);

/** Opacity of planes that are shown together with other layers. */
constexpr double layer_opacity = 0.35;

/** \brief Combines actors to one prop that is shown and hidden as a whole. */
vtkSmartPointer<vtkAssembly>
assemblyOf(const Actors& actors);

} // namespace pcl::acmap
