#include "projector_watch.h"

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <algorithm>

namespace pcl::acmap::test {

namespace {

constexpr std::chrono::milliseconds between_looks(2);
constexpr std::chrono::seconds patience(5);
// rows that are compared, percent of the height
constexpr std::array<int, 3> looked_at = {20, 50, 80};

std::vector<std::uint8_t>
rowOf(const RgbImage& image, int row)
{
  const std::ptrdiff_t length = 3 * std::ptrdiff_t{image.width};
  const auto begin = image.values.begin() + row * length;
  return {begin, begin + length};
}

std::vector<std::uint8_t>
rowOnScreen(Display* display, int row)
{
  const auto width = static_cast<unsigned>(DisplayWidth(display, 0));
  XImage* const image = XGetImage(
      display, DefaultRootWindow(display), 0, row, width, 1, AllPlanes, ZPixmap);
  std::vector<std::uint8_t> values;
  for (int column = 0; column < image->width; ++column) {
    const unsigned long pixel = XGetPixel(image, column, 0);
    for (const int shift : {16, 8, 0}) // order of channels in Xvfb
      values.push_back(static_cast<std::uint8_t>(pixel >> shift));
  }
  XDestroyImage(image);
  return values;
}

} // namespace

ProjectorWatch::ProjectorWatch(const std::vector<RgbImage>& patterns)
{
  for (const RgbImage& pattern : patterns) {
    std::vector<Row>& rows = rows_.emplace_back();
    for (const int percent : looked_at)
      rows.push_back(rowOf(pattern, pattern.height * percent / 100));
  }
  last_look_ = Clock::now() - std::chrono::hours(1);
  changes_.emplace_back(last_look_, dark);
  thread_ = std::thread([this] { watch(); });
}

ProjectorWatch::~ProjectorWatch()
{
  ends_ = true;
  thread_.join();
}

void
ProjectorWatch::watch()
{
  Display* const display = XOpenDisplay(nullptr);
  if (!display)
    return; // everything is dark
  while (!ends_) {
    const Clock::time_point now = Clock::now();
    std::vector<Row> rows;
    for (const int percent : looked_at)
      rows.push_back(rowOnScreen(display, DisplayHeight(display, 0) * percent / 100));
    const int pattern = patternOf(rows);
    {
      const std::lock_guard lock(mutex_);
      // the earliest possible time: a delayed look must not make the projector appear
      // late
      if (changes_.back().second != pattern)
        changes_.emplace_back(last_look_, pattern);
      last_look_ = now;
    }
    looked_.notify_all();
    std::this_thread::sleep_for(between_looks);
  }
  XCloseDisplay(display);
}

int
ProjectorWatch::patternOf(const std::vector<Row>& rows) const
{
  const auto is_dark = [](const Row& row) {
    return std::all_of(row.begin(), row.end(), [](std::uint8_t v) { return v == 0; });
  };
  if (std::all_of(rows.begin(), rows.end(), is_dark))
    return dark;
  const auto found = std::find(rows_.begin(), rows_.end(), rows);
  return found == rows_.end() ? something_else
                              : static_cast<int>(found - rows_.begin());
}

std::set<int>
ProjectorWatch::shownWithin(Clock::time_point begin, Clock::time_point end) const
{
  const Clock::duration delay = delay_.load();
  std::set<int> shown;
  std::unique_lock lock(mutex_);
  looked_.wait_for(lock, patience, [&] { return last_look_ >= end; });
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    const bool is_over =
        i + 1 < changes_.size() && changes_[i + 1].first + delay <= begin;
    if (!is_over && changes_[i].first + delay <= end)
      shown.insert(changes_[i].second);
  }
  return shown;
}

} // namespace pcl::acmap::test
