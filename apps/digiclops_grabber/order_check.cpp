#include "order_check.h"

#include <algorithm>
#include <chrono>
#include <thread>

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

} // namespace

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

} // namespace pcl::acmap
