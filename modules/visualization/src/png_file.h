#pragma once

#include <string>

class vtkImageData;

namespace pcl::acmap {

/** \brief Writes a picture as PNG, whole or not at all.
 * \throws OutputFileException */
void
writePng(const std::string& path, vtkImageData* picture);

} // namespace pcl::acmap
