#include "adjustment_tables.h"

#include "sections.h"

#include <cstdlib>

namespace {

constexpr char usage[] =
    "Usage: acmap_bench_adjustment_figures [scenes] [entropy] [peers] [odometry] "
    "[perfect] [blank] [revisits] [kitchen] [livox] [size]\n"
    "Prints how well planes adjust poses, as Markdown tables; without a name all of\n"
    "them. Recordings are read from the folder named by the environment variable\n"
    "ACMAP_TEST_DATA. ACMAP_DRIFT_SEEDS=2 takes two seeds of the drift instead of "
    "ten.\n";

} // namespace

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  Sections sections;
  if (const auto exit_code = Sections::read(argc,
                                            argv,
                                            {"scenes",
                                             "entropy",
                                             "peers",
                                             "odometry",
                                             "perfect",
                                             "blank",
                                             "revisits",
                                             "kitchen",
                                             "livox",
                                             "size"},
                                            usage,
                                            sections))
    return *exit_code;
  DriftSeeds seeds;
  if (const char* const count = std::getenv("ACMAP_DRIFT_SEEDS"))
    seeds.last = seeds.first + std::strtoul(count, nullptr, 10) - 1;
  if (sections.isWanted("scenes"))
    printAdjustedScenes(seeds);
  if (sections.isWanted("entropy"))
    printRectifiedScenes(seeds);
  if (sections.isWanted("peers"))
    printAdjustmentPeers(seeds);
  if (sections.isWanted("odometry"))
    printWrongOdometry(seeds);
  if (sections.isWanted("perfect"))
    printRightPoses();
  if (sections.isWanted("blank"))
    printBlankCorridor(seeds);
  if (sections.isWanted("revisits"))
    printRevisits(seeds);
  if (sections.isWanted("kitchen"))
    printAdjustedKitchen();
  if (sections.isWanted("livox"))
    printAdjustedScans();
  if (sections.isWanted("size"))
    printAdjustmentSize();
  return 0;
}
