#pragma once

#include "camera.h"
#include "scene.h"

#include <pcl/visualization/mesh_snapshot.h>

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace pcl::acmap {

using Actors = std::vector<vtkSmartPointer<vtkActor>>;

/** \brief Points in their colours, else blue. */
vtkSmartPointer<vtkActor>
actorOfPoints(const Scene& scene);

/** \brief Points in their colours; else they are the darker the farther they are. */
vtkSmartPointer<vtkActor>
actorOfPoints(const Scene& scene, const Camera& camera);

/** \brief Facets show the relief; the two sides are drawn apart, because a colour of the
 * points would cover the tint of the back. */
Actors
actorsOfMesh(const Scene& scene, bool hide_backs);

vtkSmartPointer<vtkActor>
actorOfBoundary(const Scene& scene);

vtkSmartPointer<vtkActor>
actorOfNormals(const Scene& scene);

/** \brief Puts a scene under lights and before a camera. */
vtkSmartPointer<vtkRenderer>
makeRenderer(const Scene& scene, const Camera& camera, const SceneView& view);

} // namespace pcl::acmap
