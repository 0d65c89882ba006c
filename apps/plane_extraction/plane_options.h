#pragma once

#include "sensor_option.h"
#include "tool.h"

#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief Options of the user; outputs without a name are not written. */
struct PlaneOptions {
  std::string input;
  std::string output;
  std::string labels;
  std::string normals;
  std::string picture;
  std::optional<double> voxel_size; ///< metres; 0: automatic
  std::optional<double> min_area;   ///< square metres
  std::optional<double> tolerance;  ///< metres
  DepthSensor sensor = DepthSensor::Automatic;
  bool regular = false;
  bool paper = false;

  /** \brief The mesh is needed, even if it is not requested by an output here. */
  bool keeps_mesh = false;

  bool
  wantsMesh() const
  {
    return keeps_mesh || !normals.empty() || !picture.empty();
  }

  /** \brief Is a cloud to be processed in space, even if it is a single view? */
  bool
  isInSpace() const
  {
    return voxel_size || tolerance || paper;
  }
};

/** \brief Adds the options that affect which planes are found. */
void
addPlaneChoices(Tool& tool, PlaneOptions& options);

/** \brief Adds all options to the command line. */
void
addOptions(Tool& tool, PlaneOptions& options);

/** \brief Checks that these options are compatible.
 * \throws UsageError */
void
checkChoices(const PlaneOptions& options);

/** \brief Checks before the work that all outputs can be written, and that the options
 * are compatible.
 * \throws OutputFileException, UsageError */
void
checkPlaces(const Tool& tool, const PlaneOptions& options);

} // namespace pcl::acmap
