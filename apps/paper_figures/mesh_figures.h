#pragma once

#include "figure_inputs.h"
#include "figure_plan.h"

#include <pcl/core/output_folder.h>

namespace pcl::acmap {

/** \brief Draws fig5.png, the steps in which the walls of triangles grow over an
 * observation, and fig7.png, the mesh of an observation.
 * \param[in] threads 0 = all
 * \throws InputFileException when a cloud cannot be read
 * \throws NothingFound when there is no triangle */
void
drawMeshes(const MappedSession& map,
           const FigurePlan& plan,
           unsigned threads,
           const OutputFolder& folder);

} // namespace pcl::acmap
