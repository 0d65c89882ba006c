#include "grabber_fixture.h"

#include <atomic>
#include <thread>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Numbers = std::vector<std::uint64_t>;

class GrabberFaults : public DigiclopsTest {
protected:
  GrabberFaults()
  {
    open();
  }

  /** Expects that the error is reported in all three ways and that the stream has
   * ended. */
  void
  expectFault(CameraFault fault)
  {
    EXPECT_TRUE(log_->awaitErrors(1));
    grabber_->wait();
    EXPECT_FALSE(grabber_->isRunning());
    EXPECT_THAT(log_->errors(), ElementsAre(fault));
    EXPECT_EQ(grabber_->getFault(), fault);
    EXPECT_EQ(faultOf([&] {
                if (grabber_->getError())
                  std::rethrow_exception(grabber_->getError());
              }),
              fault);
  }

  void
  expectFrames(std::size_t frames)
  {
    startFor(frames);
    grabber_->stop();
    EXPECT_EQ(grabber_->getFault(), CameraFault::None);
    EXPECT_EQ(grabber_->getError(), nullptr);
  }
};

TEST_F(GrabberFaults, ShortFramesAreLeftOut)
{
  for (const std::uint64_t number : {0, 4, 5, 9})
    emulated_.faults().failFrame(FrameFault::Short, number);
  expectFrames(10);
  Numbers sent = sentNumbers();
  ASSERT_GE(sent.size(), 8U);
  sent.resize(8);
  EXPECT_THAT(sent, ElementsAre(1, 2, 3, 6, 7, 8, 10, 11));
  EXPECT_EQ(grabber_->getReport().broken, 4U);
  for (std::size_t i = 0; i < sent.size(); ++i)
    EXPECT_EQ(log_->frames()[i]->number, sent[i] - sent[0]);
}

TEST_F(GrabberFaults, FramesWithACounterThatCannotBeAreLeftOut)
{
  emulated_.faults().failFrame(FrameFault::WrongCounter, 4);
  emulated_.faults().failFrame(FrameFault::WrongCounter, 7);
  expectFrames(8);
  Numbers sent = sentNumbers();
  ASSERT_GE(sent.size(), 7U);
  sent.resize(7);
  EXPECT_THAT(sent, ElementsAre(0, 1, 2, 3, 5, 6, 8));
  EXPECT_EQ(grabber_->getReport().broken, 2U);
}

TEST_F(GrabberFaults, ElevenBrokenFramesInARowAreAnError)
{
  emulated_.faults().failFramesFrom(FrameFault::Short, 2);
  startFor(2);
  expectFault(CameraFault::Corrupt);
  EXPECT_EQ(grabber_->getReport().broken, 11U);
  emulated_.faults().heal();
  expectFrames(3);
}

TEST_F(GrabberFaults, TenBrokenFramesInARowAreNone)
{
  emulated_.faults().failFramesFrom(FrameFault::Short, 2);
  emulated_.faults().failFramesFrom(FrameFault::None, 12);
  expectFrames(5);
  EXPECT_EQ(grabber_->getReport().broken, 10U);
}

TEST_F(GrabberFaults, AStallIsCleared)
{
  emulated_.faults().failFrame(FrameFault::Stall, 3);
  expectFrames(8);
  const Numbers sent = sentNumbers();
  ASSERT_GE(sent.size(), 4U);
  EXPECT_THAT(Numbers(sent.begin(), sent.begin() + 3), ElementsAre(0, 1, 2));
  EXPECT_GT(sent[3], 3U);
}

TEST_F(GrabberFaults, SilenceIsAnErrorInTheEnd)
{
  startFor(2);
  const auto begin = Clock::now();
  emulated_.faults().setSilent(true);
  expectFault(CameraFault::Silent);
  EXPECT_LT(Clock::now() - begin, 10s); // three timeouts of 0.3 s
  EXPECT_EQ(grabber_->getReport().restarts, 2U);
  emulated_.faults().heal();
  expectFrames(3);
}

TEST_F(GrabberFaults, AStreamThatFellSilentIsBegunAgain)
{
  startFor(2);
  emulated_.faults().setSilent(true);
  while (grabber_->getReport().restarts == 0 && grabber_->isRunning())
    std::this_thread::sleep_for(1ms);
  emulated_.faults().setSilent(false);
  const std::size_t before = log_->frames().size();
  EXPECT_TRUE(log_->awaitFrames(before + 4));
  grabber_->stop();
  EXPECT_THAT(log_->errors(), IsEmpty());
  EXPECT_EQ(grabber_->getReport().restarts, 1U);
  sentNumbers();
}

TEST_F(GrabberFaults, UnpluggingInsideAFrameIsToldWithinASecond)
{
  emulated_.faults().failFramesFrom(FrameFault::Unplug, 40); // one frame may be lost
  startFor(3);
  while (cable_.plugged() && grabber_->isRunning())
    std::this_thread::sleep_for(1ms);
  const auto begin = Clock::now();
  expectFault(CameraFault::Unplugged);
  const auto delay = log_->timeOfLastError() - begin;
  RecordProperty("microseconds", static_cast<int>(delay / 1us));
  EXPECT_LE(delay, 1s);
  const Numbers sent = sentNumbers(); // none of them is incomplete
  for (std::size_t i = 0; i < sent.size(); ++i)
    EXPECT_EQ(sent[i], i);
  EXPECT_LE(sent.size(), 40U);
}

TEST_F(GrabberFaults, UnpluggingBetweenFramesIsToldWithinASecond)
{
  grabber_->setFramesPerSecond(1.875F);
  startFor(1);
  const auto begin = Clock::now();
  cable_.unplug();
  expectFault(CameraFault::Unplugged);
  const auto delay = log_->timeOfLastError() - begin;
  RecordProperty("microseconds", static_cast<int>(delay / 1us));
  EXPECT_LE(delay, 1s);
}

TEST_F(GrabberFaults, ACameraThatIsBackIsAsItWas)
{
  IidcCamera& camera = grabber_->camera();
  grabber_->setFramesPerSecond(25);
  camera.setPhysical(IidcFeature::Shutter, 0.004F);
  camera.setValue(IidcFeature::Gain, 300);
  startFor(2);
  cable_.unplug();
  expectFault(CameraFault::Unplugged);
  EXPECT_EQ(faultOf([&] { grabber_->start(); }), CameraFault::NotFound);
  EXPECT_EQ(faultOf([&] { grabber_->trigger(); }), CameraFault::NotFound);
  EXPECT_FALSE(grabber_->isRunning());
  cable_.plug();
  const std::size_t before = log_->frames().size();
  expectFrames(3);
  numberOf(*log_->frames().at(before), images_);
  EXPECT_FLOAT_EQ(camera.feature(IidcFeature::Shutter).physical->value, 0.004F);
  EXPECT_EQ(camera.feature(IidcFeature::Gain).value, 300U);
  EXPECT_FLOAT_EQ(camera.feature(IidcFeature::FrameRate).physical->value, 25);
  EXPECT_TRUE(camera.hasFrameCounter());
}

/** The stream has ended when the error callback is called, so the callback may start a
 * new one. */
TEST_F(GrabberFaults, StartInTheErrorCallbackBeginsAnew)
{
  std::atomic<int> refused{0};
  log_->on_error = [&] {
    emulated_.faults().heal();
    refused += faultOf([&] { grabber_->start(); }) == CameraFault::None ? 0 : 1;
  };
  startFor(2);
  emulated_.faults().setSilent(true);
  EXPECT_TRUE(log_->awaitErrors(1));
  const std::size_t before = log_->frames().size();
  EXPECT_TRUE(log_->awaitFrames(before + 3));
  requireEnd([&] { grabber_->stop(); });
  EXPECT_EQ(refused, 0);
  EXPECT_EQ(grabber_->getFault(), CameraFault::None);
  EXPECT_EQ(grabber_->getError(), nullptr);
}

TEST_F(GrabberFaults, StartInTheErrorCallbackOfACameraThatIsGone)
{
  std::atomic<CameraFault> told{CameraFault::None};
  log_->on_error = [&] { told = faultOf([&] { grabber_->start(); }); };
  startFor(2);
  cable_.unplug();
  requireEnd([&] { grabber_->wait(); });
  EXPECT_EQ(told, CameraFault::NotFound);
  expectFault(CameraFault::Unplugged);
}

TEST_F(GrabberFaults, WhatTheErrorCallbackThrowsGoesNowhere)
{
  log_->on_error = [] { throw std::runtime_error("ignored"); };
  startFor(1);
  cable_.unplug();
  expectFault(CameraFault::Unplugged);
  cable_.plug();
  expectFrames(2);
}

TEST_F(GrabberFaults, GarbageInAllRegistersHurtsNoStream)
{
  startFor(2);
  emulated_.faults().overrideAllRegisters(1);
  const std::size_t before = log_->frames().size();
  EXPECT_TRUE(log_->awaitFrames(before + 5));
  grabber_->stop();
  sentNumbers();
  EXPECT_THAT(log_->errors(), IsEmpty());
}

TEST_F(GrabberFaults, GarbageInAllRegistersIsAnErrorOrNone)
{
  requireEnd([&] {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      grabber_->camera().close();
      emulated_.faults().overrideAllRegisters(seed);
      if (faultOf([&] { grabber_->start(); }) == CameraFault::None)
        std::this_thread::sleep_for(50ms);
      grabber_->stop();
      faultOf([&] { DigiclopsGrabber(rigWith(true, true)); });
    }
  });
  emulated_.faults().heal();
  grabber_->camera().close();
  expectFrames(3);
}

TEST_F(GrabberFaults, RegistersThatDoNotAnswerAreSilence)
{
  emulated_.faults().failControl(ControlFault::TimeOut, 3); // the number of attempts
  grabber_->start();
  expectFault(CameraFault::Silent);
  expectFrames(2);
}

TEST_F(GrabberFaults, PermissionIsAskedFor)
{
  grabber_.reset();
  cable_.setPermission(false);
  EXPECT_EQ(faultOf([&] { open(); }), CameraFault::PermissionDenied);
  cable_.setPermission(true);
  open();
  expectFrames(2);
  grabber_->camera().close();
  cable_.setPermission(false);
  EXPECT_EQ(faultOf([&] { grabber_->start(); }), CameraFault::PermissionDenied);
}

TEST_F(GrabberFaults, ACameraIsForOneAlone)
{
  EXPECT_EQ(faultOf([&] { DigiclopsGrabber(rigWith(true, true)); }), CameraFault::Busy);
  expectFrames(2);
}

} // namespace
} // namespace pcl::acmap::test
