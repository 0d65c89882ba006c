#pragma once

#include "run_tool.h"

#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Runs pcl_digiclops_grabber. */
ToolRun
runGrabber(const std::vector<std::string>& arguments, const RunSettings& settings = {});

/** \brief Names of the files of a folder, sorted. */
std::vector<std::string>
namesIn(const std::string& folder);

/** \brief Checks that both folders have the same files with the same bytes. */
void
expectSameFiles(const std::string& folder, const std::string& as);

} // namespace pcl::acmap::test
