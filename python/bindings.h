#pragma once

#include <pybind11/pybind11.h>

namespace pcl::acmap::python {

/** \brief Lets the exceptions of acmap and PCL become Python's. */
void
bindErrors();

// A stage each: its function and what that returns.

void
bindConsolidation(pybind11::module_& module);

void
bindMesh(pybind11::module_& module);

void
bindNormals(pybind11::module_& module);

void
bindPlanePatches(pybind11::module_& module);

void
bindPlanes(pybind11::module_& module);

void
bindRectification(pybind11::module_& module);

void
bindFiles(pybind11::module_& module);

} // namespace pcl::acmap::python
