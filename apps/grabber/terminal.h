#pragma once

#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <utility>

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
inline std::string
statusText(const GrabStatus& status)
{
  const auto formatted = [](const char* format, double value) {
    char text[32];
    std::snprintf(text, sizeof(text), format, value);
    return std::string(text);
  };
  const auto bytes = [&](std::uintmax_t count) {
    const auto number = static_cast<double>(count);
    return number < 1e9 ? formatted("%.0f MB", number / 1e6)
                        : formatted("%.1f GB", number / 1e9);
  };
  std::string text;
  if (!status.doing.empty())
    text = status.doing + ": ";
  if (status.frames_per_second)
    text += formatted("%.1f fps, ", *status.frames_per_second);
  text += "frames " + std::to_string(status.frames) + ", lost " +
          std::to_string(status.lost) + ", broken " + std::to_string(status.broken);
  if (status.written)
    text += ", written " + bytes(*status.written);
  if (status.free)
    text += ", free " + bytes(*status.free);
  return text;
}

/** \brief One line on stderr that is updated repeatedly; silent when stderr is no
 * terminal. */
class StatusLine {
public:
  /** \param[in] tool its name
   * \param[in] wanted false for a line that prints nothing */
  StatusLine(std::string tool, bool wanted)
  : tool_(std::move(tool))
  , is_wanted_(wanted)
  {}

  /** \brief Clears the line. */
  ~StatusLine()
  {
    wipe();
  }

  StatusLine(const StatusLine&) = delete;
  StatusLine&
  operator=(const StatusLine&) = delete;

  /** \brief Is it time for an update? Never if the line is not shown. */
  bool
  isDue() const
  {
    constexpr std::chrono::milliseconds between_texts(200);
    return is_wanted_ && isatty(STDERR_FILENO) != 0 &&
           Clock::now() - last_ >= between_texts;
  }

  /** \brief Shows a text, truncated to the width of the terminal. */
  void
  show(const std::string& text)
  {
    last_ = Clock::now();
    is_shown_ = true;
    winsize size = {};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0)
      size.ws_col = 80;
    // a line that wraps could not be overwritten
    std::fprintf(stderr, "\r%s\x1b[K", text.substr(0, size.ws_col - 1u).c_str());
  }

  /** \brief Prints a line that stays, also if stderr is no terminal. */
  void
  note(const std::string& text)
  {
    if (!is_wanted_)
      return;
    wipe();
    std::fprintf(stderr, "%s: %s\n", tool_.c_str(), text.c_str());
  }

private:
  using Clock = std::chrono::steady_clock;

  void
  wipe()
  {
    if (is_shown_)
      std::fputs("\r\x1b[K", stderr);
    is_shown_ = false;
  }

  std::string tool_;
  bool is_wanted_;
  bool is_shown_ = false;
  Clock::time_point last_;
};

/** \brief Decides when the next observation begins: by a clock, by the Enter key, or
 * immediately. */
class Pacing {
public:
  /** \param[in] every seconds from start to start; none: wait for the key, if standard
   * input is a terminal */
  explicit Pacing(const std::optional<double>& every)
  : every_(every)
  , asks_(!every && isatty(STDIN_FILENO) != 0)
  {}

  /** \brief Does it wait for the key? */
  bool
  asks() const
  {
    return asks_;
  }

  /** \brief Marks the start of an observation. */
  void
  begin()
  {
    begin_ = Clock::now();
  }

  /** \brief Waits for the next one.
   * \param[in] idle is called repeatedly; may throw
   * \return false when the user ends the run: q, or the end of the input */
  bool
  wait(const std::function<void()>& idle) const
  {
    if (every_)
      while (std::chrono::duration<double>(Clock::now() - begin_).count() < *every_) {
        idle();
        std::this_thread::sleep_for(between_looks);
      }
    while (asks_) {
      idle();
      pollfd input = {STDIN_FILENO, POLLIN, 0};
      if (poll(&input, 1, static_cast<int>(between_looks.count())) <= 0)
        continue;
      char line[256]; // up to Enter
      return read(STDIN_FILENO, line, sizeof(line)) > 0 && line[0] != 'q';
    }
    return true;
  }

private:
  using Clock = std::chrono::steady_clock;

  static constexpr std::chrono::milliseconds between_looks{50};

  std::optional<double> every_;
  bool asks_;
  Clock::time_point begin_ = Clock::now();
};

} // namespace pcl::acmap
