#pragma once

#include <pcl/core/plane_patch.h>

#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Draws the outlines of the twelve planes with the largest outlines, each in a
 * frame of its own: edges that another plane has too are green, others red, and edges of
 * holes that no other plane has blue; dots are vertices.
 * \throws OutputFileException when the file could not be written */
void
saveOutlinePicture(const std::string& path, const std::vector<PlanePatch>& planes);

} // namespace pcl::acmap::bench
