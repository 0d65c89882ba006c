#pragma once

#include "light/rig_simulation.h"

#include <pcl/core/image_file.h>

#include <string>

namespace pcl::acmap::bench {

/** \brief Writes shots as in the figures of the paper. Above, Fig. 2, first row: the
 * reference image with the projector off, then under three patterns. Below, the left
 * and the top camera under the first pattern; and Fig. 3, left column: the reference
 * image with the projector off at two places of the corridor. Scaled to a third.
 * \throws OutputFileException when the file could not be written */
void
saveShotPicture(const std::string& path, const RigSimulation& simulation);

/** \brief Writes a pattern at half its size.
 * \throws OutputFileException when the file could not be written */
void
savePatternPicture(const std::string& path, const RgbImage& pattern);

} // namespace pcl::acmap::bench
