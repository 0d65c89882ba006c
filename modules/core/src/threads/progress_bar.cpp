#include <pcl/core/progress_bar.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace pcl {

namespace {

/** Written at once, and not by way of stdio: a process that is forked meanwhile has no part in it. */
void
writeOut(const std::string& text)
{
  const char* at = text.data();
  std::size_t left = text.size();
  while (left > 0) {
    const ssize_t written = ::write(STDERR_FILENO, at, left);
    if (written <= 0)
      return; // a terminal that is gone needs no progress
    at += written;
    left -= static_cast<std::size_t>(written);
  }
}

constexpr const char* clear_line = "\r\x1b[K";

std::string
timeText(double seconds)
{
  const long whole = std::lround(seconds);
  return whole < 60
             ? std::to_string(whole) + " s"
             : std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
}

} // namespace

ProgressBar::~ProgressBar()
{
  stop();
}

double
ProgressBar::elapsed() const
{
  return std::chrono::duration<double>(Clock::now() - begin_).count();
}

void
ProgressBar::draw(RunTimes earlier)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_drawn_)
    return;
  is_drawn_ = true;
  time_left_ = TimeLeft(std::move(earlier));
  time_left_.tell(fraction_, elapsed());
  drawer_ = std::thread([this] { keepDrawing(); });
}

bool
ProgressBar::isDrawn() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return is_drawn_;
}

void
ProgressBar::tell(double fraction, const std::string& step)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const double now = elapsed();
  if (now - told_at_ > silence_) {
    silence_ = now - told_at_;
    silent_step_ = step_;
  }
  told_at_ = now;
  step_ = step;
  fraction_ = std::max(fraction_, std::min(fraction, 1.0));
  time_left_.tell(fraction_, now);
}

std::optional<double>
ProgressBar::shownTime()
{
  constexpr double wrong = 1.3, seconds = 2;
  const std::optional<double> left = time_left_.at(elapsed());
  if (!left || !shown_ || *left < *shown_ || *left > wrong * *shown_ + seconds)
    shown_ = left;
  return shown_;
}

void
ProgressBar::drawLine()
{
  writeOut("\r" +
           acmap::progressLine(fraction_, step_, shownTime(), acmap::terminalWidth()) +
           "\x1b[K");
}

void
ProgressBar::keepDrawing()
{
  constexpr std::chrono::milliseconds between(200);
  std::unique_lock<std::mutex> lock(mutex_);
  while (!stopped_.wait_for(lock, between, [this] { return is_stopped_; }))
    drawLine();
}

void
ProgressBar::print(const std::string& line)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  writeOut((is_drawn_ && !is_stopped_ ? clear_line : "") + line + "\n");
}

void
ProgressBar::stop()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!is_drawn_ || is_stopped_)
      return;
    is_stopped_ = true;
  }
  stopped_.notify_all();
  drawer_.join();
  writeOut(clear_line);
}

RunTimes
ProgressBar::times() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return time_left_.times(elapsed());
}

std::pair<double, std::string>
ProgressBar::longestSilence() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const double last = elapsed() - told_at_;
  const bool is_last = last > silence_;
  return {is_last ? last : silence_, is_last ? step_ : silent_step_};
}

ProgressCallback
ProgressBar::callback()
{
  return [this](double fraction, const std::string& step) {
    tell(fraction, step);
    return true;
  };
}

namespace acmap {

std::string
progressLine(double fraction,
             const std::string& step,
             const std::optional<double>& left,
             std::size_t width)
{
  constexpr int bar_width = 30;
  fraction = std::clamp(fraction, 0.0, 1.0);
  const auto filled = static_cast<std::size_t>(std::floor(fraction * bar_width));
  std::string line = "[" + std::string(filled, '#') +
                     std::string(bar_width - filled, '.') + "] " +
                     std::to_string(std::lround(fraction * 100)) + " % " + step;
  const std::string time = left ? ", " + timeText(*left) + " left" : "";
  const std::size_t room = width - std::min(width, time.size() + 1);
  return line.substr(0, room) + time;
}

std::size_t
terminalWidth()
{
  constexpr std::size_t least = 40, usual = 80;
  std::size_t width = 0;
  if (const char* const columns = std::getenv("COLUMNS"))
    width = std::strtoul(columns, nullptr, 10);
  winsize window{};
  if (width == 0 && ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0)
    width = window.ws_col;
  return width == 0 ? usual : std::max(width, least);
}

} // namespace acmap

} // namespace pcl
