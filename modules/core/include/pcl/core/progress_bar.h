#pragma once

#include <pcl/core/export.h>
#include <pcl/core/progress.h>
#include <pcl/core/time_left.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace pcl {

/** \brief The progress of a run: one line on a terminal with what is done, the step and the time
 * that is left, which is drawn again while nothing is told.
 * \code
 * pcl::ProgressBar bar;
 * bar.draw ();
 * mapping.setProgressCallback (bar.callback ());
 * mapping.compute (map);
 * bar.stop ();
 * \endcode
 * \ingroup core */
class ACMAP_EXPORT ProgressBar {
public:
  ProgressBar() = default;

  ProgressBar(const ProgressBar&) = delete;

  ProgressBar&
  operator=(const ProgressBar&) = delete;

  /** \brief Clears the line. */
  ~ProgressBar();

  /** \brief From now on, the progress is drawn on the terminal of stderr.
   * \param[in] earlier times of an earlier run of this kind; may be empty */
  void
  draw(RunTimes earlier = {});

  bool
  isDrawn() const;

  /** \brief Seconds since the run began. */
  double
  elapsed() const;

  /** \brief Takes progress, from any thread. A fraction that falls counts as the one before. */
  void
  tell(double fraction, const std::string& step);

  /** \brief A callback that tells it, and never stops the run; must not be called when this
   * object is gone. */
  ProgressCallback
  callback();

  /** \brief Prints a line on stderr; the bar goes on below it. */
  void
  print(const std::string& line);

  /** \brief Clears the line; nothing is drawn any more. */
  void
  stop();

  /** \brief The times of this run, which ends now. */
  RunTimes
  times() const;

  /** \brief The longest time without progress, seconds, and the step that was told before
   * it. */
  std::pair<double, std::string>
  longestSilence() const;

private:
  using Clock = std::chrono::steady_clock;

  /** \brief Redraws the line now and then, until \ref stop. */
  void
  keepDrawing();

  void
  drawLine();

  /** \brief The time to be told: it falls, unless it was wrong by far. */
  std::optional<double>
  shownTime();

  mutable std::mutex mutex_;
  std::condition_variable stopped_;
  std::thread drawer_;
  bool is_drawn_ = false, is_stopped_ = false;
  const Clock::time_point begin_ = Clock::now();
  TimeLeft time_left_;
  double fraction_ = 0;
  std::string step_ = "start";
  double told_at_ = 0;                ///< seconds since the begin
  double silence_ = 0;                ///< the longest
  std::string silent_step_ = "start"; ///< that was told before it
  std::optional<double> shown_;       ///< seconds left, as told
};

namespace acmap {

/** \brief The text of a progress bar, without line ends.
 * \param[in] fraction of the work that is done
 * \param[in] step name of the current step
 * \param[in] left seconds, if they are known
 * \param[in] width columns of the terminal */
ACMAP_EXPORT std::string
progressLine(double fraction,
             const std::string& step,
             const std::optional<double>& left,
             std::size_t width);

/** \brief Columns of the terminal of stdout, at least 40: those that the variable COLUMNS
 * states, or that the terminal tells, else 80. */
ACMAP_EXPORT std::size_t
terminalWidth();

} // namespace acmap

} // namespace pcl
