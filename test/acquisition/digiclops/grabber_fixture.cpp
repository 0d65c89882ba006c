#include "grabber_fixture.h"

#include <cstdio>
#include <cstdlib>
#include <future>

namespace pcl::acmap::test {
namespace {

constexpr auto long_enough = 30s; // much longer than needed

} // namespace

GrabberLog::GrabberLog(DigiclopsGrabber& grabber)
{
  const std::function<TrinocularGrabber::FrameCallback> note_frame =
      [this](const TrinocularFrame::ConstPtr& frame) {
        {
          const std::lock_guard lock(mutex_);
          frames_.push_back(frame);
        }
        changed_.notify_all();
        if (on_frame)
          on_frame();
      };
  const std::function<DigiclopsGrabber::ErrorCallback> note_error =
      [this](const CameraException& error) {
        {
          const std::lock_guard lock(mutex_);
          error_time_ = Clock::now();
          errors_.push_back(error.fault());
        }
        changed_.notify_all();
        if (on_error)
          on_error();
      };
  grabber.registerCallback(note_frame);
  grabber.registerCallback(note_error);
}

bool
GrabberLog::awaitFrames(std::size_t count)
{
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, long_enough, [&] { return frames_.size() >= count; });
}

bool
GrabberLog::awaitErrors(std::size_t count)
{
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, long_enough, [&] { return errors_.size() >= count; });
}

std::vector<TrinocularFrame::ConstPtr>
GrabberLog::frames() const
{
  const std::lock_guard lock(mutex_);
  return frames_;
}

std::vector<CameraFault>
GrabberLog::errors() const
{
  const std::lock_guard lock(mutex_);
  return errors_;
}

Clock::time_point
GrabberLog::timeOfLastError() const
{
  const std::lock_guard lock(mutex_);
  return error_time_;
}

TrinocularRig
rigWith(bool horizontal, bool vertical)
{
  TrinocularRig rig;
  rig.baseline_horizontal = horizontal ? -0.1 : 0;
  rig.baseline_vertical = vertical ? -0.1 : 0;
  return rig;
}

void
requireEnd(const std::function<void()>& work)
{
  const auto end = std::async(std::launch::async, work);
  if (end.wait_for(2 * long_enough) == std::future_status::ready)
    return;
  std::fputs("it hangs\n", stderr);
  std::abort();
}

CameraOptions
patientCamera()
{
  CameraOptions options;
  options.buffered_frames = 30;
  return options;
}

DigiclopsTest::DigiclopsTest(const CameraOptions& options)
: emulated_([this](const Exposure& exposure) { return images_.expose(exposure); },
            options)
{}

void
DigiclopsTest::open(const TrinocularRig& rig)
{
  grabber_ = std::make_unique<DigiclopsGrabber>(rig);
  grabber_->setFramesPerSecond(30);
  grabber_->setTimeout(0.2);
  log_ = std::make_unique<GrabberLog>(*grabber_);
}

void
DigiclopsTest::startFor(std::size_t frames)
{
  const std::size_t before = log_->frames().size();
  grabber_->start();
  EXPECT_TRUE(log_->awaitFrames(before + frames));
}

std::vector<std::uint64_t>
DigiclopsTest::sentNumbers(const Sending& sending) const
{
  std::vector<std::uint64_t> numbers;
  for (const TrinocularFrame::ConstPtr& frame : log_->frames())
    numbers.push_back(numberOf(*frame, images_, sending));
  return numbers;
}

} // namespace pcl::acmap::test
