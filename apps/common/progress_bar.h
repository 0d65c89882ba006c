#pragma once

#include <chrono>
#include <string>

namespace pcl::acmap {

/** \brief One line on stderr with the progress and the remaining time; silent when
 * stderr is no terminal. */
class ProgressBar {
public:
  /** \param[in] wanted false for a bar that is not shown */
  explicit ProgressBar(bool wanted);

  /** \brief Clears the line. */
  ~ProgressBar();

  ProgressBar(const ProgressBar&) = delete;
  ProgressBar&
  operator=(const ProgressBar&) = delete;

  /** \param[in] fraction of the work that is done, in [0, 1]
   * \param[in] step name of the current step */
  void
  show(double fraction, const std::string& step);

private:
  using Clock = std::chrono::steady_clock;

  bool wanted_;
  bool shown_ = false;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_ = begin_;
};

/** \brief The text of the bar, without line ends.
 * \param[in] elapsed seconds since the start */
std::string
progressLine(double fraction, const std::string& step, double elapsed);

} // namespace pcl::acmap
