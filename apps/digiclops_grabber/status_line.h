#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief What is told while frames come. */
struct GrabStatus {
  std::string doing;                       ///< say `observation 2, shot 5`
  std::optional<double> frames_per_second; ///< of a camera
  std::size_t frames = 0;
  std::size_t lost = 0;
  std::size_t broken = 0;
  std::optional<std::uintmax_t>
      written;                        ///< bytes on the disk; none: nothing is recorded
  std::optional<std::uintmax_t> free; ///< bytes that are left there
};

/** \brief It as a line, without line ends. */
std::string
statusText(const GrabStatus& status);

/** \brief One line on stderr that is written again and again; silent when stderr is no
 * terminal. */
class StatusLine {
public:
  /** \param[in] wanted false for one that shows and notes nothing */
  explicit StatusLine(bool wanted);

  /** \brief Wipes the line away. */
  ~StatusLine();

  StatusLine(const StatusLine&) = delete;
  StatusLine&
  operator=(const StatusLine&) = delete;

  /** \brief Whether it is time for another text. */
  bool
  isDue() const;

  /** \brief As much of it as the terminal has room for. */
  void
  show(const std::string& text);

  /** \brief A line that stays, whatever stderr is. */
  void
  note(const std::string& text);

private:
  using Clock = std::chrono::steady_clock;

  void
  wipe();

  bool is_wanted_;
  bool is_terminal_;
  bool is_shown_ = false;
  Clock::time_point last_;
};

} // namespace pcl::acmap
