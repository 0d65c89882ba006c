#include "figure_plan.h"

#include <pcl/core/file_format.h>

#include <initializer_list>

namespace pcl::acmap {

namespace {

constexpr std::size_t max_observations = 1000000;
constexpr std::size_t max_patterns = 256;

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

FigureEye
eyeOf(const YamlNode& node)
{
  FigureEye eye;
  eye.from = placeOf(node.at("from"));
  eye.look = placeOf(node.at("look"));
  const Eigen::Vector3f ahead = eye.look - eye.from;
  if (ahead.cross(Eigen::Vector3f::UnitY()).norm() < 1e-3f * ahead.norm() ||
      ahead.norm() == 0)
    node.at("look").fail("lies straight above or below the eye, or in it");
  return eye;
}

FigureEye
eyeAlone(const YamlNode& node)
{
  node.requireKeys({"from", "look"});
  return eyeOf(node);
}

/** Reads the figures from YAML and keeps the nodes of their numbers. */
class PlanReader {
public:
  explicit PlanReader(FigurePlan& plan)
  : plan_(plan)
  {}

  ObservationFigure
  observationOf(const YamlNode& node, std::vector<std::string> more = {})
  {
    more.insert(more.end(), {"observation", "from", "look"});
    node.requireKeys(more);
    plan_.observation_nodes.push_back(node.at("observation"));
    return {node.at("observation").count(0, max_observations), eyeOf(node)};
  }

  void
  readFusion(const YamlNode& node)
  {
    plan_.fusion = observationOf(node, {"patterns"});
    const auto& patterns = node.at("patterns").list(3, 3);
    for (std::size_t i = 0; i < patterns.size(); ++i) {
      plan_.patterns[i] = patterns[i].count(0, max_patterns);
      plan_.pattern_nodes.push_back(patterns[i]);
    }
  }

  void
  readMap(const YamlNode& node)
  {
    constexpr double highest = 1e6; // metres
    constexpr std::size_t max_views = 8;
    node.requireKeys({"cut", "views"});
    plan_.cut = node.at("cut").number(-highest, highest);
    for (const YamlNode& view : node.at("views").list(1, max_views))
      plan_.perspectives.push_back(eyeAlone(view));
  }

private:
  FigurePlan& plan_;
};

FigurePlan
planOf(const YamlNode& file)
{
  constexpr std::size_t min_width = 200, max_width = 8000; // px
  constexpr std::size_t max_examples = 8, max_steps = 16;
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
  PlanReader reader(plan);
  plan.scene = file.at("scene").text();
  plan.observations = file.at("observations").count(1, max_observations);
  plan.width = static_cast<int>(file.at("width").count(min_width, max_width));
  reader.readFusion(file.at("fig2"));
  for (const YamlNode& example : file.at("fig3").list(1, max_examples))
    plan.acquisitions.push_back(reader.observationOf(example));
  reader.readMap(file.at("fig4"));
  plan.walls = reader.observationOf(file.at("fig5"), {"steps"});
  plan.wall_steps = file.at("fig5").at("steps").count(1, max_steps);
  plan.mesh = reader.observationOf(file.at("fig7"));
  plan.inside = eyeAlone(file.at("fig8"));
  plan.outside = {eyeAlone(file.at("fig9")), eyeAlone(file.at("fig10"))};
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
