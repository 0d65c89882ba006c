#pragma once

#include "contradicted_output.h"
#include "exit_code.h"
#include "help_text.h"
#include "stage_log.h"

#include <pcl/core/interruption.h>
#include <pcl/core/printable_text.h>
#include <pcl/core/progress_bar.h>
#include <pcl/pipeline/depth_sensor.h>

#include <nlohmann/json.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Common base of all tools: common options, exit codes, one-line error
 * messages, progress, warnings, the summary on stdout and the report as JSON.
 *
 * A tool adds its own options, then passes its work to \ref run. */
class Tool {
public:
  /** \param[in] name of the program
   * \param[in] purpose one sentence for the help */
  Tool(std::string name, const std::string& purpose);
  ~Tool();

  /** \brief The command line, to which the tool adds its own options. */
  CLI::App&
  options()
  {
    return *app_;
  }

  /** \brief Sets the examples and the common options of the help. */
  void
  setHelp(HelpText help)
  {
    help_ = std::move(help);
  }

  /** \brief Adds `--threads`. */
  void
  addThreads();

  /** \brief Adds `--seed`.
   * \param[in] preset the default
   * \param[in] set is called with the seed that is given */
  void
  addSeed(std::uint64_t preset, const std::function<void(std::uint64_t)>& set);

  /** \brief What is stated of the input, for options that bind its setters. */
  PointCloudReader&
  reader()
  {
    return reader_;
  }

  /** \brief Adds `--sensor`. */
  void
  addSensor(DepthSensor& sensor);

  /** \brief Adds an option whose value is a length, `auto`, or left out.
   * \param[in] set is called with the length in metres, 0 for automatic, if the option
   * is given; its BadArgumentException is a fault of usage */
  void
  addLengthOrAuto(const std::string& name,
                  const std::function<void(double)>& set,
                  const std::string& description);

  /** \brief From now on, nothing is printed or reported: another process of this run does. */
  void
  beSilent()
  {
    is_silent_ = true;
  }

  /** \brief Parses the command line, does the work and reports. Returns the exit code
   * of main.
   * \param[in] work may throw the exceptions that \ref failureOf knows */
  int
  run(int argc, const char* const* argv, const std::function<void()>& work);

  /** \brief Checks the path of the report, if there is one, as \ref requireWritable
   * does. */
  void
  requireReportWritable(const std::vector<std::string>& others) const;

  /** \brief Names the folder of the results before they are made: that of the report,
   * unless another one is given, and the one that is emptied if their own evidence
   * contradicts them. */
  void
  setOutputFolder(const std::string& path)
  {
    output_ = ContradictedOutput(path);
    if (report_path_.empty())
      report_path_ = path + "/report.json";
  }

  /** \brief Names what runs that take about the same time for the same input share, beside the
   * tool: the time that is left is estimated by the last one of them. */
  void
  setRunKind(const std::string& kind)
  {
    kind_ = name_ + ": " + kind;
  }

  /** \brief Is this run no example for later ones, since parts of it were done before? */
  void
  forgetTime()
  {
    remembers_time_ = false;
  }

  /** \brief Options of the run that all tools share. Its callback draws the one progress bar of
   * the run and reports interruptions. */
  RunControls
  controls();

  /** \brief What this run reports. */
  StageLog&
  log()
  {
    return log_;
  }

  /** \brief Prints a warning immediately, for example that the work will take long. It
   * is not in the report. */
  void
  warnAtOnce(const std::string& remark) const;

  /** \brief The complete report so far. */
  nlohmann::ordered_json
  fullReport() const;

private:
  int
  parse(int argc, const char* const* argv);

  /** \brief Advice if the input is for another tool; otherwise empty. */
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
  std::string kind_; ///< of the run
  bool remembers_time_ = true;
  std::unique_ptr<CLI::App> app_;
  HelpText help_;
  unsigned threads_ = 0;
  PointCloudReader reader_;
  std::vector<std::string> automatic_options_;
  std::string report_path_;
  ContradictedOutput output_;
  bool quiet_ = false;
  bool is_silent_ = false;
  std::size_t memory_limit_ = 0; // bytes; 0: none
  std::vector<std::string> command_line_;
  void (*pipe_action_)(int) = nullptr; // original action of SIGPIPE
  StageLog log_;
  std::shared_ptr<ProgressBar> bar_ = std::make_shared<ProgressBar>();
};

/** \brief Message for a cloud that is not organized, although `--sensor` requires it. */
inline constexpr const char* needs_picture =
    "--sensor quantised and stereo are for one organized view in its sensor's frame, z "
    "forward, with at least 1000 points, or for what is left of one without its NaN "
    "pixels; leave --sensor out for this cloud";

} // namespace pcl::acmap
