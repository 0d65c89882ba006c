#pragma once

#include <pybind11/pybind11.h>

namespace pcl::acmap::python {

/** \brief Translates the exceptions of acmap and PCL to Python exceptions. */
void
bindErrors(pybind11::module_& module);

// Each of these binds one concept: a stage with its result, or what several of them share.

void
bindAdjustment(pybind11::module_& module);

void
bindBoxPatches(pybind11::module_& module);

void
bindCompactMap(pybind11::module_& module);

void
bindCompactMapping(pybind11::module_& module);

void
bindConsolidation(pybind11::module_& module);

void
bindCylinderPatches(pybind11::module_& module);

void
bindMapGraph(pybind11::module_& module);

void
bindMesh(pybind11::module_& module);

void
bindNormals(pybind11::module_& module);

void
bindPlanePatches(pybind11::module_& module);

void
bindPlanes(pybind11::module_& module);

/** \brief The class of all reports. */
void
bindReport(pybind11::module_& module);

void
bindRecessPatches(pybind11::module_& module);

void
bindRectification(pybind11::module_& module);

void
bindTextureCharts(pybind11::module_& module);

void
bindFiles(pybind11::module_& module);

/** \brief Pickling and reprs of classes that are bound. */
void
bindStates();

/** \brief Tells inspect the signatures of all functions of the module. */
void
bindSignatures(const pybind11::module_& module);

} // namespace pcl::acmap::python
