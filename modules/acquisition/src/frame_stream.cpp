#include "frame_queue.h"

#include <pcl/acquisition/frame_stream.h>
#include <pcl/core/trinocular_rig.h>

namespace pcl {

namespace {

constexpr std::chrono::milliseconds between_frames(50);

std::size_t
bytesOfFrame(const TrinocularRig& rig)
{
  constexpr std::size_t bytes_per_pixel = 9; // three cameras, in colour
  return bytes_per_pixel * static_cast<std::size_t>(rig.width) *
         static_cast<std::size_t>(rig.height);
}

} // namespace

FrameStream::FrameStream(TrinocularGrabber& grabber)
: grabber_(grabber)
, queue_(std::make_unique<acmap::FrameQueue>(
      acmap::queueLength(bytesOfFrame(grabber.getRig()))))
{
  const std::function<TrinocularGrabber::FrameCallback> queue =
      [this](const TrinocularFrame::ConstPtr& frame) { queue_->push(frame); };
  connection_ = grabber.registerCallback(queue);
}

FrameStream::~FrameStream()
{
  end();
  connection_.disconnect();
}

TrinocularFrame::ConstPtr
FrameStream::next(std::chrono::milliseconds timeout)
{
  TrinocularFrame::ConstPtr frame = queue_->pop(timeout);
  frames_ += frame ? 1 : 0;
  return frame;
}

void
FrameStream::pass(const UseFrame& use, const IsOver& is_over)
{
  for (;;) {
    // asked before the frame, since the last one may come between both
    const bool is_running = grabber_.isRunning();
    const TrinocularFrame::ConstPtr frame = next(between_frames);
    if (frame) {
      if (!use(frame)) {
        end();
        return;
      }
    }
    else if (!is_running)
      break;
    if (is_over && is_over())
      end();
  }
  if (grabber_.getError())
    std::rethrow_exception(grabber_.getError());
}

void
FrameStream::end()
{
  // first: a grabber that waits for room in the queue could not stop
  queue_->close();
  grabber_.stop();
}

} // namespace pcl
