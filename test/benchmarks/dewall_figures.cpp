#include "figure_tables.h"

#include "sections.h"

#include <pcl/console/print.h>

#include <set>
#include <string>

namespace {

constexpr char usage[] =
    "Usage: acmap_bench_dewall_figures [soundness] [coverage] [time] [bunny]\n"
    "Prints the figures of DeWallTriangulation beside PCL's greedy projection as "
    "Markdown\n"
    "tables; without a name all of them. Real clouds are read from the folder named "
    "by\n"
    "the environment variable ACMAP_TEST_DATA.\n";

} // namespace

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  const std::set<std::string> known{"soundness", "coverage", "time", "bunny"};
  Sections sections;
  if (const auto exit_code = Sections::read(argc, argv, known, usage, sections))
    return *exit_code;

  // Greedy projection prints a line for every point that it cannot connect.
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  if (sections.isWanted("soundness"))
    printSoundness();
  if (sections.isWanted("coverage"))
    printCoverage(10);
  if (sections.isWanted("time"))
    printTime(5);
  if (sections.isWanted("bunny"))
    printBunny();
  return 0;
}
