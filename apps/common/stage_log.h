#pragma once

#include <pcl/core/impl/json_text.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/point_cloud_reader.h>
#include <pcl/core/progress.h>
#include <pcl/core/report.h>

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief Report of a stage: lines of the summary, details of the JSON report, seconds
 * and warnings. */
struct StageLog {
  std::vector<std::pair<std::string, std::string>> lines; ///< of the summary
  nlohmann::ordered_json details = nlohmann::ordered_json::object();
  Report report; ///< seconds of each step, warnings
  /** \brief Why the result is wrong, if its own evidence contradicts it; else empty. */
  std::string contradiction;

  /** \brief Adds a line to the summary. */
  void
  tell(const std::string& name, const std::string& value);

  /** \brief Adds a line with the seconds of all steps so far to the summary. */
  void
  tellSeconds();

  /** \brief Adds a warning, once; warnings are printed once the run has succeeded. */
  void
  warn(const std::string& remark);

  void
  warn(const std::vector<std::string>& remarks);

  /** \brief Adds the first warnings of a list, and the number of the others.
   * \param[in] others what these are: "further frames, the report names them" */
  void
  warnOfFirst(std::size_t maximum,
              const std::vector<std::string>& remarks,
              const std::string& others);

  /** \brief Ends the run because there is no result. The warnings so far are appended
   * to the reason.
   * \throws NothingFound always */
  [[noreturn]] void
  failWithNothing(std::string reason) const;
};

/** \brief How a stage runs: the options that all tools share. */
struct RunControls {
  unsigned threads = 0;    ///< 0: all cores
  PointCloudReader reader; ///< with what is stated of the input
  /** \brief Draws the progress bar; stops the run after an interruption. */
  ProgressCallback progress;
  /** \brief Prints a stage that is finished, with the seconds since the one before, on a
   * terminal. */
  std::function<void(const std::string& stage)> finished;
  bool is_quiet = false; ///< only errors are printed
  /** \brief Prints a warning immediately, for example that the work will take long. It
   * is not in the report. */
  std::function<void(const std::string& remark)> warn_at_once;
};

/** \brief Report as JSON: "seconds", "summary", "warnings", "details". */
nlohmann::ordered_json
jsonOf(const StageLog& log);

/** \brief Reads the output of \ref jsonOf.
 * \throws nlohmann::json::exception when it has another form */
StageLog
stageLogIn(const nlohmann::ordered_json& json);

/** \brief Sum over all steps. */
double
totalSeconds(const StageLog& log);

} // namespace pcl::acmap
