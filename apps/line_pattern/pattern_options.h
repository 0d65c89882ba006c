#pragma once

#include "tool.h"

#include <pcl/acquisition/random_line_pattern.h>

#include <string>

namespace pcl::acmap {

/** \brief What the user asks for. */
struct PatternOptions {
  std::string output; ///< folder, or a picture for a single pattern
  std::string size = "1024x768";
  bool is_single = false;
  std::uint32_t patterns = 10;
  int lines = 200;
  bool grey = false;
  double minimum_angle = 0; ///< degrees
  std::uint64_t seed = 1;
  bool show = false;
  int monitor = 0;
  double hold = 2; ///< seconds
};

/** \brief Adds them to the command line. */
void
addOptions(Tool& tool, PatternOptions& options);

/** \brief Adds only those that say what the lines of a pattern look like. */
void
addPatternLook(CLI::App& app, PatternOptions& options);

/** \brief Looks at them together: is it a folder or a picture?
 * \throws UsageError when they make no sense together */
void
settleOutput(Tool& tool, PatternOptions& options);

/** \brief The generator that they describe.
 * \throws UsageError, BadArgumentException when it cannot be */
RandomLinePattern
generatorOf(const PatternOptions& options);

} // namespace pcl::acmap
