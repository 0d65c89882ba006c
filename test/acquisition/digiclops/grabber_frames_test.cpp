#include "frame_bytes.h"
#include "grabber_fixture.h"

#include <numeric>
#include <thread>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;
using Numbers = std::vector<std::uint64_t>;

Numbers
numbersFrom(std::uint64_t first, std::size_t count)
{
  Numbers numbers(count);
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

class GrabberFrames : public DigiclopsTest {
protected:
  using DigiclopsTest::DigiclopsTest;

  /** Compares all frames of a short stream with what was sent. */
  void
  expectFramesSent(const Sending& sending)
  {
    startFor(6);
    grabber_->stop();
    const Numbers sent = sentNumbers(sending);
    EXPECT_EQ(sent, numbersFrom(sent.front(), sent.size()));
  }
};

TEST_F(GrabberFrames, AreWhatTheCameraSent)
{
  open();
  EXPECT_EQ(grabber_->getMode().text(), "7:0 640x480 RGB8");
  EXPECT_FLOAT_EQ(grabber_->getFramesPerSecond(), 30);
  startFor(20);
  grabber_->stop();
  const auto frames = log_->frames();
  EXPECT_EQ(sentNumbers(), numbersFrom(0, frames.size()));
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i]->number, i);
    EXPECT_EQ(frames[i]->observation, static_cast<std::int32_t>(i));
    EXPECT_EQ(frames[i]->pattern, TrinocularFrame::no_pattern);
    EXPECT_TRUE(i == 0 || frames[i]->stamp > frames[i - 1]->stamp);
  }
  const DigiclopsGrabberReport report = grabber_->getReport();
  EXPECT_EQ(report.frames, frames.size());
  EXPECT_EQ(report.lost + report.broken + report.early + report.restarts, 0U);
  EXPECT_GT(report.frames_per_second, 1);
}

TEST_F(GrabberFrames, ComeAtThePapersRateUnlessAnotherOneIsSet)
{
  EXPECT_NEAR(DigiclopsGrabber(rigWith(true, true)).getFramesPerSecond(), 14, 0.5);
}

TEST_F(GrabberFrames, AreInTheChannelsThatWereSet)
{
  open();
  Sending sending;
  sending.order = {RigCamera::Vertical, RigCamera::Reference, RigCamera::Horizontal};
  grabber_->setChannelOrder(sending.order);
  expectFramesSent(sending);
  EXPECT_THROW(grabber_->setChannelOrder(
                   {RigCamera::Vertical, RigCamera::Reference, RigCamera::Vertical}),
               BadArgumentException);
  EXPECT_EQ(grabber_->getChannelOrder(), sending.order);
}

TEST_F(GrabberFrames, OfAFixedFormat)
{
  open();
  const IidcMode mode = grabber_->camera().modes().front();
  ASSERT_EQ(mode.text(), "0:4 640x480 RGB8");
  grabber_->setMode(mode);
  EXPECT_EQ(grabber_->getMode().text(), mode.text());
  expectFramesSent({});
}

TEST_F(GrabberFrames, OfTwoCameras)
{
  open(rigWith(true, false));
  EXPECT_EQ(grabber_->getMode().text(), "7:3 640x480 Mono16");
  Sending sending;
  sending.cameras = 2;
  expectFramesSent(sending);
  EXPECT_TRUE(log_->frames().front()->image(RigCamera::Vertical).empty());
}

TEST_F(GrabberFrames, OfTwoCamerasOneAboveTheOther)
{
  open(rigWith(false, true));
  Sending sending;
  sending.cameras = 2;
  sending.order = {RigCamera::Reference, RigCamera::Vertical, RigCamera::Horizontal};
  expectFramesSent(sending);
  EXPECT_TRUE(log_->frames().front()->image(RigCamera::Horizontal).empty());
}

TEST_F(GrabberFrames, OfOneCamera)
{
  open(rigWith(false, false));
  EXPECT_EQ(grabber_->getMode().text(), "7:0 640x480 Mono8");
  Sending sending;
  sending.cameras = 1;
  expectFramesSent(sending);
}

TEST_F(GrabberFrames, CountOnOverStreamsUntilTheyAreRewound)
{
  open();
  startFor(3);
  grabber_->stop();
  const std::size_t before = log_->frames().size();
  startFor(3);
  grabber_->stop();
  const std::size_t after = log_->frames().size();
  EXPECT_EQ(log_->frames()[before]->number, before);
  EXPECT_EQ(log_->frames().back()->number, after - 1);
  grabber_->rewind();
  startFor(1);
  grabber_->stop();
  EXPECT_EQ(log_->frames()[after]->number, 0U);
}

TEST_F(GrabberFrames, OfTwoCamerasAtOnceAreTheirOwn)
{
  NumberedImages other_images(2);
  CameraOptions options = patientCamera();
  options.identity.guid = 0x00B09D0100000002;
  EmulatedIidcCamera other(
      [&](const Exposure& exposure) { return other_images.expose(exposure); }, options);
  const EmulatedUsbCamera other_cable(testbed_, other);
  const TrinocularRig rig = rigWith(true, true);
  DigiclopsGrabber second(rig, "00b09d0100000002");
  grabber_ = std::make_unique<DigiclopsGrabber>(rig, "00B09D0100C0FFEE");
  log_ = std::make_unique<GrabberLog>(*grabber_);
  GrabberLog second_log(second);
  grabber_->start();
  second.start();
  EXPECT_TRUE(log_->awaitFrames(10));
  EXPECT_TRUE(second_log.awaitFrames(10));
  grabber_->stop();
  second.stop();
  const Numbers sent = sentNumbers();
  EXPECT_EQ(sent, numbersFrom(sent.front(), sent.size()));
  for (const TrinocularFrame::ConstPtr& frame : second_log.frames())
    numberOf(*frame, other_images);
  EXPECT_EQ(faultOf([&] { DigiclopsGrabber(rig, "00b09d0100000003"); }),
            CameraFault::NotFound);
}

TEST_F(GrabberFrames, AreOfTheModeThatTheStreamBeganWith)
{
  open();
  const IidcMode mode = grabber_->getMode();
  startFor(1);
  EXPECT_THROW(grabber_->setMode(mode), InitFailedException);
  EXPECT_THROW(grabber_->setFramesPerSecond(15), InitFailedException);
  grabber_->stop();
  grabber_->setFramesPerSecond(15);
  EXPECT_FLOAT_EQ(grabber_->getFramesPerSecond(), 15);
  for (const float rate : {0.0F, -1.0F, 1001.0F, std::nanf("")})
    EXPECT_THROW(grabber_->setFramesPerSecond(rate), BadArgumentException);
  EXPECT_THROW(grabber_->setMode(grabber_->camera().findMode(640, 480, 2)),
               BadArgumentException);
  EXPECT_EQ(grabber_->getMode().text(), mode.text());
}

TEST_F(GrabberFrames, NeedAModeOfTheRig)
{
  TrinocularRig rig = rigWith(true, true);
  rig.width = 1024;
  rig.height = 768;
  EXPECT_EQ(faultOf([&] { open(rig); }), CameraFault::Unsupported);
  rig.width = 0;
  EXPECT_THROW(open(rig), BadArgumentException);
}

/** A camera with a realistic buffer, and a callback that is slow once. */
class GrabberFramesLost : public DigiclopsTest {
protected:
  GrabberFramesLost()
  : DigiclopsTest(CameraOptions{})
  {}

  /** \return number of frames that were sent but did not arrive */
  std::size_t
  lose(const Sending& sending)
  {
    open();
    bool is_slow = true;
    log_->on_frame = [&] {
      if (std::exchange(is_slow, false))
        std::this_thread::sleep_for(1200ms); // 36 frames, of which the buffers hold 11
    };
    startFor(25);
    grabber_->stop();
    sent_ = sentNumbers(sending);
    return sent_.back() - sent_[0] + 1 - sent_.size();
  }

  Numbers sent_;
};

TEST_F(GrabberFramesLost, LeaveGaps)
{
  const std::size_t lost = lose({});
  EXPECT_GT(lost, 10U);
  EXPECT_EQ(grabber_->getReport().lost, lost);
  const auto frames = log_->frames();
  for (std::size_t i = 0; i < frames.size(); ++i)
    EXPECT_EQ(frames[i]->number, sent_[i] - sent_[0]);
}

TEST_F(GrabberFramesLost, AreEstimatedWithoutACounter)
{
  emulated_.faults().overrideRegister(iidc::frame_info, 0);
  Sending sending;
  sending.is_counted = false;
  const auto lost = static_cast<double>(lose(sending));
  EXPECT_GT(lost, 10);
  EXPECT_NEAR(static_cast<double>(grabber_->getReport().lost), lost, 0.3 * lost + 4);
  EXPECT_EQ(log_->frames().back()->number, sent_.size() - 1);
}

class GrabberFramesInColour : public GrabberFrames,
                              public testing::WithParamInterface<const char*> {
protected:
  static CameraOptions
  filter()
  {
    CameraOptions options = patientCamera();
    options.tiles = GetParam();
    return options;
  }

  GrabberFramesInColour()
  : GrabberFrames(filter())
  {}
};

TEST_P(GrabberFramesInColour, KeepWhatTheSensorSaw)
{
  open();
  Sending sending;
  sending.tiles = GetParam();
  expectFramesSent(sending);
}

INSTANTIATE_TEST_SUITE_P(,
                         GrabberFramesInColour,
                         testing::Values("RGGB", "GBRG", "GRBG", "BGGR"),
                         [](const auto& info) { return std::string(info.param); });

} // namespace
} // namespace pcl::acmap::test
