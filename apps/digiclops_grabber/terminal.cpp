#include "terminal.h"

#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <thread>

namespace pcl::acmap {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds between_texts(200);
constexpr std::chrono::milliseconds between_looks(50);

std::string
formatted(const char* format, double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

std::string
bytesText(std::uintmax_t bytes)
{
  const auto number = static_cast<double>(bytes);
  return number < 1e9 ? formatted("%.0f MB", number / 1e6)
                      : formatted("%.1f GB", number / 1e9);
}

/** \brief Returns the line that was typed, up to Enter; nothing if there is none
 * yet. */
std::optional<std::string>
typedLine()
{
  pollfd input = {STDIN_FILENO, POLLIN, 0};
  if (poll(&input, 1, static_cast<int>(between_looks.count())) <= 0)
    return std::nullopt;
  char text[256];
  const ssize_t count = read(STDIN_FILENO, text, sizeof(text));
  return count > 0 ? std::string(text, static_cast<std::size_t>(count)) : std::string();
}

} // namespace

std::string
statusText(const GrabStatus& status)
{
  std::string text;
  if (!status.doing.empty())
    text = status.doing + ": ";
  if (status.frames_per_second)
    text += formatted("%.1f fps, ", *status.frames_per_second);
  text += "frames " + std::to_string(status.frames) + ", lost " +
          std::to_string(status.lost) + ", broken " + std::to_string(status.broken);
  if (status.written)
    text += ", written " + bytesText(*status.written);
  if (status.free)
    text += ", free " + bytesText(*status.free);
  return text;
}

StatusLine::StatusLine(bool wanted)
: is_wanted_(wanted)
{}

StatusLine::~StatusLine()
{
  wipe();
}

bool
StatusLine::isDue() const
{
  return is_wanted_ && isatty(STDERR_FILENO) != 0 &&
         Clock::now() - last_ >= between_texts;
}

void
StatusLine::show(const std::string& text)
{
  last_ = Clock::now();
  is_shown_ = true;
  winsize size = {};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0)
    size.ws_col = 80;
  // a line that wraps could not be overwritten
  std::fprintf(stderr, "\r%s\x1b[K", text.substr(0, size.ws_col - 1u).c_str());
}

void
StatusLine::note(const std::string& text)
{
  if (!is_wanted_)
    return;
  wipe();
  std::fprintf(stderr, "pcl_digiclops_grabber: %s\n", text.c_str());
}

void
StatusLine::wipe()
{
  if (is_shown_)
    std::fputs("\r\x1b[K", stderr);
  is_shown_ = false;
}

Pacing::Pacing(const std::optional<double>& every)
: every_(every)
, asks_(!every && isatty(STDIN_FILENO) != 0)
{}

void
Pacing::begin()
{
  begin_ = Clock::now();
}

bool
Pacing::wait(const std::function<void()>& idle) const
{
  if (every_)
    while (std::chrono::duration<double>(Clock::now() - begin_).count() < *every_) {
      idle();
      std::this_thread::sleep_for(between_looks);
    }
  while (asks_) {
    idle();
    if (const auto line = typedLine())
      return !line->empty() && line->front() != 'q';
  }
  return true;
}

} // namespace pcl::acmap
