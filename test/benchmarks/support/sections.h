#pragma once

#include <iostream>
#include <optional>
#include <set>
#include <string>

namespace pcl::acmap::bench {

/** \brief The sections of a benchmark selected on the command line; all if none is
 * given. */
class Sections {
public:
  /** \brief Reads the command line; for unknown names prints the usage and returns the
   * exit code. */
  static std::optional<int>
  read(int argc,
       char** argv,
       const std::set<std::string>& known,
       const char* usage,
       Sections& sections)
  {
    sections.asked_ = {argv + 1, argv + argc};
    for (const std::string& part : sections.asked_)
      if (known.count(part) == 0) {
        std::cerr << usage;
        return part == "--help" ? 0 : 2;
      }
    return std::nullopt;
  }

  bool
  isWanted(const char* part) const
  {
    return asked_.empty() || asked_.count(part) > 0;
  }

private:
  std::set<std::string> asked_;
};

/** \brief A section that prints tables. */
struct TableSection {
  const char* name;
  void (*print)();
};

/** \brief Prints the sections selected on the command line.
 * \return exit code */
template <typename Parts>
int
printParts(int argc, char** argv, const Parts& parts, const char* usage)
{
  std::set<std::string> names;
  for (const TableSection& part : parts)
    names.insert(part.name);
  Sections sections;
  if (const auto exit_code = Sections::read(argc, argv, names, usage, sections))
    return *exit_code;
  for (const TableSection& part : parts)
    if (sections.isWanted(part.name))
      part.print();
  return 0;
}

} // namespace pcl::acmap::bench
