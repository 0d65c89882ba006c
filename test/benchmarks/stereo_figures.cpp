#include "sections.h"
#include "stereo_tables.h"

#include <cstring>

namespace {

constexpr char usage[] =
    "Usage: acmap_bench_stereo_figures [bag] [noise] [simulated] [subpixel]\n"
    "                                  [middlebury] [realsense] [patterns] [time]\n"
    "       acmap_bench_stereo_figures picture FOLDER\n"
    "Prints how right disparities are and what they take, ours and those of OpenCV's\n"
    "StereoSGBM, as Markdown tables; or writes pictures of them into a folder. Real\n"
    "images come from the folder that ACMAP_TEST_DATA names.\n";

} // namespace

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  if (argc == 3 && std::strcmp(argv[1], "picture") == 0) {
    saveStereoPictures(argv[2]);
    return 0;
  }
  constexpr TableSection parts[] = {{"bag", printBag},
                                    {"noise", printNoise},
                                    {"simulated", printSimulated},
                                    {"subpixel", printSubpixel},
                                    {"middlebury", printMiddlebury},
                                    {"realsense", printRealsense},
                                    {"patterns", printPatternNumbers},
                                    {"time", printStereoTimes}};
  return printParts(argc, argv, parts, usage);
}
