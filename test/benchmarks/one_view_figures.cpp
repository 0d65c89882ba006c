#include "one_view_tables.h"
#include "sections.h"

#include <pcl/console/print.h>

namespace {

constexpr char usage[] =
    "Usage: acmap_bench_one_view_figures [real] [tables] [simulated] [meshes]\n"
    "Prints what is found in one organized depth view, ours beside the methods of PCL\n"
    "and CGAL, as Markdown tables; without a name all of them. Real views are read "
    "from\n"
    "the folder named by the environment variable ACMAP_TEST_DATA.\n";

} // namespace

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  // The last sample consensus finds nothing in the remaining points and prints an
  // error.
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  const TableSection parts[] = {{"real", printRealViews},
                                {"tables", printTableViews},
                                {"simulated", printSimulatedViews},
                                {"meshes", printViewMeshes}};
  return printParts(argc, argv, parts, usage);
}
