#include "figure_plan.h"

#include <pcl/core/file_format.h>

namespace pcl::acmap {

namespace {

constexpr std::size_t max_observations = 1000000;

Eigen::Vector3f
placeOf(const YamlNode& node)
{
  constexpr double farthest = 1e6; // metres
  Eigen::Vector3f place;
  const auto& values = node.list(3, 3);
  for (std::size_t i = 0; i < values.size(); ++i)
    place[static_cast<Eigen::Index>(i)] =
        static_cast<float>(values[i].number(-farthest, farthest));
  return place;
}

/** \param[in] more keys of the node */
FigureEye
eyeOf(const YamlNode& node, std::vector<std::string> more = {})
{
  more.insert(more.end(), {"from", "look"});
  node.requireKeys(more);
  const FigureEye eye{placeOf(node.at("from")), placeOf(node.at("look"))};
  const Eigen::Vector3f ahead = eye.look - eye.from;
  if (ahead.cross(Eigen::Vector3f::UnitY()).norm() < 1e-3f * ahead.norm() ||
      ahead.norm() == 0)
    node.at("look").fail("lies straight above or below the eye, or in it");
  return eye;
}

FigurePlan
planOf(const YamlNode& file)
{
  constexpr std::size_t min_width = 200, max_width = 8000; // px
  constexpr std::size_t max_list = 8, max_steps = 16, max_patterns = 256;
  constexpr double highest = 1e6; // metres
  requireFormat(file, file_formats::figures);
  file.requireKeys({"format",
                    "scene",
                    "observations",
                    "width",
                    "fig2",
                    "fig3",
                    "fig4",
                    "fig5",
                    "fig7",
                    "fig8",
                    "fig9",
                    "fig10"});
  FigurePlan plan;
  const auto observationOf = [&](const YamlNode& node,
                                 std::vector<std::string> more = {}) {
    more.emplace_back("observation");
    const FigureEye eye = eyeOf(node, more);
    plan.observation_nodes.push_back(node.at("observation"));
    return ObservationFigure{node.at("observation").count(0, max_observations), eye};
  };
  plan.scene = file.at("scene").text();
  plan.observations = file.at("observations").count(1, max_observations);
  plan.width = static_cast<int>(file.at("width").count(min_width, max_width));
  plan.fusion = observationOf(file.at("fig2"), {"patterns"});
  plan.pattern_nodes = file.at("fig2").at("patterns").list(3, 3);
  for (std::size_t i = 0; i < plan.patterns.size(); ++i)
    plan.patterns[i] = plan.pattern_nodes[i].count(0, max_patterns);
  for (const YamlNode& example : file.at("fig3").list(1, max_list))
    plan.acquisitions.push_back(observationOf(example));
  const YamlNode& map = file.at("fig4");
  map.requireKeys({"cut", "views"});
  plan.cut = map.at("cut").number(-highest, highest);
  for (const YamlNode& view : map.at("views").list(1, max_list))
    plan.perspectives.push_back(eyeOf(view));
  plan.walls = observationOf(file.at("fig5"), {"steps"});
  plan.wall_steps = file.at("fig5").at("steps").count(1, max_steps);
  plan.mesh = observationOf(file.at("fig7"));
  plan.inside = eyeOf(file.at("fig8"));
  plan.outside = {eyeOf(file.at("fig9")), eyeOf(file.at("fig10"))};
  return plan;
}

} // namespace

void
FigurePlan::requireWithin(std::size_t session_observations,
                          std::size_t session_patterns) const
{
  const auto require = [](const std::vector<YamlNode>& nodes,
                          std::size_t count,
                          const std::string& what) {
    for (const YamlNode& node : nodes)
      if (node.count(0, max_observations) >= count)
        node.fail("is beyond the session, which has " + std::to_string(count) + " " +
                  what);
  };
  require(observation_nodes, session_observations, "observations");
  require(pattern_nodes, session_patterns, "patterns");
}

FigurePlan
loadFigurePlan(const std::string& path)
{
  return planOf(path.empty() ? parseYaml("paper_figures.yaml", standardFiguresText())
                             : loadYaml(path));
}

} // namespace pcl::acmap
