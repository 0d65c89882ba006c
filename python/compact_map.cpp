#include "compact_map.h"

#include "bindings.h"
#include "members.h"
#include "path_argument.h"
#include "poses.h"

#include <pcl/core/map_topology.h>
#include <pcl/texture/compact_map_folder.h>
#include <pcl/texture/floor_plan.h>
#include <pcl/texture/map_page.h>

#include <pybind11/stl.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

namespace pcl::acmap::python {

namespace {

namespace fs = std::filesystem;
using namespace py::literals;

const Trajectory&
trajectoryOf(const py::object& self)
{
  return self.cast<const ReportedMap&>().map.trajectory;
}

std::vector<std::string>
saveMap(const ReportedMap& reported,
        const PathArgument& argument,
        double color_tolerance)
{
  const std::string folder = pathOf("folder", argument);
  const py::gil_scoped_release others_may_run;
  CompactMapOutputs outputs;
  outputs.color_tolerance = color_tolerance;
  return saveCompactMap(folder, reported.map, outputs);
}

ReportedMap
readMap(const PathArgument& argument)
{
  const std::string folder = pathOf("folder", argument);
  CompactMap map;
  {
    const py::gil_scoped_release others_may_run;
    map = loadCompactMap(folder);
  }
  return {std::move(map), py::none()};
}

/** Replaces what would end an attribute, or begin a character reference. */
std::string
escaped(const std::string& text)
{
  std::string result;
  result.reserve(text.size());
  for (const char letter : text)
    if (letter == '"')
      result += "&quot;";
    else if (letter == '&')
      result += "&amp;";
    else
      result += letter;
  return result;
}

std::string
contentOf(const std::string& path)
{
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  return content.str();
}

/** A folder for files that nobody keeps. */
class PassingFolder {
public:
  PassingFolder()
  {
    std::string name = (fs::temp_directory_path() / "acmap_XXXXXX").string();
    if (!mkdtemp(name.data()))
      throw OutputFileException(name + ": cannot be made");
    path_ = name;
  }

  PassingFolder(const PassingFolder&) = delete;

  PassingFolder&
  operator=(const PassingFolder&) = delete;

  ~PassingFolder()
  {
    std::error_code error;
    fs::remove_all(path_, error);
  }

  std::string
  path(const char* name = "") const
  {
    return (path_ / name).string();
  }

private:
  fs::path path_;
};

/** For a notebook: the page of the map in a frame; its floor plan where there is no page. */
std::string
shownInNotebook(const ReportedMap& reported)
{
  const py::gil_scoped_release others_may_run;
  const PassingFolder folder;
  if (!hasMapPage()) {
    saveFloorPlan(folder.path("plan.svg"), makeFloorPlan(reported.map));
    return contentOf(folder.path("plan.svg"));
  }
  saveCompactMap(folder.path(), reported.map);
  saveMapPage(folder.path("map.html"), folder.path());
  return R"(<iframe style="width:100%;height:600px;border:0" srcdoc=")" +
         escaped(contentOf(folder.path("map.html"))) + R"("></iframe>)";
}

constexpr const char* about_saving =
    R"(Writes the map into a folder, which is made if it is missing: map.json, the textures
packed into few images, map.obj and map.glb. Textures are stored at a lower resolution
where that changes them by less than color_tolerance, levels of 255; 0 keeps all texels.
An older map there stays whole if it fails. Returns the names of the files. Raises
OSError and ValueError.)";

} // namespace

void
bindCompactMap(py::module_& module)
{
  py::class_<ReportedMap>(module,
                          "CompactMap",
                          "A map of textured planes. Its arrays refer to it: changes "
                          "of them are saved too.")
      .def_property_readonly(
          "planes",
          memberList<ReportedMap, PlanePatch>(
              [](const ReportedMap& reported) -> const std::vector<PlanePatch>& {
                return reported.map.planes;
              }),
          "list of PlanePatch, by falling area")
      .def_property_readonly(
          "area",
          [](const ReportedMap& reported) {
            double area = 0;
            for (const PlanePatch& patch : reported.map.planes)
              area += patch.area;
            return area;
          },
          "square metres, of all planes")
      .def_property_readonly(
          "cylinders",
          memberList<ReportedMap, CylinderPatch>(
              [](const ReportedMap& reported) -> const std::vector<CylinderPatch>& {
                return reported.map.cylinders;
              }),
          "list of CylinderPatch, by falling area; empty unless primitives were asked "
          "for")
      .def_property_readonly(
          "cylinder_pictures",
          memberList<ReportedMap, TexturePicture>(
              [](const ReportedMap& reported) -> const std::vector<TexturePicture>& {
                return reported.map.cylinder_pictures;
              }),
          "list of TexturePicture: the texture of each cylinder, unrolled: columns "
          "divide "
          "its arc, rows its extent from high to low; without texels if it has none")
      .def_property_readonly(
          "boxes",
          memberList<ReportedMap, BoxPatch>(
              [](const ReportedMap& reported) -> const std::vector<BoxPatch>& {
                return reported.map.boxes;
              }),
          "list of BoxPatch, by falling volume; empty unless primitives were asked for")
      .def_property_readonly(
          "recesses",
          memberList<ReportedMap, RecessPatch>(
              [](const ReportedMap& reported) -> const std::vector<RecessPatch>& {
                return reported.map.recesses;
              }),
          "list of RecessPatch, closed doors and the like, by falling volume; empty "
          "unless primitives were asked for")
      .def_property_readonly(
          "charts",
          memberList<ReportedMap, TextureChart>(
              [](const ReportedMap& reported) -> const std::vector<TextureChart>& {
                return reported.map.charts;
              }),
          "list of TextureChart: the textures of the planes")
      .def_property_readonly(
          "topology",
          [](const ReportedMap& reported) { return topologyOf(reported.map.planes); },
          "MapTopology: vertices, edges and faces of the polygons; found anew each "
          "time")
      .def_property_readonly(
          "rooms",
          memberList<ReportedMap, MapRoom>(
              [](const ReportedMap& reported) -> const std::vector<MapRoom>& {
                return reported.map.rooms;
              }),
          "list of MapRoom, by falling area")
      .def_property_readonly(
          "openings",
          memberList<ReportedMap, MapOpening>(
              [](const ReportedMap& reported) -> const std::vector<MapOpening>& {
                return reported.map.openings;
              }),
          "list of MapOpening: doors and windows between the rooms")
      .def_property_readonly(
          "observations",
          [](const ReportedMap& reported) { return reported.map.observations; },
          "for each plane the list of the observations that saw it, as indices of "
          "poses; empty if they are unknown")
      .def_property_readonly(
          "poses",
          [](const py::object& self) {
            return arrayOfPoses(trajectoryOf(self).poses, self);
          },
          "(k, 4, 4) float64: T_map_camera of the observations, metres")
      .def_property_readonly(
          "stamps",
          [](const py::object& self) {
            return fieldOf<double>(trajectoryOf(self).stamps,
                                   0,
                                   self,
                                   [](const double& stamp) { return &stamp; });
          },
          "(k,) float64, seconds: when they were made; their numbers if that is "
          "unknown")
      .def_readonly("report",
                    &ReportedMap::report,
                    "outcome of the rectification, counts of the steps, seconds and "
                    "remarks; None for a map from a folder")
      .def_property_readonly(
          "exposure",
          [](const ReportedMap& reported) { return reported.map.exposure; },
          "factor of the colours in the images of the saved map, so that these are "
          "neither dark nor overexposed")
      .def_property_readonly(
          "up",
          [](const ReportedMap& reported) -> std::optional<std::array<double, 3>> {
            const Eigen::Vector3d& up = reported.map.up;
            if (up.isZero(0))
              return std::nullopt;
            return std::array<double, 3>{up.x(), up.y(), up.z()};
          },
          "the up direction in the map frame, (x, y, z) of length 1; None if unknown")
      .def_property_readonly(
          "shift",
          memberArray<ReportedMap, double>(
              {3},
              [](const ReportedMap& reported) { return reported.map.shift.data(); }),
          "(3,) float64, metres: what was subtracted from the coordinates of the "
          "input, "
          "such as a national grid; zeros if nothing was")
      .def("_repr_html_",
           &shownInNotebook,
           "For notebooks: the page that shows the map, in a frame.")
      .def("save",
           &saveMap,
           about_saving,
           "folder"_a,
           "color_tolerance"_a = CompactMapOutputs().color_tolerance);
  module.def(
      "read_map",
      &readMap,
      "Reads a map that CompactMap.save or a tool wrote into a folder. Returns a "
      "CompactMap. Raises OSError.",
      "folder"_a);
}

} // namespace pcl::acmap::python
