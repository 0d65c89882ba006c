#pragma once

#include "ugly_run.h"

#include <map>

namespace pcl::acmap::test {

/** \brief What the page says of a tool: its place in the table, row by row, and its
 * list. */
struct UglyColumn {
  std::string name;
  std::map<std::string, std::string> cells; ///< by the name of the row
  std::string list;                         ///< from its heading on
};

UglyColumn
columnOf(const UglyTool& tool, const std::vector<UglyRun>& runs);

/** \brief The whole page. */
std::string
pageOf(const std::vector<UglyColumn>& columns);

/** \brief What a page says of a tool. */
UglyColumn
columnIn(const std::string& page, const std::string& tool);

} // namespace pcl::acmap::test
