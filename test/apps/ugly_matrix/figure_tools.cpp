#include "case_list.h"
#include "small_world.h"
#include "ugly_tools.h"

#include <filesystem>

namespace pcl::acmap::test {
namespace {

constexpr const char* figures = R"(scene: hall
observations: 2
width: 200
fig2: {observation: 0, patterns: [0, 1, 2], from: [-1, -1, -1], look: [0, 0, 3]}
fig3: [{observation: 1, from: [-1, -1, -1], look: [0, 0, 3]}]
fig4: {cut: 1.1, views: [{from: [-8, -8, -4], look: [0, 0, 4]}]}
fig5: {observation: 1, steps: 3, from: [-1, -1, -1], look: [0, 0, 3]}
fig7: {observation: 1, from: [-1, -1, -1], look: [0, 0, 3]}
fig8: {from: [0, 0, 0.5], look: [0, 0, 5]}
fig9: {from: [-8, -8, -4], look: [0, 0, 4]}
fig10: {from: [8, -8, 10], look: [0, 0, 3]}
)";

constexpr const char* odd_session = "Messung Nr. 1/Aufnahmen 測量";

std::vector<std::string>
figuresOf(const std::string& session, const std::string& map)
{
  return {session, map, "-o", "figures", "--figures", "figures.yaml"};
}

CaseList::Prepare
rewritten(const std::string& file, const std::string& from, const std::string& to)
{
  return [=](const auto& folder) { replaceIn(folder.path(file), from, to); };
}

} // namespace

UglyTool
uglyPaperFigures()
{
  const auto good = [](const TemporaryFolder& folder) {
    give(folder, hallSession(), "shots");
    give(folder, hallMap(), "map");
    folder.write("figures.yaml", figures);
  };
  const std::string yaml = "figures.yaml";
  CaseList list(good, figuresOf("shots", "map"), {{odd_session, {0, ""}}});
  list.addRun(Ugliness::Missing, "no such session", "none", figuresOf("none", "map"));
  list.addRun(Ugliness::Missing, "no such map", "none", figuresOf("shots", "none"));
  for (const char* file :
       {"figures.yaml", "shots/truth.json", "map/map.json", "map/map.pcd"})
    list.addFile(file);
  list.add(Ugliness::NanOnly,
           "`figures.yaml` with a place of NaN",
           yaml,
           rewritten(yaml, "[8, -8, 10]", "[8, .nan, 10]"));
  list.addSenseless(Ugliness::OnePoint, "a session of one frame has no map");
  list.add(Ugliness::Doubled,
           "`figures.yaml` with a figure twice",
           yaml,
           rewritten(yaml, "fig9", "fig8"));
  list.add(Ugliness::WrongFields,
           "`figures.yaml` with a key that is none",
           yaml,
           rewritten(yaml, "width", "breadth"));
  list.add(Ugliness::Huge,
           "`figures.yaml` with a width of 10³⁰",
           yaml,
           rewritten(yaml, "width: 200", "width: 1e30"));
  list.addSenseless(Ugliness::Millimetres,
                    "a map of another size is none of the session");
  list.addRun(
      Ugliness::Names,
      odd_session,
      odd_session,
      figuresOf(odd_session, "map"),
      [](const auto& folder) { give(folder, folder.path("shots"), odd_session); });
  return {"acmap_paper_figures", "figures", true, true, list.cases()};
}

} // namespace pcl::acmap::test
