#include "status_line.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>

namespace pcl::acmap {

namespace {

constexpr std::chrono::milliseconds between_texts(200);

std::string
bytesText(std::uintmax_t bytes)
{
  constexpr double mega = 1e6;
  constexpr double giga = 1e9;
  const auto number = static_cast<double>(bytes);
  char text[32];
  if (number < giga)
    std::snprintf(text, sizeof(text), "%.0f MB", number / mega);
  else
    std::snprintf(text, sizeof(text), "%.1f GB", number / giga);
  return text;
}

std::size_t
columns()
{
  constexpr std::size_t usual = 80;
  winsize size = {};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0)
    return usual;
  return size.ws_col;
}

} // namespace

std::string
statusText(const GrabStatus& status)
{
  std::string text;
  if (!status.doing.empty())
    text = status.doing + ": ";
  if (status.frames_per_second) {
    char rate[32];
    std::snprintf(rate, sizeof(rate), "%.1f fps, ", *status.frames_per_second);
    text += rate;
  }
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
, is_terminal_(isatty(STDERR_FILENO) != 0)
{}

StatusLine::~StatusLine()
{
  wipe();
}

bool
StatusLine::isDue() const
{
  return is_wanted_ && is_terminal_ && Clock::now() - last_ >= between_texts;
}

void
StatusLine::show(const std::string& text)
{
  if (!is_wanted_ || !is_terminal_)
    return;
  last_ = Clock::now();
  is_shown_ = true;
  // a line that wraps could not be overwritten
  std::fprintf(stderr, "\r%s\x1b[K", text.substr(0, columns() - 1).c_str());
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

} // namespace pcl::acmap
