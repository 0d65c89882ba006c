#include "sequence_rig.h"
#include "thrown_faults.h"

#include <pcl/core/camera_exception.h>

#include <gmock/gmock.h>

#include <atomic>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class SequenceFault : public SequenceRig {
protected:
  /** Lets the second shot of observation 0 fail, and continues afterwards. */
  void
  expectFault(PatternSequenceGrabber& grabber, const std::string& message)
  {
    grabber.observe();
    grabber.observe(); // is discarded together with the first one
    grabber.wait();
    EXPECT_FALSE(grabber.isRunning());
    EXPECT_THAT(errorOf(grabber), HasSubstr(message));
    EXPECT_EQ(grabber.getReport().observations, 0U);
    EXPECT_FALSE(camera_->isRunning());
    is_sound_ = true;
    const std::size_t before = frames().size();
    grabber.observe();
    grabber.wait();
    EXPECT_EQ(errorOf(grabber), "") << "forgotten";
    EXPECT_EQ(grabber.getReport().observations, 1U);
    expectAtRest();
    const Frames given = frames();
    ASSERT_EQ(given.size(), before + 4);
    for (std::size_t i = before; i < given.size(); ++i) {
      EXPECT_EQ(given[i]->number, i);
      EXPECT_EQ(given[i]->observation, 1);
      EXPECT_TRUE(showsOnly(*given[i], levelOf(given[i]->pattern))) << i;
    }
  }

  std::atomic<bool> is_sound_{false};
};

TEST_F(SequenceFault, OfACallback)
{
  const auto grabber = open(3, [&](const TrinocularFrame& frame) {
    if (!is_sound_ && frame.pattern == 0)
      throw OutputFileException("the disk is full");
  });
  expectFault(*grabber, "the disk is full");
  EXPECT_EQ(shots(), "0.off 0.0 1.off 1.0 1.1 1.2");
}

TEST_F(SequenceFault, OfACallbackAtTheLastShot)
{
  const auto grabber = open(3, [&](const TrinocularFrame& frame) {
    if (!is_sound_ && frame.pattern == 2)
      throw OutputFileException("the disk is full");
  });
  expectFault(*grabber, "the disk is full");
}

TEST_F(SequenceFault, OfWantMore)
{
  const auto grabber = open(3);
  grabber->setWantMore([&](const auto&) {
    if (!is_sound_)
      throw std::runtime_error("fusion fault");
    return true;
  });
  expectFault(*grabber, "fusion fault");
  EXPECT_EQ(shots(), "0.off 0.0 1.off 1.0 1.1 1.2");
}

TEST_F(SequenceFault, OfTheProjector)
{
  lamp_->before = [&](int level) {
    if (!is_sound_ && level > 0)
      throw IOException("the display is gone");
  };
  const auto grabber = open(3);
  expectFault(*grabber, "the display is gone");
  EXPECT_EQ(shots(), "0.off 1.off 1.0 1.1 1.2");
}

TEST_F(SequenceFault, OfTheProjectorForEver)
{
  int calls = 0;
  lamp_->before = [&](int) {
    throw IOException("the display is gone " + std::to_string(++calls));
  };
  const auto grabber = open(1);
  grabber->start();
  grabber->wait();
  EXPECT_THAT(errorOf(*grabber), HasSubstr("is gone 1")) << "the first one is kept";
  EXPECT_EQ(calls, 2) << "dark was tried all the same";
  lamp_->before = [&, number = 0](int) mutable {
    if (++number == 3) // black at the end of the observation
      throw IOException("no black");
  };
  grabber->observe();
  grabber->wait();
  EXPECT_THAT(errorOf(*grabber), HasSubstr("no black"));
  EXPECT_EQ(shots(), "0.off 0.0");
}

TEST_F(SequenceFault, OfTheCamerasTrigger)
{
  camera_->on_trigger = [&] {
    if (!is_sound_ && camera_->triggers() == 2)
      throw CameraException(CameraFault::Unplugged, "the camera is gone");
  };
  const auto grabber = open(3);
  expectFault(*grabber, "the camera is gone");
}

TEST_F(SequenceFault, OfTheCamerasStream)
{
  camera_->on_shot = [&] {
    if (!is_sound_ && camera_->triggers() == 2)
      throw CameraException(CameraFault::Corrupt, "no frame is whole");
  };
  const auto grabber = open(3);
  grabber->setShotTimeout(600);
  expectFault(*grabber, "no frame is whole"); // does not wait for the timeout
}

TEST_F(SequenceFault, OfACameraThatGivesNoShot)
{
  camera_->on_shot = [&] {
    camera_->gives_frames = is_sound_ || camera_->triggers() != 2;
  };
  const auto grabber = open(3);
  grabber->setShotTimeout(0.25);
  grabber->observe();
  grabber->wait();
  EXPECT_EQ(streamFaultOf(*grabber), CameraFault::Silent);
  grabber->rewind();
  camera_->on_shot = [&] { camera_->gives_frames = is_sound_; };
  grabber->trigger();
  grabber->wait();
  EXPECT_THAT(errorOf(*grabber), HasSubstr("ShutterCamera gave no shot within 0.25 s"));
  expectAtRest();
  is_sound_ = true;
  grabber->setShotTimeout(5);
  grabber->observe();
  grabber->wait();
  EXPECT_EQ(errorOf(*grabber), "");
  EXPECT_EQ(shots(), "0.off 0.off 0.0 0.1 0.2");
}

TEST_F(SequenceFault, OfACameraThatStreamsForOthers)
{
  camera_->start();
  const auto grabber = open(1);
  grabber->setShotTimeout(0.05);
  grabber->observe();
  grabber->wait();
  EXPECT_EQ(streamFaultOf(*grabber), CameraFault::Silent);
  EXPECT_THAT(errorOf(*grabber), HasSubstr("streams for others"));
  EXPECT_EQ(shots(), "");
  expectAtRest();
}

TEST_F(SequenceFault, AShotThatComesTooLateIsNotTakenForTheNext)
{
  const auto grabber = open(2);
  grabber->setShotTimeout(0.25);
  const std::function<TrinocularGrabber::FrameCallback> dawdle = [&](const auto&) {
    std::this_thread::sleep_for(Milliseconds(5)); // delays the end of the camera's
                                                  // stream
  };
  camera_->registerCallback(dawdle);
  camera_->on_trigger = [&] {
    const bool is_late = light_->told() == levelOf(0) && !is_sound_;
    camera_->exposure = Milliseconds(is_late ? 600 : 40);
  };
  grabber->observe();
  grabber->wait();
  EXPECT_EQ(streamFaultOf(*grabber), CameraFault::Silent);
  is_sound_ = true;
  grabber->setShotTimeout(5);
  // a shot that was not requested, under the light of pattern 1
  lamp_->show(flatImage(levelOf(1)));
  camera_->trigger();
  std::this_thread::sleep_for(Milliseconds(10));
  grabber->observe();
  grabber->wait();
  EXPECT_EQ(errorOf(*grabber), "");
  EXPECT_EQ(shots(), "0.off 1.off 1.0 1.1");
  for (const TrinocularFrame::ConstPtr& frame : frames())
    EXPECT_TRUE(showsOnly(*frame, levelOf(frame->pattern))) << frame->pattern;
}

TEST_F(SequenceFault, FramesThatNobodyAskedForAreLeftOut)
{
  camera_->copies = 3;
  const auto grabber = open(2);
  grabber->observe();
  grabber->wait();
  EXPECT_EQ(shots(), "0.off 0.0 0.1");
  for (const TrinocularFrame::ConstPtr& frame : frames())
    EXPECT_TRUE(showsOnly(*frame, levelOf(frame->pattern))) << frame->pattern;
}

TEST_F(SequenceFault, CallbacksOfTheCameraMayFailToo)
{
  const auto grabber = open(1);
  const std::function<TrinocularGrabber::FrameCallback> fail = [](const auto&) {
    throw std::runtime_error("somebody else's fault");
  };
  const boost::signals2::scoped_connection connection = camera_->registerCallback(fail);
  grabber->observe(); // earlier frames would have arrived before
  grabber->wait();
  expectAtRest();
  const std::string error = errorOf(*grabber);
  EXPECT_TRUE(error.empty() || error == "somebody else's fault") << error;
}

} // namespace
} // namespace pcl::acmap::test
