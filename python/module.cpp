#include "bindings.h"

PYBIND11_MODULE(acmap, module)
{
  using namespace pcl::acmap::python;
  module.doc() = "From noisy point clouds to a few planes: acmap's stages on numpy "
                 "arrays. Metres, radians; camera frame x right, y down, z forward.";
  module.attr("__version__") = ACMAP_VERSION;
  bindErrors(module);
  bindReport(module);
  bindConsolidation(module);
  bindMesh(module);
  bindNormals(module);
  bindPlanePatches(module);
  bindPlanes(module);
  bindCylinderPatches(module);
  bindBoxPatches(module);
  bindRecessPatches(module);
  bindRectification(module);
  bindAdjustment(module);
  bindTextureCharts(module);
  bindMapGraph(module);
  bindCompactMap(module);
  bindCompactMapping(module);
  bindFiles(module);
  bindStates();
  bindSignatures(module);
}
