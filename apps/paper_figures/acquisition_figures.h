#pragma once

#include "figure_plan.h"

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

} // namespace pcl::acmap
