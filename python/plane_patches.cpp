#include "array_view.h"
#include "bindings.h"
#include "members.h"

#include <pcl/core/plane_patch.h>

#include <pybind11/stl.h>

namespace pcl::acmap::python {

namespace {

/** A polygon loop as (k, 3); the array keeps the Python object alive that contains
 * it. */
py::array_t<float>
rimArray(const std::vector<Eigen::Vector3f>& rim, const py::object& self)
{
  return fieldOf<float>(
      rim, 3, self, [](const Eigen::Vector3f& place) { return place.data(); });
}

void
bindPolygon(py::module_& module)
{
  py::class_<PlanePolygon>(module, "PlanePolygon", "A polygon in space, metres.")
      .def_property_readonly(
          "outer",
          [](const py::object& self) {
            return rimArray(self.cast<const PlanePolygon&>().outer, self);
          },
          "(k, 3) float32, counter-clockwise seen from where the normal points to")
      .def_property_readonly(
          "holes",
          [](const py::object& self) {
            ListOf<py::array_t<float>> holes;
            for (const auto& hole : self.cast<const PlanePolygon&>().holes)
              holes.append(rimArray(hole, self));
            return holes;
          },
          "list of (k, 3) float32, clockwise");
}

} // namespace

void
bindPlanePatches(py::module_& module)
{
  bindPolygon(module);
  py::class_<PlanePatch>(module, "PlanePatch", "A plane with all that is known of it.")
      .def_property_readonly(
          "coefficients",
          memberArray<PlanePatch, double>(
              {4}, [](const PlanePatch& patch) { return patch.coefficients.data(); }),
          "(4,) float64: a x + b y + c z + d = 0, unit normal, metres")
      .def_property_readonly(
          "center",
          memberArray<PlanePatch, double>(
              {3}, [](const PlanePatch& patch) { return patch.center.data(); }),
          "(3,) float64, metres: middle of the support, on the plane")
      .def_property_readonly(
          "axis_u",
          memberArray<PlanePatch, double>(
              {3}, [](const PlanePatch& patch) { return patch.axis_u.data(); }),
          "(3,) float64, unit, in the plane")
      .def_property_readonly(
          "axis_v",
          memberArray<PlanePatch, double>(
              {3}, [](const PlanePatch& patch) { return patch.axis_v.data(); }),
          "(3,) float64, unit, in the plane")
      .def_property_readonly(
          "covariance",
          memberArray<PlanePatch, double>(
              {3, 3}, [](const PlanePatch& patch) { return patch.covariance.data(); }),
          "(3, 3) float64 of (slope along axis_u, slope along axis_v, offset at the "
          "center): radians, metres; NaN where the support is too small to tell")
      .def_readonly("support", &PlanePatch::support, "points")
      .def_readonly("effective_support",
                    &PlanePatch::effective_support,
                    "independent ones among them")
      .def_readonly("rmse", &PlanePatch::rms, "metres, of the support about the plane")
      .def_readonly("area", &PlanePatch::area, "square metres, of the polygons")
      .def_property_readonly(
          "name",
          [](const PlanePatch& patch) { return patch.label.name; },
          "such as 'Wall of room 2'; '' for a plane that is in no map")
      .def_property_readonly(
          "role",
          [](const PlanePatch& patch) {
            return nameIn(surface_role_names, patch.label.role);
          },
          "'floor', 'ceiling', 'wall', 'door leaf', 'furniture' or 'other'")
      .def_property_readonly(
          "size",
          memberArray<PlanePatch, double>(
              {2}, [](const PlanePatch& patch) { return patch.label.size.data(); }),
          "(2,) float64, metres: width and height of what is upright, else both sides "
          "of "
          "the smallest rectangle around it; NaN if unknown")
      .def_property_readonly(
          "polygons",
          memberList<PlanePatch, PlanePolygon>(
              [](const PlanePatch& patch) -> const std::vector<PlanePolygon>& {
                return patch.polygons;
              }),
          "list of PlanePolygon")
      .def_property_readonly(
          "proposed",
          memberList<PlanePatch, PlanePolygon>(
              [](const PlanePatch& patch) -> const std::vector<PlanePolygon>& {
                return patch.proposed;
              }),
          "list of PlanePolygon: where it probably continues, although it was not "
          "seen; "
          "part of no area");
}

} // namespace pcl::acmap::python
