#pragma once

#include <string>

namespace pcl::acmap {

/** \brief A camera without distortion: the ray of pixel (column, row) is ((column - cx)
 * / fx, (row - cy) / fy, 1). */
struct Pinhole {
  double fx = 0; ///< pixels
  double fy = 0;
  double cx = 0;
  double cy = 0;
};

/** \brief Reads a pinhole camera from a 3 x 3 matrix in text, or from a `rig.yaml`.
 * \param[in] path ends in .yaml or .yml for a rig
 * \throws InputFileException when it is missing or has no pinhole camera */
Pinhole
loadPinhole(const std::string& path);

} // namespace pcl::acmap
