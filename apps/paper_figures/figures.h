#pragma once

#include "figure_inputs.h"
#include "figure_plan.h"

#include <pcl/core/compact_map.h>
#include <pcl/core/output_folder.h>

#include <string>

namespace pcl::acmap {

/** \brief Draws fig2.png: reference images with the projector off and under three
 * patterns, the disparities of each, those of all patterns together (their median, and
 * matched at once), and the 3D model. And fig3.png: for some observations reference
 * image, disparities and 3D model.
 * \param[in] session folder
 * \param[in] threads 0 = all
 * \throws InputFileException for shots that are missing or cannot be read */
void
drawAcquisitions(const std::string& session,
                 const FigurePlan& plan,
                 unsigned threads,
                 const OutputFolder& folder);

/** \brief Draws fig4.png: the true plan, the map's points from above before and after
 * rectification with the true plan, and perspective views of the points after it. */
void
drawMapFigure(const FilmedSession& session,
              const MappedSession& map,
              const FigurePlan& plan,
              const OutputFolder& folder);

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

/** \brief Draws fig8.png, the textured planes as seen by the robot with the planes
 * without texture in the upper right corner, and fig9.png and fig10.png, from
 * outside. */
void
drawPlanes(CompactMap map, const FigurePlan& plan, const OutputFolder& folder);

} // namespace pcl::acmap
