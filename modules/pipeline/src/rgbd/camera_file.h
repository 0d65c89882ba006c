#pragma once

#include <pcl/pipeline/rgbd_sequence.h>

#include <filesystem>
#include <string>

namespace pcl::acmap {

/** \brief Takes the camera of a file with one of the usual names in a folder of images, which
 * may be of any kind that \ref loadCalibration reads.
 * \return false if there is no such file
 * \throws InputFileException naming file, line and fault */
bool
takeCameraFile(const std::filesystem::path& folder, RgbdSequence& sequence);

/** \brief Reads fx 0 cx, 0 fy cy in the first rows of a matrix of 3 or 4 rows.
 * \throws InputFileException as above */
Pinhole
loadMatrixCamera(const std::string& path);

} // namespace pcl::acmap
