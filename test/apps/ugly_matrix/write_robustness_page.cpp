#include "ugly_page.h"
#include "virtual_display.h"

#include <cstdio>
#include <fstream>

/** Runs the whole matrix and writes the page. */
int
main(int argc, char** argv)
{
  using namespace pcl::acmap::test;
  if (argc != 2) {
    std::fputs("usage: write_robustness_page PAGE.md\n", stderr);
    return 2;
  }
  const VirtualDisplay display;
  std::vector<UglyColumn> columns;
  for (const UglyTool& tool : uglyTools()) {
    const std::vector<UglyRun> runs = runCases(tool);
    for (std::size_t i = 0; i < runs.size(); ++i)
      for (const std::string& fault : runs[i].faults)
        std::fprintf(stderr,
                     "%s: %s: %s: %s\n  %s",
                     tool.name.c_str(),
                     nameOf(tool.cases[i].kind),
                     tool.cases[i].what.c_str(),
                     fault.c_str(),
                     runs[i].err.c_str());
    columns.push_back(columnOf(tool, runs));
  }
  std::ofstream page(argv[1], std::ios::binary);
  page << pageOf(columns) << std::flush;
  return page ? 0 : 5;
}
