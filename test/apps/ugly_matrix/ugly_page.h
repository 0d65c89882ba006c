#pragma once

#include "ugly_run.h"

#include <map>

namespace pcl::acmap::test {

/** \brief Content of the page about a tool: its column of the table, and its list. */
struct UglyColumn {
  std::string name;
  std::map<std::string, std::string> cells; ///< by the name of the row
  std::string list;                         ///< text from its heading on
};

UglyColumn
columnOf(const UglyTool& tool, const std::vector<UglyRun>& runs);

/** \brief The whole page. */
std::string
pageOf(const std::vector<UglyColumn>& columns);

/** \brief Reads the content about a tool from a page. */
UglyColumn
columnIn(const std::string& page, const std::string& tool);

} // namespace pcl::acmap::test
