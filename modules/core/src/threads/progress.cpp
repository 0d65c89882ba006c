#include <pcl/core/impl/large_memory.h>
#include <pcl/core/progress.h>

#include <chrono>

namespace pcl::acmap {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds between_polls(100);

/** What a thread told last. */
struct LastTold {
  const Progress* progress = nullptr;
  double fraction = 0;
  std::string step;
  Clock::time_point next; ///< when it is told again
};

thread_local LastTold last_told;

} // namespace

Progress::~Progress()
{
  if (last_told.progress == this)
    last_told.progress = nullptr;
}

void
Progress::tell(double fraction, const std::string& step) const
{
  if (!callback_)
    return;
  if (!callback_(fraction, step))
    throw CancelledException("cancelled during " + step);
  last_told = {this, fraction, step, Clock::now() + between_polls};
}

void
pollRun()
{
  keepScratchSmall();
  if (!last_told.progress || Clock::now() < last_told.next)
    return;
  const LastTold told = last_told;
  last_told.progress = nullptr; // the callback may run long loops itself
  told.progress->tell(told.fraction, told.step);
}

} // namespace pcl::acmap
