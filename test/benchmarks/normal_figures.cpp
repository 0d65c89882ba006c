#include "normal_tables.h"

#include "sections.h"

#include <set>
#include <string>

namespace {

constexpr char usage[] =
    "Usage: acmap_bench_normal_figures [normals] [creases] [time]\n"
    "Prints the figures of NormalVectorVoting on the consolidated corridor, with what\n"
    "they should reach and beside PCL's, as Markdown tables; without a name all of "
    "them.\n";

} // namespace

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  const std::set<std::string> known{"normals", "creases", "time"};
  Sections sections;
  if (const auto exit_code = Sections::read(argc, argv, known, usage, sections))
    return *exit_code;

  SceneData corridor("corridor");
  if (sections.isWanted("normals"))
    printVotedNormals(corridor);
  if (sections.isWanted("creases"))
    printCreases(corridor);
  if (sections.isWanted("time"))
    printVotingTime(corridor, 5);
  return 0;
}
