#include "consolidation_tables.h"

#include <iostream>
#include <set>
#include <string>

namespace {

constexpr char usage[] =
    "Usage: acmap_bench_consolidation_figures [noise] [mesh] [normals] [sheets] "
    "[time]\n"
    "Prints the figures of NoiseScale and VoxelConsolidation on the simulated "
    "corridor,\n"
    "with what they should reach and beside PCL's, as Markdown tables; without a name "
    "all\n"
    "of them. Real clouds are read from the folder named by the environment variable\n"
    "ACMAP_TEST_DATA.\n";

} // namespace

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  const std::set<std::string> known{"noise", "mesh", "normals", "sheets", "time"};
  const std::set<std::string> asked(argv + 1, argv + argc);
  for (const std::string& part : asked)
    if (known.count(part) == 0) {
      std::cerr << usage;
      return part == "--help" ? 0 : 2;
    }
  const auto isWanted = [&](const char* part) {
    return asked.empty() || asked.count(part) > 0;
  };

  SceneData corridor("corridor");
  if (isWanted("noise"))
    printNoise(corridor);
  if (isWanted("mesh"))
    printMesh(corridor);
  if (isWanted("normals"))
    printNormals(corridor);
  if (isWanted("sheets"))
    printSheets(corridor);
  if (isWanted("time")) {
    printConsolidationTime(corridor, 5);
    printConsolidationMemory(corridor);
  }
  return 0;
}
