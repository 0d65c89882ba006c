#include "consolidation_tables.h"

#include "sections.h"

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
  Sections sections;
  if (const auto exit_code = Sections::read(argc, argv, known, usage, sections))
    return *exit_code;

  SceneData corridor("corridor");
  if (sections.isWanted("noise"))
    printNoise(corridor);
  if (sections.isWanted("mesh"))
    printMesh(corridor);
  if (sections.isWanted("normals"))
    printNormals(corridor);
  if (sections.isWanted("sheets"))
    printSheets(corridor);
  if (sections.isWanted("time")) {
    printConsolidationTime(corridor, 5);
    printConsolidationMemory(corridor);
  }
  return 0;
}
