#include "case_list.h"
#include "small_world.h"
#include "ugly_tools.h"

#include <filesystem>

namespace pcl::acmap::test {
namespace {

constexpr const char* one_point_views = "a scene of one point a view";
constexpr const char* doubled_key = "a scene with a key twice";
constexpr const char* doubled_surface = "a scene with a surface twice";
constexpr const char* vast_scene = "a scene with a wall of 10³⁰ m";
constexpr const char* millimetre_scene = "a scene with a hall in millimetres";
constexpr const char* odd_scene = "Messung Nr. 1/Halle 測量.yaml";

CaseList::Prepare
changed(const std::string& from, const std::string& to)
{
  return
      [from, to](const auto& folder) { replaceIn(folder.path("hall.yaml"), from, to); };
}

} // namespace

UglyTool
uglySimulatedRig()
{
  const std::string output = "clouds";
  const auto command = [output](const std::string& scene) {
    return std::vector<std::string>{"-o", output, "--clouds", "--scene", scene};
  };
  const auto good = [](const auto& folder) { folder.write("hall.yaml", hallScene()); };
  CaseList list(good,
                command("hall.yaml"),
                {{one_point_views, {0, ""}},
                 {millimetre_scene, {4, "hall.yaml"}},
                 {odd_scene, {0, ""}}});
  list.addFile("hall.yaml");
  const std::string file = "hall.yaml";
  list.add(Ugliness::NanOnly,
           "a focal length of NaN",
           file,
           changed("focal_length: 130", "focal_length: .nan"));
  list.add(
      Ugliness::OnePoint, one_point_views, file, changed("points: 12000", "points: 1"));
  list.add(
      Ugliness::Doubled, doubled_key, file, changed("sensor:", "name: hall\nsensor:"));
  list.add(
      Ugliness::Doubled, doubled_surface, file, changed("name: left", "name: back"));
  list.add(Ugliness::WrongFields,
           "a scene with a key that is none",
           file,
           changed("focal_length", "focal_lenght"));
  list.add(Ugliness::Huge, vast_scene, file, changed("[7, 0, 0]", "[1e30, 0, 0]"));
  list.add(Ugliness::Millimetres, millimetre_scene, file, [](const auto& folder) {
    const std::string scene = hallScene();
    const std::size_t surfaces = scene.find("  - rectangle"),
                      path = scene.find("path:");
    folder.write("hall.yaml",
                 scene.substr(0, surfaces) +
                     "  - rectangle: {name: back, corner: [-3000, -1500, 4000],\n"
                     "      edges: [[7000, 0, 0], [0, 2700, 0]], look: wall}\n" +
                     scene.substr(path));
  });
  list.addRun(
      Ugliness::Names,
      odd_scene,
      odd_scene,
      command(odd_scene),
      [](const auto& folder) { give(folder, folder.path("hall.yaml"), odd_scene); });
  list.addRun(Ugliness::Device, "`/dev/zero`", "/dev/zero", command("/dev/zero"));
  return {"pcl_simulated_rig", output, true, false, list.cases()};
}

} // namespace pcl::acmap::test
