#include "sequence/shot_taker.h"

#include <pcl/core/camera_exception.h>
#include <pcl/core/exceptions.h>

#include <algorithm>
#include <sstream>
#include <utility>

namespace pcl::acmap {

namespace {

/** Polling interval for states of the camera that are not signalled. */
constexpr std::chrono::milliseconds look{2};

[[noreturn]] void
throwSilent(const TrinocularGrabber& camera,
            const std::string& what,
            ShotTaker::Seconds timeout)
{
  std::ostringstream text;
  text << camera.getName() << ' ' << what << ' ' << timeout.count() << " s";
  throw CameraException(CameraFault::Silent, text.str());
}

} // namespace

ShotTaker::ShotTaker(shared_ptr<TrinocularGrabber> camera,
                     shared_ptr<PatternProjector> projector)
: camera_(std::move(camera))
, projector_(std::move(projector))
{
  if (!camera_)
    throw acmap::BadArgument("there is no camera");
  if (!projector_)
    throw acmap::BadArgument("there is no projector");
  const std::function<TrinocularGrabber::FrameCallback> take =
      [inbox = inbox_](const TrinocularFrame::ConstPtr& frame) {
        const std::lock_guard lock(inbox->mutex);
        if (!inbox->frame)
          inbox->frame = frame;
        inbox->changed.notify_all();
      };
  connection_ = camera_->registerCallback(take);
}

void
ShotTaker::show(const RgbImage* pattern)
{
  if (pattern)
    projector_->show(*pattern);
  else
    projector_->showNothing();
  shown_ = Clock::now();
}

bool
ShotTaker::settle(Seconds time)
{
  return sleepUntil(shown_ + std::chrono::duration_cast<Clock::duration>(time));
}

bool
ShotTaker::sleepUntil(Clock::time_point end)
{
  std::unique_lock lock(inbox_->mutex);
  return !inbox_->changed.wait_until(
      lock, end, [this] { return inbox_->is_cancelled; });
}

/** Waits until the camera is idle: frames of an earlier trigger arrive before, never
 * after. */
bool
ShotTaker::waitForRest(Clock::time_point deadline)
{
  while (camera_->isRunning()) {
    const auto now = Clock::now();
    if (now >= deadline)
      return false;
    if (!sleepUntil(std::min(deadline, now + look)))
      return true;
  }
  return true;
}

void
ShotTaker::throwFaultOfCamera() const
{
  if (camera_->isRunning())
    return;
  if (const std::exception_ptr error = camera_->getError())
    std::rethrow_exception(error);
}

TrinocularFrame::ConstPtr
ShotTaker::shoot(Seconds timeout)
{
  const auto wait = std::chrono::duration_cast<Clock::duration>(timeout);
  if (!waitForRest(Clock::now() + wait))
    throwSilent(*camera_, "streams for others, and did not end within", timeout);
  std::unique_lock lock(inbox_->mutex);
  if (inbox_->is_cancelled)
    return nullptr;
  inbox_->frame = nullptr;
  lock.unlock();

  triggered_ = Clock::now();
  camera_->trigger();
  for (;;) {
    const auto now = Clock::now();
    lock.lock();
    inbox_->changed.wait_until(lock, std::min(triggered_ + wait, now + look), [this] {
      return inbox_->frame || inbox_->is_cancelled;
    });
    if (inbox_->is_cancelled)
      return nullptr;
    if (inbox_->frame)
      return std::exchange(inbox_->frame, nullptr);
    lock.unlock();
    throwFaultOfCamera();
    if (now >= triggered_ + wait)
      throwSilent(*camera_, "gave no shot within", timeout);
  }
}

void
ShotTaker::finish()
{
  std::exception_ptr error;
  try {
    camera_->stop();
  }
  catch (...) {
    error = std::current_exception();
  }
  projector_->showNothing();
  if (error)
    std::rethrow_exception(error);
}

void
ShotTaker::setCancelled(bool is_cancelled)
{
  const std::lock_guard lock(inbox_->mutex);
  inbox_->is_cancelled = is_cancelled;
  inbox_->changed.notify_all();
}

} // namespace pcl::acmap
