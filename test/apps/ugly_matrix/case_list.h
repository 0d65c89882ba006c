#pragma once

#include "ugly_case.h"

#include <map>

namespace pcl::acmap::test {

/** \brief The expected exit code and message of a run. */
struct UglyOutcome {
  int exit_code = 0;
  std::string told;
};

/** \brief Collects cases, each of which damages a copy of a good input. */
class CaseList {
public:
  using Prepare = std::function<void(const TemporaryFolder&)>;

  /** \param[in] good puts good inputs into a folder
   * \param[in] arguments of the command line for them
   * \param[in] outcomes by the description of the case on the page; the default is code
   * 3 and the name of the damaged file */
  CaseList(Prepare good,
           std::vector<std::string> arguments,
           std::map<std::string, UglyOutcome> outcomes);

  /** \brief Adds a case for each kind of damage that is possible for any file. */
  void
  addFile(const std::string& file);

  /** \brief Adds a case with another fault.
   * \param[in] file name of the faulty file */
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

  /** \brief Adds a combination that is not applicable, and the reason. */
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
