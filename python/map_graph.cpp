#include "array_view.h"
#include "bindings.h"
#include "members.h"

#include <pcl/core/compact_map.h>
#include <pcl/core/fields.h>
#include <pcl/core/map_topology.h>

#include <pybind11/stl.h>

namespace pcl::acmap::python {

namespace {

void
bindTopology(py::module_& module)
{
  py::class_<MapEdge>(module, "MapEdge", "An edge of a map, between two vertices.")
      .def_readonly("vertices", &MapEdge::vertices, "ascending indices of vertices")
      .def_property_readonly(
          "kind",
          [](const MapEdge& edge) { return nameIn(edge_kind_names, edge.kind); },
          "'open', 'crease', 'contact', 'rim', 'frontier' or 'arc'")
      .def_readonly(
          "planes",
          &MapEdge::planes,
          "the plane whose polygon has the edge, and the other one of a crease "
          "or a contact, or -1")
      .def_readonly("cylinder",
                    &MapEdge::cylinder,
                    "index in CompactMap.cylinders of an arc, or -1");
  py::class_<MapFace>(module, "MapFace", "A polygon by the vertices of its boundaries.")
      .def_readonly("plane", &MapFace::plane, "index in CompactMap.planes")
      .def_readonly("polygon", &MapFace::polygon, "index in PlanePatch.polygons")
      .def_readonly("outer", &MapFace::outer, "list of indices of vertices")
      .def_readonly("holes", &MapFace::holes, "list of such lists");
  py::class_<MapTopology>(
      module, "MapTopology", "What the polygons of a map have in common, told once.")
      .def_property_readonly(
          "vertices",
          [](const py::object& self) {
            return fieldOf<float>(
                self.cast<const MapTopology&>().vertices,
                3,
                self,
                [](const Eigen::Vector3f& place) { return place.data(); });
          },
          "(n, 3) float32, metres, in the frame of the planes")
      .def_property_readonly(
          "edges",
          memberList<MapTopology, MapEdge>(
              [](const MapTopology& all) -> const std::vector<MapEdge>& {
                return all.edges;
              }),
          "list of MapEdge, in ascending order of their vertices")
      .def_property_readonly(
          "faces",
          memberList<MapTopology, MapFace>(
              [](const MapTopology& all) -> const std::vector<MapFace>& {
                return all.faces;
              }),
          "list of MapFace, in the order of the planes");
}

void
bindRooms(py::module_& module)
{
  py::class_<MapRoom>(module, "MapRoom", "Free space that planes and openings enclose.")
      .def_property_readonly(
          "center",
          memberArray<MapRoom, double>(
              {3}, [](const MapRoom& room) { return room.center.data(); }),
          "(3,) float64, metres: on the floor, far from the walls")
      .def_readonly("area",
                    &MapRoom::area,
                    "square metres of floor, with what walls and floor enclose")
      .def_readonly(
          "seen_area", &MapRoom::seen_area, "square metres of the map's floor")
      .def_property_readonly(
          "name",
          [](const MapRoom& room) { return room.label.name; },
          "such as 'Room 1'")
      .def_property_readonly(
          "size",
          memberArray<MapRoom, double>(
              {2}, [](const MapRoom& room) { return room.label.size.data(); }),
          "(2,) float64, metres: sides of the smallest rectangle around it")
      .def_readonly("planes",
                    &MapRoom::planes,
                    "floors, walls and ceilings, as ascending indices of planes")
      .def_readonly("openings",
                    &MapRoom::openings,
                    "those that lead into it, as ascending indices of openings");
  py::class_<MapOpening>(module, "MapOpening", "A door, a passage or a window.")
      .def_property_readonly(
          "start",
          memberArray<MapOpening, double>(
              {3}, [](const MapOpening& opening) { return opening.from.data(); }),
          "(3,) float64, metres: one side, on the floor")
      .def_property_readonly(
          "end",
          memberArray<MapOpening, double>(
              {3}, [](const MapOpening& opening) { return opening.to.data(); }),
          "(3,) float64, metres: the other side; the wall is seen from the left")
      .def_readonly("bottom", &MapOpening::bottom, "metres above the floor")
      .def_readonly("top", &MapOpening::top, "metres above the floor; NaN: not seen")
      .def_property_readonly(
          "kind",
          [](const MapOpening& opening) {
            return nameIn(opening_kind_names, opening.kind);
          },
          "'door' or 'window'")
      .def_property_readonly(
          "name",
          [](const MapOpening& opening) { return opening.label.name; },
          "such as 'Door between rooms 1 and 2'")
      .def_readonly(
          "planes",
          &MapOpening::planes,
          "the wall, and the other face of a wall seen from both sides, or -1")
      .def_readonly("rooms",
                    &MapOpening::rooms,
                    "in front of the first plane and behind it; -1: outside, or not "
                    "seen");
}

} // namespace

void
bindMapGraph(py::module_& module)
{
  bindTopology(module);
  bindRooms(module);
}

} // namespace pcl::acmap::python
