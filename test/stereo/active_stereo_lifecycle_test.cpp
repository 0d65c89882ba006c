#include "active_stereo_session.h"

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace pcl::acmap::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/** \brief Start and stop, also in callbacks, and errors. */
class ActiveStereoLifecycle : public ActiveStereoSession {
protected:
  static void
  waitFor(const std::function<bool()>& condition)
  {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point deadline = Clock::now() + std::chrono::seconds(30);
    while (!condition()) {
      if (Clock::now() > deadline)
        throw std::runtime_error("what is waited for does not come");
      std::this_thread::yield();
    }
  }

  void
  waitForObservations(std::size_t count) const
  {
    waitFor([&] { return given().size() >= count; });
  }

  static void
  run(ActiveStereoGrabber& grabber)
  {
    grabber.start();
    grabber.wait();
  }

  static void
  onFrame(TrinocularGrabber& frames,
          const std::function<void(const TrinocularFrame&)>& work)
  {
    const std::function<TrinocularGrabber::FrameCallback> callback =
        [work](const TrinocularFrame::ConstPtr& frame) { work(*frame); };
    frames.registerCallback(callback);
  }
};

TEST_F(ActiveStereoLifecycle, NoCallbackAfterStopInFiftyCycles)
{
  std::atomic<bool> may_call{false};
  std::atomic<int> wrong{0};
  const auto grabber = grab(open(fast, true), [&] { wrong += may_call ? 0 : 1; });
  for (int cycle = 0; cycle < 50; ++cycle) {
    const std::size_t before = given().size();
    may_call = true;
    grabber->start();
    grabber->start(); // has no effect
    if (cycle % 5 == 0)
      waitForObservations(before + 1);
    else
      std::this_thread::sleep_for(std::chrono::milliseconds(cycle % 4));
    grabber->stop();
    may_call = false;
    EXPECT_FALSE(grabber->isRunning());
    grabber->stop();
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(errorOf(*grabber), "");
  EXPECT_GE(wholeOnes().size(), 10u);
}

TEST_F(ActiveStereoLifecycle, StopDropsTheObservationItCutsOff)
{
  const auto frames = open(0.001F); // the second frame would come much later
  std::atomic<bool> has_come{false};
  const auto grabber = grab(frames);
  onFrame(*frames, [&](const TrinocularFrame&) { has_come = true; });
  grabber->start();
  waitFor([&] { return has_come.load(); });
  grabber->stop();
  EXPECT_THAT(given(), IsEmpty());
  EXPECT_EQ(grabber->getReport().frames, 1u);
  EXPECT_THAT(grabber->getReport().remarks,
              ElementsAre(HasSubstr("observation 0 was cut off by stop: its 1 shots")));
}

TEST_F(ActiveStereoLifecycle, WhatWasCutOffStaysOutUnlessItComesAnew)
{
  const auto frames = simulate();
  ActiveStereoGrabber* self = nullptr;
  bool stops = true;
  // This callback is called before that of the grabber, for which it is an external
  // stop.
  onFrame(*frames, [&](const TrinocularFrame&) {
    if (std::exchange(stops, false))
      self->stop();
  });
  const auto grabber = grab(frames);
  self = grabber.get();
  run(*grabber);
  EXPECT_EQ(grabber->getReport().frames, 1u);
  EXPECT_EQ(grabber->getReport().remarks.size(), 1u);
  run(*grabber);
  EXPECT_EQ(grabber->getReport().frames, observations * shots - 1);
  EXPECT_THAT(grabber->getReport().remarks,
              ElementsAre(HasSubstr("observation 0 was cut off before")));
  EXPECT_THAT(wholeOnes(), ElementsAre(1, 2));
  frames->rewind();
  stops = true;
  run(*grabber);
  frames->rewind();
  run(*grabber);
  EXPECT_THAT(wholeOnes(), ElementsAre(1, 2, 0, 1, 2));
}

TEST_F(ActiveStereoLifecycle, ACallbackThatStopsLosesNothing)
{
  ActiveStereoGrabber* self = nullptr;
  const auto grabber = grab(simulate(), [&] {
    self->stop();
    self->wait();
    EXPECT_TRUE(self->isRunning()) << "it still calls";
  });
  self = grabber.get();
  for (const std::size_t count : {1u, 2u, 3u, 3u}) {
    run(*grabber);
    EXPECT_FALSE(grabber->isRunning());
    EXPECT_EQ(given().size(), count);
    grabber->stop(); // is already stopped
    EXPECT_THAT(grabber->getReport().remarks, IsEmpty());
    grabber->fusion().clear(); // removes the shot that has already arrived
  }
  EXPECT_THAT(wholeOnes(), ElementsAre(0, 1, 2));
}

TEST_F(ActiveStereoLifecycle, CallbacksOfTheFramesMayStopToo)
{
  const auto frames = simulate();
  const auto grabber = grab(frames);
  onFrame(*frames, [&](const TrinocularFrame& frame) {
    if (frame.number == 4) {
      grabber->stop();
      grabber->wait();
    }
  });
  run(*grabber);
  EXPECT_THAT(wholeOnes(), ElementsAre(0));
  run(*grabber); // continues within observation 1
  EXPECT_THAT(wholeOnes(), ElementsAre(0, 1, 2));
}

TEST_F(ActiveStereoLifecycle, CallbacksMayStopAndStart)
{
  ActiveStereoGrabber* self = nullptr;
  const auto frames = simulate();
  const auto grabber = grab(frames, [&] {
    self->start(); // has no effect
    self->stop();
    if (given().size() == observations)
      frames->rewind();
    if (given().size() < 2 * observations)
      self->start();
  });
  self = grabber.get();
  run(*grabber);
  EXPECT_THAT(wholeOnes(), ElementsAre(0, 1, 2, 0, 1, 2));
  EXPECT_EQ(grabber->getReport().frames, 2 * observations * shots);
}

TEST_F(ActiveStereoLifecycle, ASessionRewoundInAnObservationBeginsAnew)
{
  ActiveStereoGrabber* self = nullptr;
  const auto frames = simulate();
  const auto grabber = grab(frames, [&] {
    if (given().size() == 1)
      self->stop();
  });
  self = grabber.get();
  run(*grabber);
  frames->rewind();
  run(*grabber);
  EXPECT_THAT(wholeOnes(), ElementsAre(0, 0, 1, 2));
  EXPECT_THAT(grabber->getReport().remarks,
              ElementsAre(HasSubstr("observation 1 is dropped")));
}

TEST_F(ActiveStereoLifecycle, StopWinsOverCallbacksThatStart)
{
  ActiveStereoGrabber* self = nullptr;
  const auto grabber = grab(open(fast, true), [&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20)); // for stop ()
    self->stop();
    self->start();
  });
  self = grabber.get();
  for (int cycle = 0; cycle < 5; ++cycle) {
    const std::size_t before = given().size();
    grabber->start();
    waitForObservations(before + 1);
    grabber->stop();
    EXPECT_FALSE(grabber->isRunning());
    EXPECT_THAT(grabber->getReport().remarks, Contains(HasSubstr("cut off by stop")));
  }
}

TEST_F(ActiveStereoLifecycle, SeveralThreadsMayStopAndStart)
{
  const auto grabber = grab(open(fast, true));
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (int cycle = 0; cycle < 25; ++cycle) {
        grabber->start();
        std::this_thread::sleep_for(std::chrono::milliseconds(t));
        grabber->stop();
        if (t == 1)
          grabber->wait();
        EXPECT_LE(grabber->getReport().observations, given().size());
      }
    });
  for (std::thread& thread : threads)
    thread.join();
  grabber->stop();
  EXPECT_FALSE(grabber->isRunning());
  EXPECT_EQ(errorOf(*grabber), "");
}

TEST_F(ActiveStereoLifecycle, MayGoAwayWhileItOrItsFramesRun)
{
  const auto frames = open(fast, true);
  for (int i = 0; i < 10; ++i) {
    const auto grabber = grab(frames);
    grabber->start();
    waitForObservations(given().size() + 1);
  }
  EXPECT_FALSE(frames->isRunning());
  frames->start(); // for other users
  for (int i = 0; i < 50; ++i)
    EXPECT_EQ(grab(frames)->getReport().frames, 0u);
  EXPECT_TRUE(frames->isRunning());
  frames->stop();
}

TEST_F(ActiveStereoLifecycle, KeepsWhatACallbackThrows)
{
  int calls = 0;
  const auto grabber = grab(simulate(), [&] {
    if (++calls <= 2)
      throw std::runtime_error("callback fault " + std::to_string(calls));
  });
  run(*grabber); // also receives the first frame of observation 1, which is lost
  EXPECT_EQ(errorOf(*grabber), "callback fault 1");
  EXPECT_THAT(grabber->getReport().remarks,
              ElementsAre(HasSubstr("observation 1 was cut off by an error")));
  run(*grabber); // the error occurs at the end, in the other thread
  EXPECT_EQ(errorOf(*grabber), "callback fault 2");
  EXPECT_THAT(wholeOnes(), ElementsAre(0, 2));
  run(*grabber);
  EXPECT_EQ(errorOf(*grabber), "");
  EXPECT_FALSE(grabber->isRunning());
}

TEST_F(ActiveStereoLifecycle, AnErrorOfTheFramesEndsTheStream)
{
  const auto frames = open();
  damageFrame(4); // in observation 1
  const auto grabber = grab(frames);
  run(*grabber);
  EXPECT_THAT(errorOf(*grabber), HasSubstr("frame_000004.acf"));
  EXPECT_THAT(wholeOnes(), ElementsAre(0));
  EXPECT_THAT(grabber->getReport().remarks,
              ElementsAre(HasSubstr("observation 1 was cut off by an error")));
  frames->setSkipBroken(true);
  run(*grabber);
  EXPECT_EQ(errorOf(*grabber), "");
  EXPECT_THAT(wholeOnes(), ElementsAre(0, 2));
}

TEST_F(ActiveStereoLifecycle, AnErrorOfTheFusionEndsTheStream)
{
  const auto grabber = grab(simulate());
  int asked = 0;
  grabber->fusion().setProgressCallback(
      [&](double, const std::string&) { return ++asked != 1; });
  run(*grabber);
  EXPECT_TRUE(grabber->getError());
  EXPECT_THROW(std::rethrow_exception(grabber->getError()), CancelledException);
  EXPECT_THAT(given(), IsEmpty());
  grabber->fusion().setProgressCallback({});
  run(*grabber);
  EXPECT_EQ(errorOf(*grabber), "");
  EXPECT_EQ(wholeOnes().back(), 2);
}

} // namespace
} // namespace pcl::acmap::test
