#include "progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pcl::acmap {
namespace {

constexpr int bar_width = 30;
constexpr double seconds_between = 0.1;
constexpr double min_fraction_for_guess = 0.02;

std::string
timeText(double seconds)
{
  const long whole = std::lround(seconds);
  return whole < 60
             ? std::to_string(whole) + " s"
             : std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
}

} // namespace

std::string
progressLine(double fraction, const std::string& step, double elapsed)
{
  fraction = std::clamp(fraction, 0.0, 1.0);
  const auto filled = static_cast<std::size_t>(std::floor(fraction * bar_width));
  std::string line = "[" + std::string(filled, '#') +
                     std::string(bar_width - filled, '.') + "] " +
                     std::to_string(std::lround(fraction * 100)) + " % " + step;
  if (fraction >= min_fraction_for_guess)
    line += ", " + timeText(elapsed / fraction * (1 - fraction)) + " left";
  return line;
}

ProgressBar::ProgressBar(bool wanted)
: wanted_(wanted && isatty(STDERR_FILENO))
{}

ProgressBar::~ProgressBar()
{
  if (shown_)
    std::fputs("\r\x1b[K", stderr);
}

void
ProgressBar::show(double fraction, const std::string& step)
{
  const auto now = Clock::now();
  if (!wanted_ || std::chrono::duration<double>(now - last_).count() < seconds_between)
    return;
  last_ = now;
  shown_ = true;
  const double elapsed = std::chrono::duration<double>(now - begin_).count();
  std::fprintf(stderr, "\r%s\x1b[K", progressLine(fraction, step, elapsed).c_str());
}

} // namespace pcl::acmap
