#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/yaml_node.h>

#include <optional>
#include <string>

namespace pcl {

/** \brief Geometry of a rectified trinocular camera: the reference view, a neighbour in
 * the horizontal and one in the vertical direction, all with the same intrinsics.
 *
 * Frame of each camera: x right, y down, z forward. The ray of a pixel (column, row) of
 * the reference is ((column - center_x) / focal_length, (row - center_y) /
 * focal_length, 1). \ingroup core */
struct TrinocularRig {
  int width = 640;             ///< px
  int height = 480;            ///< px
  double focal_length = 520.0; ///< px
  double center_x = 319.5;     ///< px, of the principal point
  double center_y = 239.5;     ///< px

  /** \brief Position of the horizontal neighbour, metres along x (right); negative for
   * a left neighbour, 0 for none. */
  double baseline_horizontal = -0.10;

  /** \brief Position of the vertical neighbour, metres along y (down); negative for one
   * above, 0 for none. */
  double baseline_vertical = -0.10;

  double disparity_sigma = 0.13; ///< px, one standard deviation of a disparity

  /** \brief Column of the principal point of the horizontal neighbour, px, where it is
   * not center_x: disparities then have an offset, see \ref acmap::disparityOffset. Only
   * without a vertical neighbour. */
  std::optional<double> center_x_horizontal;
};

/** \brief Checks the parameters of a rig.
 * \throws BadArgumentException naming value and legal range \ingroup core */
ACMAP_EXPORT void
requireSoundRig(const TrinocularRig& rig);

/** \brief Reads a `rig.yaml`; unknown keys (a calibration has more of them) are
 * ignored, missing keys are an error.
 * \throws InputFileException naming file, line, key and value \ingroup core */
ACMAP_EXPORT TrinocularRig
loadTrinocularRig(const std::string& path);

/** \brief Writes a `rig.yaml` in the format of OpenCV's FileStorage (`%YAML:1.0`); the
 * same values are read back.
 * \throws BadArgumentException as \ref requireSoundRig
 * \throws OutputFileException when the file could not be written completely
 * \ingroup core */
ACMAP_EXPORT void
saveTrinocularRig(const std::string& path, const TrinocularRig& rig);

namespace acmap {

/** \brief Reads the keys of a rig from a map that is part of a larger document.
 * \throws InputFileException naming file, line, key and value */
ACMAP_EXPORT TrinocularRig
readTrinocularRig(const YamlNode& map);

} // namespace acmap
} // namespace pcl
