#include "plane_tables.h"

#include "acmap_planes.h"
#include "sections.h"

#include <pcl/console/print.h>

#include <set>
#include <string>

namespace {

constexpr char usage[] =
    "Usage: acmap_bench_plane_figures [view] [views] [noisy] [million] [whole] "
    "[drift] [shapes] [real]\n"
    "Prints how well planes are found, ours beside the methods of PCL and CGAL, as\n"
    "Markdown tables; without a name all of them. Real clouds are read from the "
    "folder\n"
    "named by the environment variable ACMAP_TEST_DATA.\n";

} // namespace

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  const std::set<std::string> known{
      "view", "views", "noisy", "million", "whole", "drift", "shapes", "real"};
  Sections sections;
  if (const auto exit_code = Sections::read(argc, argv, known, usage, sections))
    return *exit_code;

  // The last sample consensus finds nothing in the remaining points and prints an
  // error.
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  NamedFinders finders = peers();
  finders.insert(finders.begin(), {"acmap", findAcmapPlanes, true});
  SceneData corridor("corridor");
  if (sections.isWanted("view"))
    printViewPlanes(corridor, finders);
  if (sections.isWanted("views"))
    printAllViewsPlanes(corridor, finders);
  if (sections.isWanted("noisy"))
    printNoisyViewPlanes(corridor, finders);
  if (sections.isWanted("million"))
    printMillionPlanes(corridor, finders);
  if (sections.isWanted("whole"))
    printWholePlanes(corridor, finders);
  if (sections.isWanted("drift"))
    printDriftPlanes(finders.front());
  if (sections.isWanted("shapes"))
    printShapePlanes(finders);
  if (sections.isWanted("real")) {
    finders.insert(finders.begin() + 1,
                   {"acmap, tolerance given", findAcmapPlanesWithin});
    printRealPlanes(finders);
  }
  return 0;
}
