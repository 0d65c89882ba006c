#include "bindings.h"
#include "members.h"

#include <pcl/core/cylinder_patch.h>

#include <array>

#include <pybind11/stl.h>

namespace pcl::acmap::python {

namespace {

template <typename Address>
py::cpp_function
vectorOf(Address address)
{
  return memberArray<CylinderPatch, double>({3}, address);
}

} // namespace

void
bindCylinderPatches(py::module_& module)
{
  using Patch = CylinderPatch;
  py::class_<Patch>(
      module, "CylinderPatch", "A column, pipe or curved wall: a part of a cylinder.")
      .def_property_readonly(
          "axis_point",
          vectorOf([](const Patch& patch) { return patch.axis_point.data(); }),
          "(3,) float64, metres: on the axis, at the middle of the support")
      .def_property_readonly(
          "axis_direction",
          vectorOf([](const Patch& patch) { return patch.axis_direction.data(); }),
          "(3,) float64, unit; its sign is arbitrary")
      .def_property_readonly(
          "axis_u",
          vectorOf([](const Patch& patch) { return patch.axis_u.data(); }),
          "(3,) float64, unit, across the axis: to the middle of the arc")
      .def_property_readonly(
          "axis_v",
          vectorOf([](const Patch& patch) { return patch.axis_v.data(); }),
          "(3,) float64, unit, across the axis and axis_u")
      .def_readonly("radius", &Patch::radius, "metres")
      .def_readonly("is_hollow", &Patch::is_hollow, "it was seen from inside")
      .def_property_readonly(
          "extent",
          [](const Patch& patch) {
            return std::array<double, 2>{patch.low, patch.high};
          },
          "[low, high], metres along the axis from axis_point")
      .def_readonly("arc", &Patch::arc, "radians about the axis, centred at axis_u")
      .def_property_readonly(
          "covariance",
          memberArray<Patch, double>(
              {5, 5}, [](const Patch& patch) { return patch.covariance.data(); }),
          "(5, 5) float64 of (shift of axis_point along axis_u, along axis_v, tilt of "
          "axis_direction towards axis_u, towards axis_v, radius): metres, radians; "
          "NaN "
          "where the support is too small to tell")
      .def_readonly("support", &Patch::support, "points")
      .def_readonly("rmse", &Patch::rms, "metres, of the support about the cylinder")
      .def_readonly("area", &Patch::area, "square metres")
      .def_readonly("template_id",
                    &Patch::template_id,
                    "cylinders of the same number have the same radius")
      .def_readonly("saved_bits",
                    &Patch::saved_bits,
                    "bits by which it shortens the description of its points");
}

} // namespace pcl::acmap::python
