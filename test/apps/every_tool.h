#pragma once

#include "run_tool.h"
#include "temporary_folder.h"

#include <map>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief How a tool is run with all its outputs. */
struct ToolRow {
  std::string tool;
  /** \brief "<name" is an input, ">name" an output. */
  std::vector<std::string> arguments;

  /** \brief What an interrupted run leaves, by its page; empty for nothing. */
  std::string keeps = {};

  bool needs_screen = false;

  /** \brief Whether a run takes seconds. */
  bool is_slow = false;
};

/** \brief Every tool, the report among its outputs. */
const std::vector<ToolRow>&
everyTool();

/** \brief Small inputs for all of them, in a folder: made once a program. */
const TemporaryFolder&
smallInputs();

/** \brief Runs a tool of the table.
 * \param[in] place of an output, by its name */
ToolRun
runRow(const ToolRow& row,
       const std::function<std::string(const std::string& output)>& place,
       const RunSettings& settings = {});

/** \brief Names of the outputs of a row, in their order. */
std::vector<std::string>
outputsOf(const ToolRow& row);

/** \brief Whether all it needs is there: an X server, where it draws. */
bool
canRun(const ToolRow& row);

/** \brief The number that ACMAP_MOMENTS has, by which somebody asks for a thorough run. */
std::optional<int>
wantedMoments();

/** \brief Whether it can run, and is quick or a thorough run is wanted. */
bool
isWorthwhile(const ToolRow& row);

/** \brief All files below a folder, by their path in it, but for what tells of the run:
 * reports, stage.json. */
std::map<std::string, std::string>
resultsBelow(const std::string& folder);

/** \brief Hidden files and folders at any depth. */
std::vector<std::string>
hiddenBelow(const std::string& folder);

} // namespace pcl::acmap::test
