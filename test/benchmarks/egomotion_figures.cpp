#include "egomotion_tables.h"
#include "sections.h"

#include <cstring>

namespace {

constexpr char usage[] =
    "Usage: acmap_bench_egomotion_figures [simulated] [kitchen] [outliers]\n"
    "                                     [covariance] [time] [rectification] "
    "[rejection]\n"
    "       acmap_bench_egomotion_figures picture FOLDER\n"
    "Prints how well motions between views are found and what that takes, ours and\n"
    "those of PCL and OpenCV, as Markdown tables, without a name all of them; or\n"
    "writes pictures into a folder. Real images come from the folder that\n"
    "ACMAP_TEST_DATA names.\n";

} // namespace

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  if (argc == 3 && std::strcmp(argv[1], "picture") == 0) {
    saveEgomotionPictures(argv[2]);
    return 0;
  }
  constexpr TableSection parts[] = {{"simulated", printEgomotionSimulated},
                                    {"kitchen", printEgomotionKitchen},
                                    {"outliers", printEgomotionOutliers},
                                    {"covariance", printEgomotionCovariance},
                                    {"time", printEgomotionTimes},
                                    {"rectification", printEgomotionRectification},
                                    {"rejection", printEgomotionRejection}};
  return printParts(argc, argv, parts, usage);
}
