#include "figures.h"
#include "tool.h"

#include <CLI/CLI.hpp>

namespace {

using namespace pcl::acmap;

void
addOptions(Tool& tool, FigureOptions& options)
{
  CLI::App& app = tool.options();
  app.add_option(
         "session", options.session, "Raw session that pcl_simulated_rig filmed")
      ->type_name("SESSION_DIR")
      ->required();
  app.add_option("map", options.map, "What pcl_compact_mapping made of it")
      ->type_name("MAP_DIR")
      ->required();
  app.add_option("--papers-map",
                 options.papers_map,
                 "What pcl_compact_mapping --paper made of it: Figs. 8 to 10 are also "
                 "drawn of both maps")
      ->type_name("MAP_DIR");
  app.add_option("-o,--output", options.output, "Folder for the figures")
      ->type_name("OUT_DIR")
      ->required();
  app.add_option("--figures",
                 options.figures,
                 "What they show and from where [default: those of "
                 "scene corridor_survey]")
      ->type_name("FIGURES.yaml")
      ->check(
          [](const std::string& path) {
            return std::string(path.empty() ? "a file without a name" : "");
          },
          "");
  tool.addThreads();
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool(
      "acmap_paper_figures",
      "Draws the figures of the paper again, of a simulated session and its map.");
  FigureOptions options;
  addOptions(tool, options);
  tool.setHelp(
      {{{"acmap_paper_figures session map -o figures",
         "Figures of a simulated session and of the map that was made of it."}},
       {}});
  return tool.run(argc, argv, [&] {
    tool.requireReportWritable({options.figures});
    drawFigures(options, tool.controls(), tool.log());
  });
}
