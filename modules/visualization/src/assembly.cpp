#include "assembly.h"

namespace pcl::acmap {

vtkSmartPointer<vtkAssembly>
assemblyOf(const Actors& actors)
{
  auto assembly = vtkSmartPointer<vtkAssembly>::New();
  for (const auto& actor : actors)
    assembly->AddPart(actor);
  return assembly;
}

} // namespace pcl::acmap
