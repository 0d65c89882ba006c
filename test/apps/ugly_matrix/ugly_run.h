#pragma once

#include "ugly_case.h"

namespace pcl::acmap::test {

/** \brief Result of a case. */
struct UglyRun {
  int exit_code = -1;
  std::string err; ///< all of stderr, with "…" for numbers that depend on the machine
  /** \brief Deviations from the expected result, one per line. */
  std::vector<std::string> faults;
};

/** \brief Runs a case; a case that fails is run twice: without an output, and with an
 * older result in its place. */
UglyRun
runCase(const UglyTool& tool, const UglyCase& ugly);

/** \brief Runs all cases of a tool; cases that are not applicable give an empty run. */
std::vector<UglyRun>
runCases(const UglyTool& tool);

} // namespace pcl::acmap::test
