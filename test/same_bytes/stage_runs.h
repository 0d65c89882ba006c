#pragma once

#include "stage_table.h"
#include "temporary_folder.h"

#include <map>
#include <string>

namespace pcl::acmap::test {

/** \brief Contents of files by their path relative to a stage's folder. */
using Files = std::map<std::string, std::string>;

/** \brief Parameters of a repeated run. */
struct Variant {
  unsigned threads = 2;
  bool is_plain = false; ///< without the AVX2 kernels
};

/** \brief Runs stages, each in a folder with its name: always the same one, so that
 * paths in reports do not change. */
class StageRuns {
public:
  /** \brief Creates the inputs of the first stages. */
  StageRuns();

  /** \brief Runs a stage after the stages on which it depends; failures are reported as
   * test failures.
   * \return all files that it wrote, reduced by \ref comparable */
  Files
  run(const Stage& stage, const Variant& variant);

  /** \brief Output of the first run of a stage, with two threads. */
  const Files&
  firstOf(const Stage& stage);

  /** \brief Output folder of a stage. */
  std::string
  folderOf(const Stage& stage) const
  {
    return folder_.path(stage.name);
  }

private:
  std::string
  resolved(const Stage& stage, const std::string& argument) const;

  TemporaryFolder folder_;
  std::map<std::string, Files> first_;
};

/** \brief Removes everything from a file that differs between runs.
 *
 * From a report, times, memory and the command line with the number of threads; the
 * whole of stage.json, which contains file times, and of report.html, which shows the
 * times. */
std::string
comparable(const std::string& name, const std::string& content);

} // namespace pcl::acmap::test
