#pragma once

#include "light/rig_simulation.h"

#include <pcl/core/image_file.h>

#include <string>

namespace pcl::acmap::bench {

/** \brief Writes shots as the paper shows them. Above, its Fig. 2, first row: the
 * reference image with the projector off, then under three patterns. Below, the left and
 * the top camera under the first of them; and its Fig. 3, left column: the reference
 * image, projector off, of two places of the corridor. A third of the size.
 * \throws OutputFileException when it could not be written */
void
saveShotPicture(const std::string& path, const RigSimulation& simulation);

/** \brief Writes a pattern at half its size.
 * \throws OutputFileException when it could not be written */
void
savePatternPicture(const std::string& path, const RgbImage& pattern);

} // namespace pcl::acmap::bench
