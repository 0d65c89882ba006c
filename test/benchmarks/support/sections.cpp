#include "bench.h"

#include <pcl/console/print.h>

#include <set>

namespace pcl::acmap::bench {
namespace {

struct NamedSection {
  std::string name;
  void (*print)();
};

std::vector<NamedSection>&
allSections()
{
  static std::vector<NamedSection> sections;
  return sections;
}

/** \return exit code */
int
printSections(const std::string& program, const std::set<std::string>& asked)
{
  std::set<std::string> left = asked;
  std::ostringstream usage;
  usage << "Usage: " << program.substr(program.rfind('/') + 1);
  std::set<std::string> named;
  for (const NamedSection& section : allSections()) {
    left.erase(section.name);
    if (named.insert(section.name).second)
      usage << " [" << section.name << "]";
  }
  if (!left.empty()) {
    std::cerr << usage.str()
              << "\nPrints its part of doc/benchmarks.md as Markdown tables; without a "
                 "name all that\nis there. Real data are read from the folder named by "
                 "the environment variable\nACMAP_TEST_DATA.\n";
    return left.count("--help") > 0 ? 0 : 2;
  }
  for (const NamedSection& section : allSections())
    if (asked.empty() || asked.count(section.name) > 0) {
      std::cout << "\n### " << section.name << "\n";
      section.print();
    }
  return 0;
}

} // namespace

Section::Section(const char* name, void (*print)())
{
  allSections().push_back({name, print});
}

} // namespace pcl::acmap::bench

int
main(int argc, char** argv)
{
  // Some methods of PCL print a line for every point that they cannot connect, or where
  // they find nothing in the remaining points.
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  return pcl::acmap::bench::printSections(argv[0], {argv + 1, argv + argc});
}
