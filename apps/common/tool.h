#pragma once

#include "exit_code.h"
#include "progress_bar.h"
#include "told.h"

#include <pcl/core/progress.h>

#include <nlohmann/json.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pcl::acmap {

/** \brief What all tools share: common options, exit codes, one line for an error,
 * progress, warnings, the summary on stdout and the report as JSON.
 *
 * A tool adds its own options, then hands its work to \ref run. */
class Tool {
public:
  /** \param[in] name of the program
   * \param[in] purpose what it does, a sentence */
  Tool(std::string name, const std::string& purpose);
  ~Tool();

  /** \brief Where the tool adds its own options. */
  CLI::App&
  options()
  {
    return *app_;
  }

  /** \brief Adds `--threads`. */
  void
  addThreads();

  /** \brief Adds `--seed`. */
  void
  addSeed(std::uint64_t& seed);

  /** \brief Adds `--scale`. */
  void
  addScale();

  /** \brief Adds an option whose value is a length, `auto`, or left out.
   * \param[out] length metres, 0 for automatic; not set where the option is not given */
  void
  addLengthOrAuto(const std::string& name,
                  std::optional<double>& length,
                  const std::string& description);

  /** \brief Parses, works, reports; what main returns.
   * \param[in] work throws what \ref failureOf knows */
  int
  run(int argc, const char* const* argv, const std::function<void()>& work);

  unsigned
  threads() const
  {
    return threads_;
  }

  /** \brief Whether nothing but errors is to be printed. */
  bool
  isQuiet() const
  {
    return quiet_;
  }

  /** \brief Metres in a unit of the input. */
  double
  scale() const
  {
    return scale_;
  }

  /** \brief Checks the place of the report, if one was asked for, as
   * \ref requireWritable does. */
  void
  requireReportWritable(const std::vector<std::string>& others) const;

  /** \brief Where the report goes when the user asked for no other place. */
  void
  setReportPlace(const std::string& path)
  {
    if (report_path_.empty())
      report_path_ = path;
  }

  /** \brief Calls the work with a callback that draws the bar and tells interruptions. */
  void
  withProgress(const std::function<void(const ProgressCallback&)>& work);

  /** \throws CancelledException when the user interrupted the run */
  void
  stopIfInterrupted() const;

  /** \brief Something odd that did not stop the run; told once the run has succeeded. */
  void
  warn(const std::string& remark);

  /** \brief A warning that is of use only now, such as that the work will take long: told at
   * once, and in no report. */
  void
  warnAtOnce(const std::string& remark) const;

  /** \brief The warnings so far. */
  const std::vector<std::string>&
  warnings() const
  {
    return told_.report.remarks;
  }

  /** \brief Refuses to go on: there is nothing to write. The warnings so far are joined to
   * the reason. \throws NothingFound always */
  [[noreturn]] void
  failWithNothing(std::string reason) const;

  /** \brief A line of the summary on stdout. */
  void
  tell(const std::string& name, const std::string& value);

  /** \brief The line with the seconds of all steps so far. */
  void
  tellSeconds();

  /** \brief What goes into the JSON report besides what the base knows. */
  nlohmann::ordered_json&
  details()
  {
    return told_.details;
  }

  /** \brief Seconds of each step; the base adds them to the JSON report. */
  Report&
  report()
  {
    return told_.report;
  }

  /** \brief The report as it stands. */
  nlohmann::ordered_json
  fullReport() const;

  /** \brief Keeps what a stage tells apart from what the tool told so far.
   * \param[in] stage tells, and adds seconds, as the tool of that stage would
   * \return what it told */
  Told
  apart(const std::function<void()>& stage);

private:
  int
  parse(int argc, const char* const* argv);

  /** \brief Where an input is for another tool, what to do with it; else empty. */
  std::string
  otherDoor() const;

  void
  writeReport() const;

  void
  flushSummary() const;

  /** \brief Prints on stdout. \throws OutputFileException when it could not */
  void
  print(const std::string& text) const;

  void
  complain(const std::string& line) const;

  std::string name_;
  std::unique_ptr<CLI::App> app_;
  unsigned threads_ = 0;
  double scale_ = 1.0;
  std::vector<std::string> automatic_options_;
  std::string report_path_;
  bool quiet_ = false;
  std::size_t memory_limit_ = 0; // bytes; 0: none
  std::vector<std::string> command_line_;
  void (*pipe_action_)(int) = nullptr; // what SIGPIPE did when the tool was started
  Told told_;
};

/** \brief A number with a few significant digits, for the summary. */
std::string
shortNumber(double value);

} // namespace pcl::acmap
