#pragma once

#include <chrono>
#include <string>

namespace pcl::acmap {

/** \brief One line on stderr that tells how far the work is and how long it will take;
 * silent when stderr is no terminal. */
class ProgressBar {
public:
  /** \param[in] wanted false for a bar that shows nothing */
  explicit ProgressBar(bool wanted);

  /** \brief Wipes the line away. */
  ~ProgressBar();

  ProgressBar(const ProgressBar&) = delete;
  ProgressBar&
  operator=(const ProgressBar&) = delete;

  /** \param[in] fraction of the work that is done, in [0, 1]
   * \param[in] step what is being done */
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
 * \param[in] elapsed seconds since the work began */
std::string
progressLine(double fraction, const std::string& step, double elapsed);

} // namespace pcl::acmap
