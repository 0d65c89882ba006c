#pragma once

#include <string>

namespace pcl::acmap {

/** \brief Advice for an input that this tool cannot use, but another tool or option
 * can.
 * \param[in] tool name of the program
 * \param[in] positional name of the argument that received the input
 * \return one sentence with a command; empty if the kind of input is unknown, or fits
 * the argument */
std::string
toolForInput(const std::string& tool,
             const std::string& positional,
             const std::string& path);

} // namespace pcl::acmap
