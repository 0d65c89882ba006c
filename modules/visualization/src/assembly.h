#pragma once

#include "scene_renderer.h"

#include <vtkAssembly.h>

namespace pcl::acmap {

/** Opacity of planes that are shown together with other layers. */
constexpr double layer_opacity = 0.35;

/** \brief Combines actors to one prop that is shown and hidden as a whole. */
vtkSmartPointer<vtkAssembly>
assemblyOf(const Actors& actors);

} // namespace pcl::acmap
