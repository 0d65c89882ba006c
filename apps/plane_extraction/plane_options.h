#pragma once

#include "tool.h"

#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief What the user asks for; outputs without a name are not written. */
struct PlaneOptions {
  std::string input;
  std::string output;
  std::string labels;
  std::string normals;
  std::string picture;
  std::optional<double> voxel_size; ///< metres; 0: automatic
  std::optional<double> least_area; ///< square metres
  std::optional<double> tolerance;  ///< metres
  bool regular = false;
  bool paper = false;
};

/** \brief Adds what decides which planes are found. */
void
addPlaneChoices(Tool& tool, PlaneOptions& options);

/** \brief Adds all of them to the command line. */
void
addOptions(Tool& tool, PlaneOptions& options);

/** \brief Checks that these choices go together. \throws UsageError */
void
checkChoices(const PlaneOptions& options);

/** \brief Checks before the work that all outputs can be written, and that the options go
 * together. \throws OutputFileException, UsageError */
void
checkPlaces(const Tool& tool, const PlaneOptions& options);

} // namespace pcl::acmap
