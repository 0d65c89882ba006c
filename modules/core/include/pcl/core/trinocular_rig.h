#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/yaml_node.h>

#include <string>

namespace pcl {

/** \brief Geometry of a rectified trinocular camera: the reference view, a neighbour in
 * its row and one in its column, all with the same pinhole.
 *
 * Camera frame of each: x right, y down, z forward. A pixel (column, row) of the
 * reference looks along ((column - center_x) / focal_length,
 * (row - center_y) / focal_length, 1). \ingroup core */
struct TrinocularRig {
  int width = 640;             ///< px
  int height = 480;            ///< px
  double focal_length = 520.0; ///< px
  double center_x = 319.5;     ///< px, of the principal point
  double center_y = 239.5;     ///< px

  /** \brief Where the centre of the horizontal neighbour stands, metres along x right;
   * negative for a left neighbour, 0 for none. */
  double baseline_horizontal = -0.10;

  /** \brief Where the centre of the vertical neighbour stands, metres along y down;
   * negative for one above, 0 for none. */
  double baseline_vertical = -0.10;

  double disparity_sigma = 0.13; ///< px, one standard deviation of a disparity
};

/** \brief Refuses a rig that no camera can have.
 * \throws BadArgumentException naming value and legal range \ingroup core */
ACMAP_EXPORT void
requireSoundRig(const TrinocularRig& rig);

/** \brief Reads a `rig.yaml`; keys it does not know (a calibration holds more) are left
 * out, keys that are missing are refused.
 * \throws InputFileException naming file, line, key and value \ingroup core */
ACMAP_EXPORT TrinocularRig
loadTrinocularRig(const std::string& path);

/** \brief Writes a `rig.yaml` in the form of OpenCV's FileStorage (`%YAML:1.0`); what is
 * read back is equal.
 * \throws BadArgumentException as \ref requireSoundRig
 * \throws OutputFileException when the file could not be written whole \ingroup core */
ACMAP_EXPORT void
saveTrinocularRig(const std::string& path, const TrinocularRig& rig);

namespace acmap {

/** \brief Reads the keys of a rig from a map that stands in a larger document.
 * \throws InputFileException naming file, line, key and value */
ACMAP_EXPORT TrinocularRig
readTrinocularRig(const YamlNode& map);

} // namespace acmap
} // namespace pcl
