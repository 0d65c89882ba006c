#pragma once

#include "tool.h"

#include <pcl/acquisition/random_line_pattern.h>

namespace pcl::acmap {

/** \brief Options of the user. */
struct PatternOptions {
  std::string output; ///< folder, or a picture for a single pattern
  std::string size = "1024x768";
  bool is_single = false;
  std::uint32_t patterns = 10;
  RandomLinePattern generator; ///< without the size
  bool show = false;
  int monitor = 0;
  double hold = 2; ///< seconds
};

/** \brief Adds the options for the lines of a pattern, and `--seed`. */
void
addPatternLook(Tool& tool, PatternOptions& options);

/** \brief Creates the generator from the options.
 * \throws UsageError, BadArgumentException for illegal values */
RandomLinePattern
generatorOf(const PatternOptions& options);

} // namespace pcl::acmap
