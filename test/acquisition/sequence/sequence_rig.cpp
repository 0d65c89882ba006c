#include "sequence_rig.h"

#include <algorithm>

namespace pcl::acmap::test {

bool
showsOnly(const TrinocularFrame& frame, int level)
{
  return std::all_of(
      frame.images.begin(), frame.images.end(), [level](const CameraImage& image) {
        return !image.empty() &&
               std::all_of(image.values.begin(),
                           image.values.end(),
                           [level](int value) { return value == level; });
      });
}

void
SequenceRig::setLight(Milliseconds latency, Milliseconds fade)
{
  light_ = std::make_shared<LightClock>(latency, fade);
  lamp_ = pcl::make_shared<Lamp>(light_);
  camera_ = pcl::make_shared<ShutterCamera>(light_);
}

std::unique_ptr<PatternSequenceGrabber>
SequenceRig::open(int patterns, const std::function<void(const TrinocularFrame&)>& more)
{
  auto grabber =
      std::make_unique<PatternSequenceGrabber>(camera_, lamp_, levelPatterns(patterns));
  grabber->setSettleTime(0);
  const std::function<TrinocularGrabber::FrameCallback> note =
      [this, more](const TrinocularFrame::ConstPtr& frame) {
        {
          const std::lock_guard lock(mutex_);
          frames_.push_back(frame);
        }
        more(*frame);
      };
  grabber->registerCallback(note);
  return grabber;
}

SequenceRig::Frames
SequenceRig::frames() const
{
  const std::lock_guard lock(mutex_);
  return frames_;
}

std::string
SequenceRig::shots() const
{
  std::string text;
  for (const TrinocularFrame::ConstPtr& frame : frames())
    text += (text.empty() ? "" : " ") + std::to_string(frame->observation) + "." +
            (frame->pattern < 0 ? "off" : std::to_string(frame->pattern));
  return text;
}

void
SequenceRig::waitForFrames(std::size_t count) const
{
  while (frames().size() < count)
    std::this_thread::sleep_for(Milliseconds(1));
}

void
SequenceRig::expectAtRest() const
{
  EXPECT_FALSE(camera_->isRunning());
  EXPECT_EQ(light_->told(), 0);
}

} // namespace pcl::acmap::test
