#pragma once

#include "ugly_case.h"

namespace pcl::acmap::test {

/** \brief What a run of a case gave. */
struct UglyRun {
  int exit_code = -1;
  std::string err; ///< all of stderr, with "…" for numbers that machines differ in
  std::vector<std::string> faults; ///< what is not as it must be, a line each
};

/** \brief Runs a case, one that fails twice: with nothing in the place of its output,
 * and with an older result there. */
UglyRun
runCase(const UglyTool& tool, const UglyCase& ugly);

/** \brief Runs all cases of a tool; those that make no sense give an empty run. */
std::vector<UglyRun>
runCases(const UglyTool& tool);

} // namespace pcl::acmap::test
