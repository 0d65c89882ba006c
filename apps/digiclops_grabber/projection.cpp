#include "projection.h"

#include "memory.h"

#include <pcl/acquisition/projector_latency.h>

#include <thread>

namespace pcl::acmap {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds surely_settled(700);
constexpr double usual_settle_time = 0.1; // seconds
constexpr double shot_timeout = 5;        // seconds, in addition to the exposure
constexpr double external_timeout = 60; // seconds; an external trigger may take longer

/** \brief A projector's monitor, which is used only while no other thread draws. */
class GuardedWindow : public PatternProjector {
public:
  GuardedWindow(std::mutex& drawing, const GrabberOptions& options)
  : drawing_(drawing)
  , window_(static_cast<std::size_t>(options.pattern.monitor), options.display)
  {}

  const MonitorPlace&
  getMonitor() const
  {
    return window_.getMonitor();
  }

  void
  show(const RgbImage& image) override
  {
    const std::lock_guard lock(drawing_);
    window_.show(image);
  }

  void
  showNothing() override
  {
    const std::lock_guard lock(drawing_);
    window_.showNothing();
  }

private:
  std::mutex& drawing_;
  PatternWindow window_;
};

/** \brief Waits while a condition holds, or until the user interrupts it. */
template <typename Condition>
void
waitWhile(const Condition& condition)
{
  while (condition()) {
    stopIfInterrupted();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

void
takeShot(DigiclopsGrabber& camera)
{
  camera.trigger();
  try {
    waitWhile([&] { return camera.isRunning(); });
  }
  catch (const CancelledException&) {
    camera.stop();
    throw;
  }
  if (camera.getError())
    std::rethrow_exception(camera.getError());
}

/** \brief Takes up to three shots under patterns, which provide corners everywhere,
 * until the grabber is certain of the order of its channels. Reports the order, or
 * warns if it remains uncertain. */
void
checkOrder(DigiclopsGrabber& camera,
           PatternProjector& projector,
           const std::vector<RgbImage>& patterns,
           StatusLine& status,
           StageLog& log)
{
  const auto is_certain = [&] {
    const auto check = camera.getReport().order;
    return check && check->is_certain;
  };
  const std::size_t shots =
      std::min<std::size_t>(DigiclopsGrabber::max_order_checks, patterns.size());
  for (std::size_t i = 0; i < shots && !is_certain(); ++i) {
    projector.show(patterns[i]);
    const Clock::time_point settled = Clock::now() + surely_settled;
    waitWhile([&] { return Clock::now() < settled; });
    takeShot(camera);
  }
  projector.showNothing();
  camera.rewind();
  const auto check = camera.getReport().order;
  const std::string order = textOf(camera.getChannelOrder());
  if (is_certain())
    status.note("channels are " + order + ": " + shortNumber(100 * check->share) +
                " % of the corners agree, under the next order " +
                shortNumber(100 * check->runner_up) + " %");
  else
    log.warn("the order of the channels could not be checked, it is taken as " + order);
}

std::vector<RgbImage>
drawPatterns(PatternOptions pattern, const MonitorPlace& monitor, StageLog& log)
{
  pattern.size = std::to_string(monitor.width) + "x" + std::to_string(monitor.height);
  RandomLinePattern generator = generatorOf(pattern);
  requireMemory(std::size_t{3} * pattern.patterns *
                    static_cast<std::size_t>(monitor.width) *
                    static_cast<std::size_t>(monitor.height),
                "the patterns");
  std::vector<RgbImage> patterns;
  for (std::uint32_t i = 0; i < pattern.patterns; ++i) {
    stopIfInterrupted();
    patterns.push_back(generator.generate(i));
    for (const std::string& remark : generator.getReport().remarks)
      log.warn(remark);
  }
  return patterns;
}

double
settleTime(const GrabberOptions& options,
           const Device& device,
           const shared_ptr<GuardedWindow>& window,
           StatusLine& status,
           StageLog& log)
{
  if (options.settle.number)
    return *options.settle.number;
  if (!options.settle.is_auto)
    return usual_settle_time;
  const MonitorPlace& monitor = window->getMonitor();
  const std::size_t pixels = static_cast<std::size_t>(monitor.width) *
                             static_cast<std::size_t>(monitor.height);
  const RgbImage white{
      monitor.width, monitor.height, std::vector<std::uint8_t>(3 * pixels, 255)};
  const auto measured = measureSettleTime(device.camera, window, white);
  device.camera->rewind();
  if (!measured) {
    log.warn("the settle time could not be measured: the camera sees the projector's "
             "light too faintly, or too late; it is taken as usual");
    return usual_settle_time;
  }
  status.note("the projector settles in " + shortNumber(*measured) + " s");
  return *measured;
}

} // namespace

Projection
openProjection(const GrabberOptions& options,
               const Device& device,
               std::mutex& drawing,
               StatusLine& status,
               StageLog& log)
{
  const shared_ptr<GuardedWindow> window(new GuardedWindow(drawing, options));
  std::vector<RgbImage> patterns =
      drawPatterns(options.pattern, window->getMonitor(), log);
  // with fewer cameras the order cannot be determined
  if (options.channel_order == "auto" && device.camera->getMode().cameras() == 3)
    checkOrder(*device.camera, *window, patterns, status, log);
  const double settle = settleTime(options, device, window, status, log);
  Projection projection;
  projection.monitor = window->getMonitor();
  projection.sequence.reset(
      new PatternSequenceGrabber(device.camera, window, std::move(patterns)));
  projection.sequence->setSettleTime(settle);
  projection.sequence->setShotTimeout(
      options.trigger == "external"
          ? external_timeout
          : shot_timeout + 3 * options.shutter.number.value_or(0.0));
  return projection;
}

} // namespace pcl::acmap
