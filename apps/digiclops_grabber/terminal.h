#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief Status of the acquisition. */
struct GrabStatus {
  std::string doing;                       ///< for example `observation 2, shot 5`
  std::optional<double> frames_per_second; ///< of a camera
  std::size_t frames = 0;
  std::size_t lost = 0;
  std::size_t broken = 0;
  std::optional<std::uintmax_t> written; ///< bytes on the disk; none: not recorded
  std::optional<std::uintmax_t> free;    ///< free bytes on the disk
};

/** \brief The status as one line, without line ends. */
std::string
statusText(const GrabStatus& status);

/** \brief One line on stderr that is updated repeatedly; silent when stderr is no
 * terminal. */
class StatusLine {
public:
  /** \param[in] wanted false for a line that prints nothing */
  explicit StatusLine(bool wanted);

  /** \brief Clears the line. */
  ~StatusLine();

  StatusLine(const StatusLine&) = delete;
  StatusLine&
  operator=(const StatusLine&) = delete;

  /** \brief Is it time for an update? Never if the line is not shown. */
  bool
  isDue() const;

  /** \brief Shows a text, truncated to the width of the terminal. */
  void
  show(const std::string& text);

  /** \brief Prints a line that stays, also if stderr is no terminal. */
  void
  note(const std::string& text);

private:
  void
  wipe();

  bool is_wanted_;
  bool is_shown_ = false;
  std::chrono::steady_clock::time_point last_;
};

/** \brief Decides when the next observation begins: by a clock, by the Enter key, or
 * immediately. */
class Pacing {
public:
  /** \param[in] every seconds from start to start; none: wait for the key, if standard
   * input is a terminal */
  explicit Pacing(const std::optional<double>& every);

  /** \brief Does it wait for the key? */
  bool
  asks() const
  {
    return asks_;
  }

  /** \brief Marks the start of an observation. */
  void
  begin();

  /** \brief Waits for the next one.
   * \param[in] idle is called repeatedly; may throw
   * \return false when the user ends the run: q, or the end of the input */
  bool
  wait(const std::function<void()>& idle) const;

private:
  std::optional<double> every_;
  bool asks_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

} // namespace pcl::acmap
