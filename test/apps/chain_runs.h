#pragma once

#include "run_tool.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Runs pcl_compact_mapping without pictures and X server. */
ToolRun
runChain(const std::string& input,
         const std::string& output,
         const std::vector<std::string>& options = {},
         RunSettings settings = {});

/** \brief The same of a raw session, with the options of \ref ChainTest. */
ToolRun
runSessionChain(const std::string& session,
                const std::string& output,
                std::vector<std::string> options = {},
                const RunSettings& settings = {});

/** \brief Stages of the last run in their order, from the report. */
std::vector<std::string>
stagesOf(const std::string& output);

/** \brief Those of them that were not reused from an earlier run. */
std::vector<std::string>
madeStages(const std::string& output);

/** \brief Contents of all files of a folder and its subfolders by relative path, except
 * for files about the run: reports, stage.json. */
std::map<std::string, std::string>
resultsIn(const std::string& folder);

/** \brief Names of files that differ, or exist in only one of both. */
std::vector<std::string>
differing(const std::map<std::string, std::string>& a,
          const std::map<std::string, std::string>& b);

/** \brief Paths of hidden files and folders, at any depth. */
std::vector<std::string>
hiddenIn(const std::string& folder);

/** \brief Provides a raw session of three observations and the map made of it,
 * unchanged in each test; tests may modify the copies. */
class ChainTest : public testing::Test {
protected:
  void
  SetUp() override;

  /** \brief Runs the command of the map again, with more options. */
  ToolRun
  runAgain(const std::vector<std::string>& options = {},
           const RunSettings& settings = {}) const;

  /** \brief A folder with the session's observations, without poses. */
  std::string
  observations() const;

  /** \brief The same with the final poses as trajectory.txt. */
  std::string
  posedObservations() const;

  std::string session_; ///< the raw one
  std::string map_;     ///< made of it
  TemporaryFolder folder_;
};

} // namespace pcl::acmap::test
