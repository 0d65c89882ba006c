#include "outline_tables.h"

#include "sections.h"

#include <cstring>

namespace {

constexpr char usage[] =
    "Usage: acmap_bench_outline_figures [--save DIR] [--from DIR] [--pictures DIR]\n"
    "       [corridor_survey] [office] [l_corridor] [loop] [polyfit] [scans] [size]\n"
    "Prints as Markdown tables how the outlines of planes agree with what the cameras\n"
    "saw; without a name all of them. Real clouds are read from the folder named by "
    "the\n"
    "environment variable ACMAP_TEST_DATA.\n"
    "  --save DIR      keeps the judged maps as DIR/NAME.json\n"
    "  --from DIR      judges such files instead of mapping\n"
    "  --pictures DIR  draws the outlines of the largest planes as DIR/NAME.png\n";

} // namespace

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  const std::vector<std::string> scenes{
      "corridor_survey", "office", "l_corridor", "loop"};
  OutlineOptions options;
  std::vector<char*> names{argv[0]};
  for (int i = 1; i < argc; ++i) {
    std::string* const folder = std::strcmp(argv[i], "--save") == 0   ? &options.save
                                : std::strcmp(argv[i], "--from") == 0 ? &options.from
                                : std::strcmp(argv[i], "--pictures") == 0
                                    ? &options.pictures
                                    : nullptr;
    if (folder && i + 1 < argc)
      *folder = argv[++i];
    else
      names.push_back(argv[i]);
  }
  std::set<std::string> known(scenes.begin(), scenes.end());
  known.insert("polyfit");
  known.insert("scans");
  known.insert("size");
  Sections sections;
  if (const auto exit_code = Sections::read(
          static_cast<int>(names.size()), names.data(), known, usage, sections))
    return *exit_code;
  std::vector<std::string> wanted;
  for (const std::string& scene : scenes)
    if (sections.isWanted(scene.c_str()))
      wanted.push_back(scene);
  if (sections.isWanted("polyfit"))
#ifdef ACMAP_HAVE_POLYFIT
    printPolyfitOutlines(scenes, options);
#else
    std::cerr << "polyfit: left out, built without CGAL or GLPK\n";
#endif
  if (!wanted.empty())
    printSimulatedOutlines(wanted, options);
  if (sections.isWanted("scans"))
    printScanOutlines(options);
  if (sections.isWanted("size"))
    printOutlineSizes();
  return 0;
}
