#include "messages.h"
#include "session_frames.h"
#include "temporary_folder.h"

#include <pcl/acquisition/trinocular_file_grabber.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <mutex>
#include <thread>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using FrameNumbers = std::vector<std::uint64_t>;

constexpr std::size_t recorded = 6;
constexpr float fast = 1000;

/** A session of six frames, and the frames delivered by a grabber. */
class SessionStream : public testing::Test {
protected:
  SessionStream()
  {
    recordSession(session_, rigOf(16, 12), recorded);
  }

  std::unique_ptr<TrinocularFileGrabber>
  open(
      float rate, bool repeat = false, const std::function<void()>& more = [] {})
  {
    auto grabber = std::make_unique<TrinocularFileGrabber>(session_, rate, repeat);
    const std::function<TrinocularGrabber::FrameCallback> note =
        [this, more](const TrinocularFrame::ConstPtr& frame) {
          {
            const std::lock_guard lock(mutex_);
            numbers_.push_back(frame->number);
            thread_ = std::this_thread::get_id();
          }
          more();
        };
    grabber->registerCallback(note);
    return grabber;
  }

  FrameNumbers
  numbers() const
  {
    const std::lock_guard lock(mutex_);
    return numbers_;
  }

  void
  waitForFrames(std::size_t count) const
  {
    while (numbers().size() < count)
      std::this_thread::yield();
  }

  std::string
  frameFile(int number) const
  {
    return session_ + "/frame_00000" + std::to_string(number) + ".acf";
  }

  TemporaryFolder folder_;
  std::string session_ = folder_.path("session");
  mutable std::mutex mutex_;
  FrameNumbers numbers_;
  std::thread::id thread_;
};

TEST_F(SessionStream, GivesAllFramesInOrderInAThreadOfItsOwn)
{
  const auto grabber = open(fast);
  EXPECT_EQ(grabber->getName(), "TrinocularFileGrabber");
  EXPECT_EQ(grabber->getFramesPerSecond(), fast);
  EXPECT_FALSE(grabber->isRunning());
  grabber->start();
  grabber->wait();
  EXPECT_FALSE(grabber->isRunning());
  EXPECT_THAT(numbers(), ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_NE(thread_, std::this_thread::get_id());
  EXPECT_EQ(errorOf(*grabber), "");
  grabber->start(); // at the end: no more frames
  grabber->wait();
  EXPECT_EQ(numbers().size(), recorded);
  grabber->rewind();
  grabber->start();
  grabber->wait();
  EXPECT_THAT(numbers(), ElementsAre(0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5));
}

TEST_F(SessionStream, RepeatsUntilStopped)
{
  const auto grabber = open(fast, true);
  grabber->start();
  grabber->start(); // is already running
  waitForFrames(3 * recorded);
  EXPECT_TRUE(grabber->isRunning());
  grabber->stop();
  EXPECT_FALSE(grabber->isRunning());
  const FrameNumbers given = numbers();
  for (std::size_t i = 0; i < given.size(); ++i)
    EXPECT_EQ(given[i], i % recorded);
}

TEST_F(SessionStream, NoCallbackAfterStopInAHundredCycles)
{
  std::atomic<bool> may_call{false};
  std::atomic<int> wrong{0};
  const auto grabber = open(fast, true, [&] { wrong += may_call ? 0 : 1; });
  std::size_t before = 0;
  for (int cycle = 0; cycle < 100; ++cycle) {
    may_call = true;
    grabber->start();
    if (cycle % 2 == 0)
      waitForFrames(before + 1);
    grabber->stop();
    may_call = false;
    EXPECT_FALSE(grabber->isRunning());
    before = numbers().size();
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GE(before, 50U);
  const FrameNumbers given = numbers(); // it continued where it had stopped
  for (std::size_t i = 0; i < given.size(); ++i)
    EXPECT_EQ(given[i], i % recorded);
}

TEST_F(SessionStream, KeepsItsRateRoughly)
{
  const auto grabber = open(100);
  const auto begin = std::chrono::steady_clock::now();
  grabber->start();
  grabber->wait();
  const std::chrono::duration<double> seconds =
      std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(numbers().size(), recorded);
  EXPECT_GE(seconds.count(), 0.01 * (recorded - 1));
  EXPECT_LE(seconds.count(), 2.0);
}

TEST_F(SessionStream, StopsWithoutWaitingForTheNextFrame)
{
  const auto grabber = open(0.001F);
  grabber->start();
  waitForFrames(1);
  const auto begin = std::chrono::steady_clock::now();
  grabber->stop();
  EXPECT_LE(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
  EXPECT_EQ(numbers().size(), 1U);
}

TEST_F(SessionStream, TriggersGiveOneFrameEach)
{
  const auto grabber = open(0);
  grabber->start();
  grabber->wait();
  EXPECT_THAT(numbers(), ElementsAre(0));
  for (int i = 0; i < 3; ++i)
    grabber->trigger();
  grabber->wait();
  EXPECT_THAT(numbers(), ElementsAre(0, 1, 2, 3));
  for (int i = 0; i < 5; ++i)
    grabber->trigger();
  grabber->wait();
  EXPECT_EQ(numbers().size(), recorded);
  EXPECT_FALSE(grabber->isRunning());
}

TEST_F(SessionStream, CallbacksMayStopAndStart)
{
  TrinocularFileGrabber* self = nullptr;
  bool again = false;
  const auto grabber = open(fast, true, [&] {
    self->stop();
    self->wait();
    if (again)
      self->start();
    again = !again;
  });
  self = grabber.get();
  grabber->start();
  grabber->wait();
  EXPECT_THAT(numbers(), ElementsAre(0));
  EXPECT_FALSE(grabber->isRunning());
  grabber->start(); // the next callback starts again, the following one does not
  grabber->wait();
  EXPECT_THAT(numbers(), ElementsAre(0, 1, 2));
}

TEST_F(SessionStream, StopWinsOverCallbacksThatStart)
{
  TrinocularFileGrabber* self = nullptr;
  const auto grabber = open(fast, true, [&] {
    self->stop();
    self->start();
  });
  self = grabber.get();
  for (int cycle = 0; cycle < 20; ++cycle) {
    const std::size_t before = numbers().size();
    grabber->start();
    waitForFrames(before + 2);
    grabber->stop();
    EXPECT_FALSE(grabber->isRunning());
  }
}

TEST_F(SessionStream, SeveralThreadsMayStopAndStart)
{
  const auto grabber = open(fast, true);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] {
      for (int cycle = 0; cycle < 25; ++cycle) {
        grabber->start();
        grabber->rewind();
        grabber->trigger();
        grabber->stop();
      }
    });
  for (std::thread& thread : threads)
    thread.join();
  grabber->stop();
  EXPECT_FALSE(grabber->isRunning());
  EXPECT_EQ(errorOf(*grabber), "");
}

TEST_F(SessionStream, MayGoAwayWhileItRuns)
{
  for (int i = 0; i < 20; ++i) {
    const auto grabber = open(fast, true);
    grabber->start();
    waitForFrames(numbers().size() + 1);
  }
}

TEST_F(SessionStream, KeepsWhatACallbackThrows)
{
  const auto grabber =
      open(fast, false, [] { throw std::runtime_error("callback fault"); });
  grabber->start();
  grabber->wait();
  EXPECT_EQ(errorOf(*grabber), "callback fault");
  EXPECT_THAT(numbers(), ElementsAre(0));
  grabber->start();
  grabber->wait();
  EXPECT_THAT(numbers(), ElementsAre(0, 1));
}

TEST_F(SessionStream, ABrokenFrameEndsItWithItsName)
{
  damage(frameFile(3), -20);
  const auto grabber = open(fast);
  for (int round = 0; round < 2; ++round) {
    grabber->start();
    grabber->wait();
    EXPECT_THAT(errorOf(*grabber),
                HasSubstr("frame_000003.acf: frame 3: its checksum is wrong"));
    EXPECT_THAT(numbers(), ElementsAre(0, 1, 2));
  }
  EXPECT_THAT(grabber->getReport().broken, ElementsAre(3));
  EXPECT_THROW(grabber->frame(3), InputFileException);
  expectEqual(*grabber->frame(4), recordedFrame(rigOf(16, 12), 4));
  EXPECT_FALSE(grabber->getSkipBroken());
  grabber->setSkipBroken(true);
  EXPECT_TRUE(grabber->getSkipBroken());
  grabber->start();
  grabber->wait();
  EXPECT_EQ(errorOf(*grabber), "");
  EXPECT_THAT(numbers(), ElementsAre(0, 1, 2, 4, 5));
  EXPECT_THAT(grabber->getReport().broken, ElementsAre(3)) << "each once";
}

TEST_F(SessionStream, RepeatingEndsWhereNothingCanBeRead)
{
  for (int i = 0; i < int(recorded); ++i)
    damage(frameFile(i), -20);
  const auto grabber = open(fast, true);
  grabber->setSkipBroken(true);
  grabber->start();
  grabber->wait();
  EXPECT_THAT(errorOf(*grabber), HasSubstr("checksum"));
  EXPECT_THAT(grabber->getReport().broken, ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST_F(SessionStream, RefusesRatesAndIndicesThatAreNone)
{
  for (const float rate : {-1.0F, NAN, INFINITY, 1e-9F, 2000.0F})
    EXPECT_THROW(TrinocularFileGrabber(session_, rate), BadArgumentException) << rate;
  const TrinocularFileGrabber grabber(session_);
  EXPECT_THROW(grabber.frame(recorded), BadArgumentException);
}

} // namespace
} // namespace pcl::acmap::test
