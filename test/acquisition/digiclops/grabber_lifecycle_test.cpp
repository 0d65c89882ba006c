#include "grabber_fixture.h"

#include <pcl/core/exceptions.h>

#include <atomic>
#include <stdexcept>
#include <thread>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

class GrabberLifecycle : public DigiclopsTest {
protected:
  GrabberLifecycle()
  {
    open();
  }
};

TEST_F(GrabberLifecycle, AHundredStreams)
{
  std::atomic<bool> is_stopped{true};
  log_->on_frame = [&] { EXPECT_FALSE(is_stopped); };
  for (int cycle = 0; cycle < 100; ++cycle) {
    is_stopped = false;
    // Every third stream ends before its first frame.
    startFor(cycle % 3 == 0 ? 0 : 1);
    EXPECT_TRUE(grabber_->isRunning());
    grabber_->stop();
    is_stopped = true;
    EXPECT_FALSE(grabber_->isRunning());
  }
  EXPECT_EQ("", errorOf(*grabber_));
  sentNumbers();
  EXPECT_EQ(grabber_->getReport().restarts, 0U);
}

TEST_F(GrabberLifecycle, StartAndStopTwiceAreOnce)
{
  grabber_->stop();
  grabber_->start();
  grabber_->start();
  EXPECT_TRUE(log_->awaitFrames(3));
  grabber_->stop();
  grabber_->stop();
  const auto frames = log_->frames();
  for (std::size_t i = 0; i < frames.size(); ++i)
    EXPECT_EQ(frames[i]->number, i);
}

TEST_F(GrabberLifecycle, StopInACallbackMakesItTheLast)
{
  log_->on_frame = [&] { grabber_->stop(); };
  grabber_->start();
  grabber_->wait();
  EXPECT_EQ(log_->frames().size(), 1U);
  EXPECT_FALSE(grabber_->isRunning());
  grabber_->start();
  grabber_->wait();
  EXPECT_EQ(log_->frames().size(), 2U);
  EXPECT_EQ("", errorOf(*grabber_));
}

TEST_F(GrabberLifecycle, StopAndStartInACallbackGoOn)
{
  log_->on_frame = [&] {
    grabber_->stop();
    grabber_->start();
    grabber_->wait(); // called from its own stream: returns at once
  };
  startFor(5);
  grabber_->stop();
  EXPECT_EQ("", errorOf(*grabber_));
}

TEST_F(GrabberLifecycle, StopEndsAWait)
{
  grabber_->start();
  std::thread other([&] {
    EXPECT_TRUE(log_->awaitFrames(2));
    grabber_->stop();
  });
  grabber_->wait();
  EXPECT_FALSE(grabber_->isRunning());
  other.join();
}

TEST_F(GrabberLifecycle, ThreadsMayDisagree)
{
  requireEnd([&] {
    std::vector<std::thread> threads;
    for (int i = 0; i < 3; ++i)
      threads.emplace_back([this, i] {
        for (int k = 0; k < 25; ++k) {
          switch ((i + k) % 3) {
          case 0:
            grabber_->start();
            break;
          case 1:
            grabber_->stop();
            break;
          default:
            grabber_->trigger();
          }
          std::this_thread::sleep_for(3ms);
          grabber_->getReport();
        }
      });
    for (std::thread& thread : threads)
      thread.join();
    grabber_->stop();
  });
  EXPECT_FALSE(grabber_->isRunning());
  EXPECT_EQ("", errorOf(*grabber_));
  startFor(2);
  grabber_->stop();
  sentNumbers();
}

TEST_F(GrabberLifecycle, WhatACallbackThrowsEndsTheStream)
{
  log_->on_frame = [] { throw std::runtime_error("enough"); };
  grabber_->start();
  grabber_->wait();
  EXPECT_EQ(errorOf(*grabber_), "enough");
  EXPECT_EQ(log_->frames().size(), 1U);
  EXPECT_TRUE(log_->errors().empty()); // it is not an error of the camera
  EXPECT_EQ(grabber_->getFault(), CameraFault::None);
  EXPECT_TRUE(grabber_->camera().isOpen());
  log_->on_frame = nullptr;
  startFor(3);
  EXPECT_EQ("", errorOf(*grabber_));
  grabber_->stop();
}

TEST_F(GrabberLifecycle, MayEndWhileItStreams)
{
  startFor(2);
  grabber_.reset();
  const std::size_t frames = log_->frames().size();
  std::this_thread::sleep_for(100ms);
  EXPECT_EQ(log_->frames().size(), frames);
  open(); // succeeds, because the camera was released
  startFor(1);
}

TEST_F(GrabberLifecycle, IsAGrabberOfPcl)
{
  EXPECT_EQ(grabber_->getName(), "DigiclopsGrabber");
  EXPECT_TRUE(grabber_->providesCallback<TrinocularGrabber::FrameCallback>());
  EXPECT_TRUE(grabber_->providesCallback<DigiclopsGrabber::ErrorCallback>());
  EXPECT_EQ(grabber_->getRig().width, 640);
  EXPECT_FALSE(grabber_->isRunning());
}

TEST_F(GrabberLifecycle, RefusesSettingsThatCannotBe)
{
  for (const double timeout : {0.0, 0.009, 60.1, std::nan("")})
    EXPECT_THROW(grabber_->setTimeout(timeout), BadArgumentException) << timeout;
  EXPECT_EQ(grabber_->getTimeout(), 0.2);
  TrinocularRig small = rigWith(true, true);
  small.width = 320;
  EXPECT_THROW(grabber_->setCalibration(calibrationOf(small)), BadArgumentException);
}

/** A camera that waits for an external trigger. */
class GrabberUnderATrigger : public GrabberLifecycle {
protected:
  GrabberUnderATrigger()
  {
    grabber_->camera().setTrigger(IidcTrigger::External);
    grabber_->setTimeout(0.01);
  }
};

TEST_F(GrabberUnderATrigger, WaitsWithoutAnError)
{
  grabber_->start();
  std::this_thread::sleep_for(600ms); // much longer than its timeout
  EXPECT_TRUE(grabber_->isRunning());
  EXPECT_TRUE(log_->frames().empty());
  for (std::size_t i = 1; i <= 3; ++i) {
    emulated_.write(iidc::commands + iidc::software_trigger, iidc::on);
    EXPECT_TRUE(log_->awaitFrames(i));
    std::this_thread::sleep_for(120ms);
  }
  requireEnd([&] { grabber_->stop(); });
  EXPECT_EQ("", errorOf(*grabber_));
  const DigiclopsGrabberReport report = grabber_->getReport();
  EXPECT_EQ(report.frames, 3U);
  EXPECT_EQ(report.lost + report.restarts, 0U);
}

TEST_F(GrabberUnderATrigger, LosesNothingToPausesWithoutACounter)
{
  grabber_.reset();
  emulated_.faults().overrideRegister(iidc::frame_info, 0);
  open();
  grabber_->camera().setTrigger(IidcTrigger::External);
  grabber_->start();
  for (std::size_t i = 1; i <= 3; ++i) {
    std::this_thread::sleep_for(200ms);
    emulated_.write(iidc::commands + iidc::software_trigger, iidc::on);
    EXPECT_TRUE(log_->awaitFrames(i));
  }
  grabber_->stop();
  EXPECT_EQ(grabber_->getReport().lost, 0U);
}

/** A stop is not missed while the stream is starting. */
TEST_F(GrabberUnderATrigger, StopsAtAnyMoment)
{
  requireEnd([&] {
    for (int i = 0; i < 60; ++i) {
      grabber_->start();
      std::this_thread::sleep_for(std::chrono::microseconds(i * 150));
      grabber_->stop();
    }
  });
  EXPECT_EQ("", errorOf(*grabber_));
}

TEST_F(GrabberUnderATrigger, MayEndWhileItWaits)
{
  grabber_->start();
  std::this_thread::sleep_for(50ms);
  requireEnd([&] { grabber_.reset(); });
}

} // namespace
} // namespace pcl::acmap::test
