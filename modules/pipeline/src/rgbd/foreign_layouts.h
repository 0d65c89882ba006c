#pragma once

#include <string>

namespace pcl::acmap {

/** \brief Refuses a folder of depths in a format that is not read; returns if there are
 * none.
 * \throws InputFileException that names the format and the command that converts it */
void
refuseForeignDepths(const std::string& folder);

/** \brief Refuses the folder of a recording that is known but not read; returns if it is
 * none.
 * \throws InputFileException that names it and the command that converts it */
void
refuseForeignLayout(const std::string& folder);

} // namespace pcl::acmap
