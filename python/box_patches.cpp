#include "bindings.h"
#include "members.h"

#include <pcl/core/box_patch.h>
#include <pcl/core/fields.h>

#include <array>
#include <string>
#include <utility>

#include <pybind11/stl.h>

namespace pcl::acmap::python {

namespace {

/** For each side its kind and its plane. */
std::array<std::pair<std::string, std::int32_t>, 6>
facesOf(const BoxPatch& box)
{
  std::array<std::pair<std::string, std::int32_t>, 6> faces;
  for (std::size_t side = 0; side < faces.size(); ++side)
    faces[side] = {nameIn(box_face_kind_names, box.faces[side].kind),
                   box.faces[side].plane};
  return faces;
}

} // namespace

void
bindBoxPatches(py::module_& module)
{
  using Patch = BoxPatch;
  const auto vector = [](auto address) {
    return memberArray<Patch, double>({3}, address);
  };
  py::class_<Patch>(module, "BoxPatch", "A piece of furniture, a crate or a pillar.")
      .def_property_readonly("center",
                             vector([](const Patch& box) { return box.center.data(); }),
                             "(3,) float64, metres")
      .def_property_readonly(
          "axes",
          memberArray<Patch, double>({3, 3},
                                     [](const Patch& box) { return box.axes.data(); }),
          "(3, 3) float64: the unit direction of an edge in each row, right-handed")
      .def_property_readonly("size",
                             vector([](const Patch& box) { return box.size.data(); }),
                             "(3,) float64, metres along the axes")
      .def_property_readonly(
          "faces",
          &facesOf,
          "list of (kind, plane) of the sides +x, -x, +y, -y, +z, -z: kind is "
          "\"seen\", "
          "\"snapped\" to a plane that bounds it, \"slanted\", or \"free\", with plane "
          "-1")
      .def_property_readonly(
          "slant",
          memberArray<Patch, double>({4},
                                     [](const Patch& box) { return box.slant.data(); }),
          "(4,) float64: unit normal and offset in metres of the plane of the slanted "
          "side, behind which the box is; 0 without one")
      .def_property_readonly(
          "covariance",
          memberArray<Patch, double>(
              {9, 9}, [](const Patch& box) { return box.covariance.data(); }),
          "(9, 9) float64 of (turn about each axis, shift of the center along each "
          "axis, "
          "size): radians, metres")
      .def_readonly("template_id",
                    &Patch::template_id,
                    "boxes of the same number have the same size")
      .def_readonly("saved_bits",
                    &Patch::saved_bits,
                    "bits by which it shortens the description of its planes");
}

} // namespace pcl::acmap::python
