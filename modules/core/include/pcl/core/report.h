#pragma once

#include <pcl/core/build_config.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace pcl {

/** \brief Report of the last run, common to all stages; stages add their own counts.
 * \ingroup core */
struct Report {
  /** \brief Wall-clock seconds of each step, in the order they ran. */
  std::vector<std::pair<std::string, double>> seconds;

  /** \brief Warnings, one per entry: why an output is empty or partial, what was
   * skipped. Empty if there are none. */
  std::vector<std::string> remarks;
};

namespace acmap {

/** \brief Adds the remarks of a step that the report does not have yet. */
inline void
addRemarks(Report& report, const std::vector<std::string>& remarks)
{
  for (const std::string& remark : remarks)
    if (std::find(report.remarks.begin(), report.remarks.end(), remark) ==
        report.remarks.end())
      report.remarks.push_back(remark);
}

/** \brief Adds the time since construction, or since the last call, to a report. */
class StepTimer {
public:
  explicit StepTimer(Report& report)
  : report_(report)
  {}

  void
  finish(std::string step)
  {
    const auto now = Clock::now();
    report_.seconds.emplace_back(std::move(step),
                                 std::chrono::duration<double>(now - begin_).count());
    begin_ = now;
  }

private:
  using Clock = std::chrono::steady_clock;
  Report& report_;
  Clock::time_point begin_ = Clock::now();
};

} // namespace acmap
} // namespace pcl
