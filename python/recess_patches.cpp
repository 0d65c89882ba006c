#include "bindings.h"
#include "members.h"

#include <pcl/core/recess_patch.h>

namespace pcl::acmap::python {

void
bindRecessPatches(py::module_& module)
{
  using Patch = RecessPatch;
  const auto vector = [](auto address) {
    return memberArray<Patch, double>({3}, address);
  };
  py::class_<Patch>(
      module,
      "RecessPatch",
      "A rectangular recess in a wall that a plane closes: a closed door, a "
      "window or a niche.")
      .def_property_readonly(
          "center",
          vector([](const Patch& recess) { return recess.center.data(); }),
          "(3,) float64, metres: of the opening")
      .def_property_readonly(
          "axes",
          memberArray<Patch, double>(
              {3, 3}, [](const Patch& recess) { return recess.axes.data(); }),
          "(3, 3) float64: the unit directions of width, height and the normal of the "
          "wall in rows, right-handed")
      .def_property_readonly(
          "size",
          vector([](const Patch& recess) { return recess.size.data(); }),
          "(3,) float64, metres: width, height and depth")
      .def_readonly("wall", &Patch::wall, "number of the plane around the opening")
      .def_readonly("leaf", &Patch::leaf, "number of the plane behind it")
      .def_readonly("reaches_floor",
                    &Patch::reaches_floor,
                    "a plane of the map bounds it below, as for a door")
      .def_property_readonly(
          "covariance",
          memberArray<Patch, double>(
              {9, 9}, [](const Patch& recess) { return recess.covariance.data(); }),
          "(9, 9) float64 of (turn about each axis, shift of the center along each "
          "axis, size): radians, metres")
      .def_readonly("template_id",
                    &Patch::template_id,
                    "recesses of the same number have the same size")
      .def_readonly("saved_bits",
                    &Patch::saved_bits,
                    "bits by which it shortens the description of leaf and opening");
}

} // namespace pcl::acmap::python
