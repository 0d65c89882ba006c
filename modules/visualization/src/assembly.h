#pragma once

#include "scene_renderer.h"

#include <vtkAssembly.h>

namespace pcl::acmap {

/** How much planes cover what is behind them, where they are one layer of several. */
constexpr double layer_opacity = 0.35;

/** \brief Actors as one thing that is turned off and on. */
vtkSmartPointer<vtkAssembly>
assemblyOf(const Actors& actors);

} // namespace pcl::acmap
