#include "primitive_tables.h"

#include "sections.h"

#include <array>

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  constexpr char usage[] =
      "Usage: acmap_bench_primitive_figures [half_seen] [fit4cad] [fit4cad_tuned] "
      "[walls] [sigma] [boxes] [slants] [doors]\n"
      "Prints how well cylinders, boxes and doors are found, as Markdown tables; "
      "without a\n"
      "name all of them. The models of Fit4CAD are read from the folder named by the\n"
      "environment variable ACMAP_TEST_DATA.\n";
  const std::array<TableSection, 8> parts{{{"half_seen", printHalfSeen},
                                           {"fit4cad", printFit4cad},
                                           {"fit4cad_tuned", printFit4cadTuned},
                                           {"walls", printWalls},
                                           {"sigma", printSigma},
                                           {"boxes", printBoxes},
                                           {"slants", printSlants},
                                           {"doors", printDoors}}};
  return printParts(argc, argv, parts, usage);
}
