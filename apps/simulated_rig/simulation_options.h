#pragma once

#include "tool.h"

#include <pcl/simulation/simulated_light.h>

#include <cstdint>
#include <string>

namespace pcl::acmap {

inline constexpr const char* stereo_sensor = "stereo";
inline constexpr const char* kinect_sensor = "kinect";

/** \brief Options of the user. */
struct SimulationOptions {
  std::string output;
  std::string scene = "corridor";
  std::string cameras;          ///< path; empty for those of the scene's rig
  std::size_t observations = 0; ///< 0 for all
  std::uint64_t seed = 1;
  std::uint32_t patterns = 10;
  SimulatedLight light;
  bool clouds = false;
  std::string sensor = stereo_sensor; ///< sensor that measures the clouds
  std::string merged;
};

/** \brief Names of the scenes, as "a, b, c". */
std::string
listOfScenes();

/** \brief Adds the options to the command line. */
void
addOptions(Tool& tool, SimulationOptions& options);

/** \brief Refuses options that exclude each other, and illegal light settings.
 * \throws UsageError naming the option
 * \throws BadArgumentException naming value, legal range and unit */
void
requireSense(Tool& tool, const SimulationOptions& options);

} // namespace pcl::acmap
