#include "mesh_speed_tables.h"

#include <pcl/console/print.h>

#include <iostream>
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
  const std::set<std::string> asked(argv + 1, argv + argc);
  for (const std::string& part : asked)
    if (known.count(part) == 0) {
      std::cerr << usage;
      return part == "--help" ? 0 : 2;
    }
  const auto isWanted = [&](const char* part) {
    return asked.empty() || asked.count(part) > 0;
  };

  // Greedy projection writes a line for every point it cannot place.
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  if (isWanted("map")) // first: it forks, and the others start threads
    printMapSpeed("corridor");
  SceneData corridor("corridor");
  if (isWanted("view"))
    printViewSpeed(corridor, 5);
  if (isWanted("crops"))
    printCropSpeed(corridor);
  if (isWanted("consolidated"))
    printConsolidatedSpeed(corridor, 5);
  if (isWanted("threads"))
    printThreadSpeed(corridor);
  if (isWanted("files"))
    printFileSpeed(corridor, 5);
  return 0;
}
