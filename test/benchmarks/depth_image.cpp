#include "depth_image.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <stdexcept>

namespace pcl::acmap::bench {

DepthImage
readDepthImage(const std::string& path)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* read = reader->GetOutput();
  if (read->GetScalarType() != VTK_UNSIGNED_SHORT ||
      read->GetNumberOfScalarComponents() != 1)
    throw std::runtime_error(path + " is no grey PNG of 16 bits");
  DepthImage image;
  image.width = static_cast<std::size_t>(read->GetDimensions()[0]);
  image.height = static_cast<std::size_t>(read->GetDimensions()[1]);
  for (int row = static_cast<int>(image.height) - 1; row >= 0; --row) {
    const auto* first = static_cast<std::uint16_t*>(read->GetScalarPointer(0, row, 0));
    image.pixels.insert(image.pixels.end(), first, first + image.width);
  }
  return image;
}

} // namespace pcl::acmap::bench
