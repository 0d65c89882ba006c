#include "chain_tables.h"
#include "sections.h"

namespace {

constexpr char usage[] =
    "Usage: acmap_bench_chain_figures [size] [kitchen]\n"
    "Prints as Markdown tables what the whole chain takes for a session of the "
    "paper's\n"
    "size, and what becomes of a real recording without its poses. Real images come\n"
    "from the folder that ACMAP_TEST_DATA names.\n";

} // namespace

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  constexpr TableSection parts[] = {{"size", printChainSize},
                                    {"kitchen", printChainKitchen}};
  return printParts(argc, argv, parts, usage);
}
