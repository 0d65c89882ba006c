#pragma once

#include "ugly_case.h"

#include <map>

namespace pcl::acmap::test {

/** \brief What a run must return and tell. */
struct UglyOutcome {
  int exit_code = 0;
  std::string told;
};

/** \brief Collects cases, each of which spoils a copy of something good. */
class CaseList {
public:
  using Prepare = std::function<void(const TemporaryFolder&)>;

  /** \param[in] good puts what is good into a folder
   * \param[in] arguments of the command line for it
   * \param[in] outcomes by what is ugly, as the page has it; what is left out is code 3
   * and the name of the ugly file */
  CaseList(Prepare good,
           std::vector<std::string> arguments,
           std::map<std::string, UglyOutcome> outcomes);

  /** \brief A file of it is spoilt in each way that any file can be. */
  void
  addFile(const std::string& file);

  /** \brief A case with something else wrong. \param[in] file name of what is wrong */
  void
  add(Ugliness kind,
      const std::string& what,
      const std::string& file,
      const Prepare& spoil);

  /** \brief As \ref add, with another command line. */
  void
  addRun(
      Ugliness kind,
      const std::string& what,
      const std::string& file,
      const std::vector<std::string>& arguments,
      const Prepare& spoil = [](const TemporaryFolder&) {});

  /** \brief A case that makes no sense, and why. */
  void
  addSenseless(Ugliness kind, const std::string& why);

  void
  addAll(const std::vector<UglyCase>& cases);

  const std::vector<UglyCase>&
  cases() const
  {
    return cases_;
  }

private:
  Prepare good_;
  std::vector<std::string> arguments_;
  std::map<std::string, UglyOutcome> outcomes_;
  std::vector<UglyCase> cases_;
};

} // namespace pcl::acmap::test
