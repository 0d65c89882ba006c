#pragma once

#include <string>

class vtkImageData;

namespace pcl::acmap {

/** \brief Writes an image as PNG, completely or not at all.
 * \throws OutputFileException */
void
writePng(const std::string& path, vtkImageData* picture);

} // namespace pcl::acmap
