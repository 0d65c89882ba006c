#pragma once

#include "camera.h"
#include "scene.h"

#include <pcl/visualization/mesh_snapshot.h>

#include <vtkActor.h>
#include <vtkAssembly.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace pcl::acmap {

using Actors = std::vector<vtkSmartPointer<vtkActor>>;

/** \brief Points in their colours, or blue if they have none. */
vtkSmartPointer<vtkActor>
actorOfPoints(const Scene& scene, double pixels = 3);

/** \brief Flat-shaded front and back faces. The two sides are separate actors, because
 * vertex colours would override the tint of the back faces. */
Actors
actorsOfMesh(const Scene& scene, bool hide_backs);

/** \brief Draws the edges of all triangles of a mesh. */
void
showEdges(const Actors& mesh);

/** \brief Draws a mesh as if it were farther from the eye, so that planes and points
 * that differ from it by noise alone do not come and go in it.
 * \param[in] actors of the mesh */
void
pushBack(const Actors& actors, double metres, vtkCamera& camera);

vtkSmartPointer<vtkActor>
actorOfBoundary(const Scene& scene);

vtkSmartPointer<vtkActor>
actorOfNormals(const Scene& scene);

/** Opacity of planes that are shown together with other layers. */
constexpr double layer_opacity = 0.35;

/** \brief Combines actors to one prop that is shown and hidden as a whole. */
vtkSmartPointer<vtkAssembly>
assemblyOf(const Actors& actors);

} // namespace pcl::acmap
