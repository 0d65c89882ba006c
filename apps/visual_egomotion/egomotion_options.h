#pragma once

#include "tool.h"

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief What the user asks for. */
struct EgomotionOptions {
  std::vector<std::string> inputs; ///< one folder, or PCDs in their order
  std::string output;
  bool is_rigid = false;       ///< six degrees of freedom instead of three
  double most_translation = 1; ///< metres, from an observation to the next
  double most_rotation = 30;   ///< degrees
  std::size_t keypoints = 1000;
  bool refines = true;
  bool writes_observations = true; ///< posed copies of the input
  bool pictures = false;
  std::string truth; ///< trajectory to compare with; empty: none
};

/** \brief Adds them to the command line. */
void
addOptions(Tool& tool, EgomotionOptions& options);

/** \brief Adds only those that say how motions are found. */
void
addMotionChoices(CLI::App& app, EgomotionOptions& options);

} // namespace pcl::acmap
