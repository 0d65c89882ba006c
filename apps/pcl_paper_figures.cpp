#include "paper_figures/figure_table.h"
#include "paper_figures/figures.h"
#include "tool.h"

#include <pcl/core/output_file.h>
#include <pcl/core/output_folder.h>
#include <pcl/texture/compact_map_folder.h>
#include <pcl/visualization/display_connection.h>

#include <CLI/CLI.hpp>

namespace {

using namespace pcl::acmap;

struct Options {
  std::string session;
  std::string map;
  std::string output;
  std::string figures;
};

void
addOptions(Tool& tool, Options& options)
{
  CLI::App& app = tool.options();
  app.add_option(
         "session", options.session, "Raw session that pcl_simulated_rig filmed")
      ->type_name("SESSION_DIR")
      ->required();
  app.add_option("map", options.map, "What pcl_compact_mapping made of it")
      ->type_name("MAP_DIR")
      ->required();
  app.add_option("-o,--output", options.output, "Folder for the figures")
      ->type_name("OUT_DIR")
      ->required();
  app.add_option("--figures",
                 options.figures,
                 "What they show and from where [default: share/paper_figures.yaml, of "
                 "scene corridor_survey]")
      ->type_name("FIGURES.yaml")
      ->check(
          [](const std::string& path) {
            return std::string(path.empty() ? "a file without a name" : "");
          },
          "");
  tool.addThreads();
}

void
warnOfOtherScene(Tool& tool, const FilmedSession& session, const FigurePlan& plan)
{
  if (session.scene != plan.scene)
    tool.warn("the figures are made for scene " + plan.scene + ", the session is of " +
              session.scene + ": the places of the eye may show little");
  else if (session.observations != plan.observations)
    tool.warn("the figures are made for " + std::to_string(plan.observations) +
              " observations, the session has " + std::to_string(session.observations));
}

void
savePage(const std::string& path, const std::string& text)
{
  OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

void
drawFigures(Tool& tool, const Options& options)
{
  const DisplayConnection display;
  StepTimer timer(tool.report());
  const FigurePlan plan = loadFigurePlan(options.figures);
  const FilmedSession session = loadFilmedSession(options.session);
  plan.requireWithin(session.observations, session.patterns);
  const MappedSession mapped = loadMappedSession(options.map, session);
  const pcl::CompactMap map = pcl::loadCompactMap(options.map);
  warnOfOtherScene(tool, session, plan);
  OutputFolder folder(options.output);
  tool.requireReportWritable({options.figures});
  timer.finish("read");

  drawAcquisitions(options.session, plan, tool.threads(), folder);
  timer.finish("stereo");
  tool.stopIfInterrupted();
  drawMapFigure(session, mapped, plan, folder);
  timer.finish("map");
  tool.stopIfInterrupted();
  drawMeshes(mapped, plan, tool.threads(), folder);
  timer.finish("meshes");
  tool.stopIfInterrupted();
  drawPlanes(map, plan, folder);
  timer.finish("planes");
  const FigureNumbers numbers = numbersOf(session, mapped, map);
  savePage(folder.path("figures.md"), figurePage(numbers, plan));
  timer.finish("count");
  tool.stopIfInterrupted();
  folder.commit();

  tool.details() = {{"session", options.session},
                    {"map", options.map},
                    {"output", options.output},
                    {"observations", numbers.observations},
                    {"points", numbers.points},
                    {"planes", numbers.planes}};
  tool.tell("observations", std::to_string(numbers.observations) + " (paper: 106)");
  tool.tell("points", std::to_string(numbers.points) + " (paper: 14697233)");
  tool.tellSeconds();
  tool.tell("figures", options.output + "/figures.md");
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool(
      "pcl_paper_figures",
      "Draws the figures of the paper again, of a simulated session and its map.");
  Options options;
  addOptions(tool, options);
  return tool.run(argc, argv, [&] { drawFigures(tool, options); });
}
