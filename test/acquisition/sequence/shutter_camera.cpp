#include "shutter_camera.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::acmap::test {

ShutterCamera::ShutterCamera(std::shared_ptr<const LightClock> light)
: light_(std::move(light))
, signal_(createSignal<FrameCallback>())
, stream_([this] { return giveShot(); }, {})
{}

ShutterCamera::~ShutterCamera() noexcept
{
  stop();
}

void
ShutterCamera::start()
{
  stream_.add(StreamThread::endless);
}

void
ShutterCamera::stop()
{
  {
    const std::lock_guard lock(mutex_);
    ++stops_;
    stopped_.notify_all();
  }
  stream_.stop();
  const std::lock_guard lock(mutex_);
  --stops_;
}

void
ShutterCamera::trigger()
{
  ++triggers_;
  on_trigger();
  stream_.add(1);
}

void
ShutterCamera::wait()
{
  stream_.wait();
}

bool
ShutterCamera::isRunning() const
{
  return stream_.isRunning();
}

std::string
ShutterCamera::getName() const
{
  return "ShutterCamera";
}

TrinocularRig
ShutterCamera::getRig() const
{
  TrinocularRig rig;
  rig.width = width;
  rig.height = height;
  return rig;
}

std::exception_ptr
ShutterCamera::getError() const
{
  return stream_.error();
}

/** \return false if it was stopped */
bool
ShutterCamera::sleep(Milliseconds time)
{
  std::unique_lock lock(mutex_);
  return !stopped_.wait_for(lock, time, [this] { return stops_ > 0; });
}

bool
ShutterCamera::giveShot()
{
  on_shot();
  const Clock::time_point begin = Clock::now();
  if (!sleep(delay + exposure + row_time * height))
    return true;
  if (!gives_frames)
    return true;
  const TrinocularFrame::ConstPtr frame =
      expose(begin + std::chrono::duration_cast<Clock::duration>(delay));
  for (int i = 0; i < copies; ++i)
    (*signal_)(frame);
  return true;
}

TrinocularFrame::Ptr
ShutterCamera::expose(Clock::time_point begin)
{
  const auto frame = pcl::make_shared<TrinocularFrame>();
  frame->number = 1000;
  frame->observation = 77;
  frame->pattern = 55;
  frame->stamp = static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(begin.time_since_epoch())
          .count());
  for (CameraImage& image : frame->images) {
    image = {width, height, 1, {}};
    for (int row = 0; row < height; ++row) {
      const auto from =
          begin + std::chrono::duration_cast<Clock::duration>(row_time * row);
      const double light = row < lit_rows ? light_->exposed(from, exposure) : 0.0;
      for (int column = 0; column < width; ++column)
        image.values.push_back(static_cast<std::uint8_t>(std::clamp(
            std::lround(room + light + noise * random_.normal()), 0L, 255L)));
    }
  }
  return frame;
}

} // namespace pcl::acmap::test
