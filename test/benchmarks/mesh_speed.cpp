#include "mesh_speed_tables.h"

#include "sections.h"

#include <pcl/console/print.h>

#include <set>
#include <string>

namespace {

constexpr char usage[] =
    "Usage: acmap_bench_mesh_speed [view] [map] [crops] [consolidated] [threads] "
    "[files]\n"
    "Prints what meshing the simulated corridor takes, raw and consolidated, and what\n"
    "its files take, beside peers and lower bounds, as Markdown tables; without a "
    "name\n"
    "all of them.\n";

} // namespace

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  const std::set<std::string> known{
      "view", "map", "crops", "consolidated", "threads", "files"};
  Sections sections;
  if (const auto exit_code = Sections::read(argc, argv, known, usage, sections))
    return *exit_code;

  // Greedy projection prints a line for every point that it cannot connect.
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  if (sections.isWanted("map")) // first: it forks, and the others start threads
    printMapSpeed("corridor");
  SceneData corridor("corridor");
  if (sections.isWanted("view"))
    printViewSpeed(corridor, 5);
  if (sections.isWanted("crops"))
    printCropSpeed(corridor);
  if (sections.isWanted("consolidated"))
    printConsolidatedSpeed(corridor, 5);
  if (sections.isWanted("threads"))
    printThreadSpeed(corridor);
  if (sections.isWanted("files"))
    printFileSpeed(corridor, 5);
  return 0;
}
