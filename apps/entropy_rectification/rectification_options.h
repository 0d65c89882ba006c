#pragma once

#include "tool.h"

#include <pcl/mapping/entropy_rectification_types.h>

#include <cstdint>
#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief What the user asks for. */
struct RectificationOptions {
  std::string folder; ///< of posed observations; empty with a log
  std::string log;    ///< CARMEN's; empty with a folder
  std::string output;
  std::size_t every = 1; ///< scan of the log
  RectificationMode mode = RectificationMode::Guarded;
  std::uint64_t seed = 1;
  OdometryNoise odometry;
  bool has_odometry_noise = false;      ///< whether the user told it
  std::optional<double> asked_bin_size; ///< metres
  bool write_observations = false;
  bool write_map = true;    ///< map.pcd, all points
  bool skip_broken = false; ///< observations that cannot be read are left out

  /** \brief Metres: cameras see walls nearer and finer than laser scanners do. */
  double
  binSize() const
  {
    return asked_bin_size.value_or(log.empty() ? 0.05 : 0.1);
  }

  /** \brief The folder or the log. */
  const std::string&
  input() const
  {
    return log.empty() ? folder : log;
  }
};

/** \brief Adds them to the command line. */
void
addOptions(Tool& tool, RectificationOptions& options);

/** \brief Adds only those that say how a map is rectified. */
void
addRectificationChoices(Tool& tool, RectificationOptions& options);

/** \brief Checks that there is an input.
 * \throws UsageError when there is none */
void
requireInput(const RectificationOptions& options);

/** \brief Its name on the command line. */
const char*
nameOf(RectificationMode mode);

} // namespace pcl::acmap
