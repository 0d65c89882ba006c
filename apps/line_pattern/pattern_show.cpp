#include "pattern_show.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace pcl::acmap {
namespace {

std::string
sizeText(int width, int height)
{
  return std::to_string(width) + " x " + std::to_string(height) + " px";
}

} // namespace

PatternShow::PatternShow(Tool& tool,
                         const PatternOptions& options,
                         const RandomLinePattern& generator)
: tool_(tool)
, hold_(options.hold)
{
  if (!options.show)
    return;
  window_.emplace(static_cast<std::size_t>(options.monitor));
  const MonitorPlace& monitor = window_->getMonitor();
  if (monitor.width != generator.getWidth() || monitor.height != generator.getHeight())
    tool_.warn("monitor " + monitor.name + " has " +
               sizeText(monitor.width, monitor.height) + ", the patterns " +
               sizeText(generator.getWidth(), generator.getHeight()) +
               ": they are shown scaled");
}

void
PatternShow::show(const RgbImage& pattern)
{
  using Clock = std::chrono::steady_clock;
  if (!window_)
    return;
  window_->show(pattern);
  const auto end = Clock::now() + std::chrono::duration<double>(hold_);
  while (Clock::now() < end) {
    tool_.stopIfInterrupted();
    const std::chrono::duration<double> left = end - Clock::now();
    std::this_thread::sleep_for(std::min(left, std::chrono::duration<double>(0.05)));
  }
}

void
PatternShow::tell() const
{
  if (!window_)
    return;
  const MonitorPlace& monitor = window_->getMonitor();
  tool_.tell("shown",
             "on monitor " + monitor.name + ", " +
                 sizeText(monitor.width, monitor.height));
  tool_.details()["monitor"] = {{"name", monitor.name},
                                {"x", monitor.x},
                                {"y", monitor.y},
                                {"width", monitor.width},
                                {"height", monitor.height}};
}

} // namespace pcl::acmap
