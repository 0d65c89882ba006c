#pragma once

#include "run_tool.h"
#include "temporary_folder.h"

#include <map>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Command line of a tool with all its outputs. */
struct ToolRow {
  std::string tool;
  /** \brief "<name" is an input, ">name" an output. */
  std::vector<std::string> arguments;

  /** \brief Results that an interrupted run keeps, according to its page; empty for
   * none. */
  std::string keeps = {};

  bool needs_screen = false;

  /** \brief Does a run take seconds? */
  bool is_slow = false;
};

/** \brief Every tool, with the report as one of its outputs. */
const std::vector<ToolRow>&
everyTool();

/** \brief A folder with small inputs for all of them, made once per program. */
const TemporaryFolder&
smallInputs();

/** \brief Runs a tool of the table.
 * \param[in] place returns the path of an output for its name */
ToolRun
runRow(const ToolRow& row,
       const std::function<std::string(const std::string& output)>& place,
       const RunSettings& settings = {});

/** \brief Names of the outputs of a row, in order. */
std::vector<std::string>
outputsOf(const ToolRow& row);

/** \brief Are its requirements met? A tool that draws needs an X server. */
bool
canRun(const ToolRow& row);

/** \brief Value of ACMAP_MOMENTS, which requests a thorough run. */
std::optional<int>
wantedMoments();

/** \brief Can it run, and is it fast or a thorough run requested? */
bool
isWorthwhile(const ToolRow& row);

/** \brief Contents of all files below a folder by relative path, except for files about
 * the run: reports, stage.json. */
std::map<std::string, std::string>
resultsBelow(const std::string& folder);

/** \brief Hidden files and folders at any depth. */
std::vector<std::string>
hiddenBelow(const std::string& folder);

} // namespace pcl::acmap::test
