#include "png_file.h"

#include <pcl/core/output_file.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

namespace pcl::acmap {

void
writePng(const std::string& path, vtkImageData* picture)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* const bytes = writer->GetResult();
  if (!bytes || bytes->GetNumberOfValues() == 0)
    throw OutputFileException(shownPath(path) + ": the picture could not be encoded");
  OutputFile file(path);
  file.write(bytes->GetPointer(0),
             static_cast<std::size_t>(bytes->GetNumberOfValues()));
  file.commit();
}

} // namespace pcl::acmap
