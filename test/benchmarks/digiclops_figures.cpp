#include "digiclops_tables.h"
#include "sections.h"

namespace {

constexpr char usage[] =
    "Usage: acmap_bench_digiclops_figures [conversion] [order] [stream]\n"
    "Prints, as Markdown tables, what it takes to make rectified images of a camera's\n"
    "bytes, how the order of its channels is found, and whether frames of an emulated\n"
    "camera are lost while they are recorded; for that, run it by umockdev-wrapper.\n";

} // namespace

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  constexpr TableSection parts[] = {
      {"conversion", printConversion}, {"order", printOrder}, {"stream", printStream}};
  return printParts(argc, argv, parts, usage);
}
