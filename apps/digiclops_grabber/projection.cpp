#include "projection.h"

#include "memory.h"
#include "tool.h"

#include <pcl/acquisition/digiclops_grabber.h>
#include <pcl/acquisition/pattern_projector.h>
#include <pcl/acquisition/projector_latency.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

namespace pcl::acmap {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds surely_settled(700);

/** \brief Waits while a condition holds, or until the user interrupts it. */
template <typename Condition>
void
waitWhile(const Tool& tool, const Condition& condition)
{
  while (condition()) {
    tool.stopIfInterrupted();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

void
takeShot(const Tool& tool, DigiclopsGrabber& camera)
{
  camera.trigger();
  try {
    waitWhile(tool, [&] { return camera.isRunning(); });
  }
  catch (const CancelledException&) {
    camera.stop();
    throw;
  }
  if (camera.getError())
    std::rethrow_exception(camera.getError());
}

bool
isCertain(const DigiclopsGrabber& camera)
{
  const auto check = camera.getReport().order;
  return check && check->is_certain;
}

/** \brief Takes up to three shots under patterns, which provide corners everywhere,
 * until the grabber is certain of the order of its channels. Reports the order, or
 * warns if it remains uncertain.
 * \throws CameraException when a shot fails
 * \throws CancelledException when the user interrupted it */
void
checkOrder(Tool& tool,
           DigiclopsGrabber& camera,
           PatternProjector& projector,
           const std::vector<RgbImage>& patterns,
           StatusLine& status)
{
  const std::size_t shots =
      std::min<std::size_t>(DigiclopsGrabber::max_order_checks, patterns.size());
  for (std::size_t i = 0; i < shots; ++i) {
    projector.show(patterns[i]);
    const Clock::time_point settled = Clock::now() + surely_settled;
    waitWhile(tool, [&] { return Clock::now() < settled; });
    takeShot(tool, camera);
    if (isCertain(camera))
      break;
  }
  projector.showNothing();
  camera.rewind();
  const auto check = camera.getReport().order;
  const std::string order = textOf(camera.getChannelOrder());
  if (isCertain(camera))
    status.note("channels are " + order + ": " + shortNumber(100 * check->share) +
                " % of the corners agree, under the next order " +
                shortNumber(100 * check->runner_up) + " %");
  else
    tool.warn("the order of the channels could not be checked, it is taken as " +
              order);
}

constexpr double usual_settle_time = 0.1; // seconds
constexpr double shot_timeout = 5;        // seconds, in addition to the exposure
constexpr double external_timeout = 60; // seconds; an external trigger may take longer

std::vector<RgbImage>
drawPatterns(Tool& tool, PatternOptions pattern, const MonitorPlace& monitor)
{
  pattern.size = std::to_string(monitor.width) + "x" + std::to_string(monitor.height);
  RandomLinePattern generator = generatorOf(pattern);
  requireMemory(std::size_t{3} * pattern.patterns *
                    static_cast<std::size_t>(monitor.width) *
                    static_cast<std::size_t>(monitor.height),
                "the patterns");
  std::vector<RgbImage> patterns;
  for (std::uint32_t i = 0; i < pattern.patterns; ++i) {
    tool.stopIfInterrupted();
    patterns.push_back(generator.generate(i));
    for (const std::string& remark : generator.getReport().remarks)
      tool.warn(remark);
  }
  return patterns;
}

RgbImage
whiteOf(const MonitorPlace& monitor)
{
  const std::size_t pixels = static_cast<std::size_t>(monitor.width) *
                             static_cast<std::size_t>(monitor.height);
  return {monitor.width, monitor.height, std::vector<std::uint8_t>(3 * pixels, 255)};
}

double
settleTime(Tool& tool,
           const GrabberOptions& options,
           const Device& device,
           const shared_ptr<GuardedWindow>& window,
           StatusLine& status)
{
  if (options.settle.number)
    return *options.settle.number;
  if (!options.settle.is_auto)
    return usual_settle_time;
  const RgbImage white = whiteOf(window->getMonitor());
  const auto measured = measureSettleTime(device.camera, window, white);
  device.camera->rewind();
  if (!measured) {
    tool.warn("the settle time could not be measured: the camera sees the projector's "
              "light too faintly, or too late; it is taken as usual");
    return usual_settle_time;
  }
  status.note("the projector settles in " + shortNumber(*measured) + " s");
  return *measured;
}

} // namespace

GuardedWindow::GuardedWindow(std::mutex& drawing,
                             std::size_t monitor,
                             const std::string& display)
: drawing_(drawing)
, window_(monitor, display)
{}

void
GuardedWindow::show(const RgbImage& image)
{
  const std::lock_guard lock(drawing_);
  window_.show(image);
}

void
GuardedWindow::showNothing()
{
  const std::lock_guard lock(drawing_);
  window_.showNothing();
}

Projection
openProjection(Tool& tool,
               const GrabberOptions& options,
               const Device& device,
               std::mutex& drawing,
               StatusLine& status)
{
  Projection projection;
  projection.window.reset(new GuardedWindow(
      drawing, static_cast<std::size_t>(options.pattern.monitor), options.display));
  GuardedWindow& window = *projection.window;
  std::vector<RgbImage> patterns =
      drawPatterns(tool, options.pattern, window.getMonitor());
  // with fewer cameras the order cannot be determined
  if (options.channel_order == "auto" && device.camera->getMode().cameras() == 3)
    checkOrder(tool, *device.camera, window, patterns, status);
  const double settle = settleTime(tool, options, device, projection.window, status);
  projection.sequence.reset(new PatternSequenceGrabber(
      device.camera, projection.window, std::move(patterns)));
  projection.sequence->setSettleTime(settle);
  projection.sequence->setShotTimeout(
      options.trigger == "external"
          ? external_timeout
          : shot_timeout + 3 * options.shutter.number.value_or(0.0));
  return projection;
}

} // namespace pcl::acmap
