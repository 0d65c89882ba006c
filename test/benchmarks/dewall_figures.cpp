#include "figure_tables.h"

#include <pcl/console/print.h>

#include <iostream>
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
  if (isWanted("soundness"))
    printSoundness();
  if (isWanted("coverage"))
    printCoverage(10);
  if (isWanted("time"))
    printTime(5);
  if (isWanted("bunny"))
    printBunny();
  return 0;
}
