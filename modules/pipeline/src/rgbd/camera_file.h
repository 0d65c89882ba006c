#pragma once

#include <pcl/pipeline/rgbd_sequence.h>

#include <string>

namespace pcl::acmap {

/** \brief A camera with the size of its images, 0 x 0 if that is not stated. */
struct SizedCamera {
  Pinhole pinhole;
  ImageSize size;
};

/** \brief Reads Open3D's PinholeCameraIntrinsic, whose matrix is stored by columns.
 * \throws InputFileException naming file, line and fault */
SizedCamera
loadOpen3dCamera(const std::string& path);

/** \brief Reads fx 0 cx, 0 fy cy in the first rows of a matrix of 3 or 4 rows.
 * \throws InputFileException as above */
Pinhole
loadMatrixCamera(const std::string& path);

} // namespace pcl::acmap
