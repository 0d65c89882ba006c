#pragma once

#include "stage_table.h"
#include "temporary_folder.h"

#include <map>
#include <string>

namespace pcl::acmap::test {

/** \brief Contents of files by their path in a stage's folder. */
using Files = std::map<std::string, std::string>;

/** \brief How a stage is run again. */
struct Variant {
  unsigned threads = 2;
  bool is_plain = false; ///< without the kernels for AVX2
};

/** \brief Runs stages, each in the folder of its name: always the same one, so that no
 * path in a report changes. */
class StageRuns {
public:
  /** \brief Makes what the first stages read. */
  StageRuns();

  /** \brief Runs a stage, and has run those before it; a failure is one of the test.
   * \return all that it wrote, as \ref comparable leaves it */
  Files
  run(const Stage& stage, const Variant& variant);

  /** \brief What a stage wrote when it ran first, on two threads. */
  const Files&
  firstOf(const Stage& stage);

  /** \brief Where a stage writes. */
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

/** \brief A file without what belongs to one run alone.
 *
 * Of a report the times, the memory and the command line, which names the threads; all of
 * stage.json, where the times of files are, and of report.html, which shows the times. */
std::string
comparable(const std::string& name, const std::string& content);

} // namespace pcl::acmap::test
