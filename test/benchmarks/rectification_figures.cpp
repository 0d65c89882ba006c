#include "rectification_tables.h"

#include "sections.h"

namespace {

constexpr char usage[] =
    "Usage: acmap_bench_rectification_figures [logs] [strong] [constants] [paper] "
    "[corridors] [perfect] [size]\n"
    "Prints how well maps are straightened, as Markdown tables; without a name all of\n"
    "them. Laser logs are read from the folder named by the environment variable\n"
    "ACMAP_TEST_DATA.\n";

} // namespace

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  Sections sections;
  if (const auto exit_code = Sections::read(
          argc,
          argv,
          {"logs", "strong", "constants", "paper", "corridors", "perfect", "size"},
          usage,
          sections))
    return *exit_code;
  if (sections.isWanted("logs"))
    printLogs();
  if (sections.isWanted("strong"))
    printStrongDrift();
  if (sections.isWanted("constants"))
    printConstants();
  if (sections.isWanted("paper"))
    printPaperMode();
  if (sections.isWanted("corridors"))
    printCorridors();
  if (sections.isWanted("perfect"))
    printPerfect();
  if (sections.isWanted("size"))
    printSize();
  return 0;
}
