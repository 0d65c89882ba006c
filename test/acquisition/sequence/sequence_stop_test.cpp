#include "sequence_rig.h"

#include <atomic>

namespace pcl::acmap::test {
namespace {

/** Much shorter than the delays that a stop interrupts, much longer than a stop. */
constexpr std::chrono::seconds soon{2};
constexpr Milliseconds for_ever{60'000};

using SequenceStop = SequenceRig;

TEST_F(SequenceStop, EndsSettlingAtOnce)
{
  const auto grabber = open(1);
  grabber->setSettleTime(10);
  grabber->start();
  while (lamp_->shown().empty())
    std::this_thread::yield();
  const auto begin = Clock::now();
  grabber->stop();
  EXPECT_LE(Clock::now() - begin, soon);
  EXPECT_FALSE(grabber->isRunning());
  EXPECT_EQ(camera_->triggers(), 0);
  EXPECT_EQ(shots(), "");
  EXPECT_EQ(errorOf(*grabber), "");
  expectAtRest();
  grabber->setSettleTime(0);
  grabber->observe();
  grabber->wait();
  EXPECT_EQ(shots(), "0.off 0.0") << "nothing was given, so nothing was cut off";
}

TEST_F(SequenceStop, EndsTheWaitForAShotAtOnce)
{
  const auto grabber = open(1, [&](const auto&) { camera_->exposure = for_ever; });
  grabber->setShotTimeout(600);
  grabber->start();
  while (camera_->triggers() < 2)
    std::this_thread::yield();
  const auto begin = Clock::now();
  grabber->stop();
  EXPECT_LE(Clock::now() - begin, soon);
  EXPECT_FALSE(grabber->isRunning());
  EXPECT_EQ(shots(), "0.off");
  EXPECT_EQ(errorOf(*grabber), "");
  expectAtRest();
}

TEST_F(SequenceStop, EndsTheWaitForACameraThatStreams)
{
  camera_->start();
  const auto grabber = open(1);
  grabber->setShotTimeout(600);
  grabber->start();
  while (lamp_->shown().empty())
    std::this_thread::yield();
  const auto begin = Clock::now();
  grabber->stop();
  EXPECT_LE(Clock::now() - begin, soon);
  EXPECT_EQ(errorOf(*grabber), "");
  EXPECT_EQ(shots(), "");
  expectAtRest();
}

TEST_F(SequenceStop, NoCallbackAfterItInAHundredCycles)
{
  std::atomic<bool> may_call{false};
  std::atomic<int> wrong{0};
  const auto grabber = open(2, [&](const auto&) { wrong += may_call ? 0 : 1; });
  grabber->setWantMore([&](const auto&) {
    wrong += may_call ? 0 : 1;
    return true;
  });
  camera_->exposure = Milliseconds(0.3);
  std::size_t before = 0;
  for (int cycle = 0; cycle < 100; ++cycle) {
    may_call = true;
    grabber->start();
    if (cycle % 2 == 0)
      waitForFrames(before + 1 + static_cast<std::size_t>(cycle % 5));
    grabber->stop();
    may_call = false;
    EXPECT_FALSE(grabber->isRunning());
    expectAtRest();
    before = frames().size();
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(errorOf(*grabber), "");
  const Frames given = frames();
  for (std::size_t i = 0; i < given.size(); ++i) {
    const TrinocularFrame& frame = *given[i];
    EXPECT_EQ(frame.number, i);
    EXPECT_TRUE(showsOnly(frame, levelOf(frame.pattern))) << i;
    if (i == 0)
      continue;
    const bool is_new = frame.observation != given[i - 1]->observation;
    EXPECT_EQ(frame.pattern, is_new ? -1 : given[i - 1]->pattern + 1) << i;
  }
}

TEST_F(SequenceStop, CallbacksMayDoAllThatCanBeDone)
{
  PatternSequenceGrabber* self = nullptr;
  int stage = 0;
  const auto grabber = open(1, [&](const auto&) {
    self->wait(); // returns at once
    switch (stage++) {
    case 0: // of trigger: the rest, and one more
      self->observe();
      self->observe();
      break;
    case 4: // the first shot of start: restarts with the next one
      self->stop();
      self->start();
      break;
    case 5:
      self->stop();
      self->stop();
      self->trigger();
      break;
    case 6:
      self->rewind();
      break;
    }
  });
  self = grabber.get();
  grabber->trigger();
  grabber->wait();
  EXPECT_EQ(shots(), "0.off 0.0 1.off 1.0");
  grabber->start();
  grabber->wait();
  EXPECT_EQ(shots(), "0.off 0.0 1.off 1.0 2.off 3.off 4.off");
  EXPECT_EQ(errorOf(*grabber), "");
  expectAtRest();
  grabber->observe();
  grabber->wait();
  EXPECT_EQ(shots(), "0.off 0.0 1.off 1.0 2.off 3.off 4.off 0.off 0.0");
}

TEST_F(SequenceStop, WantMoreMayDoSoToo)
{
  PatternSequenceGrabber* self = nullptr;
  const auto grabber = open(3);
  self = grabber.get();
  grabber->setWantMore([&](const TrinocularFrame& frame) {
    if (frame.observation == 0) {
      self->stop();
      self->start();
      return false;
    }
    self->stop();
    return true;
  });
  grabber->start();
  grabber->wait();
  EXPECT_EQ(shots(), "0.off 0.0 1.off 1.0");
  EXPECT_EQ(grabber->getReport().observations, 0U) << "both were cut off";
  EXPECT_EQ(grabber->getReport().remarks.size(), 2U);
}

TEST_F(SequenceStop, WinsOverCallbacksThatStart)
{
  PatternSequenceGrabber* self = nullptr;
  const auto grabber = open(1, [&](const auto&) {
    self->stop();
    self->start();
    self->observe();
  });
  self = grabber.get();
  for (int cycle = 0; cycle < 20; ++cycle) {
    const std::size_t before = frames().size();
    grabber->start();
    waitForFrames(before + 2);
    grabber->stop();
    EXPECT_FALSE(grabber->isRunning());
  }
}

TEST_F(SequenceStop, WhatACallbackAsksForWhileOthersStopIsRefused)
{
  PatternSequenceGrabber* self = nullptr;
  std::atomic<int> calls{0};
  const auto grabber = open(1, [&](const auto&) {
    if (++calls > 1)
      return;
    std::this_thread::sleep_for(Milliseconds(30));
    self->start();
    self->observe();
  });
  self = grabber.get();
  grabber->start();
  while (calls == 0)
    std::this_thread::yield();
  grabber->stop();
  EXPECT_FALSE(grabber->isRunning());
  EXPECT_EQ(frames().size(), 1U);
  grabber->trigger();
  grabber->wait();
  EXPECT_EQ(frames().size(), 2U) << "neither blocked by what was refused, nor more";
}

TEST_F(SequenceStop, AFaultAndARequestMayComeAtOnce)
{
  std::atomic<bool> throws{false};
  const auto grabber = open(0, [&](const auto&) {
    if (throws)
      throw std::runtime_error("callback fault");
  });
  camera_->exposure = camera_->delay = camera_->row_time = Milliseconds(0);
  for (int round = 0; round < 100; ++round) {
    throws = true;
    const std::size_t before = frames().size();
    grabber->trigger();
    while (frames().size() == before)
      std::this_thread::yield();
    grabber->trigger(); // discarded with the other shot, or fails itself
    grabber->wait();
    throws = false;
    const std::size_t between = frames().size();
    EXPECT_LE(between, before + 2);
    grabber->trigger();
    grabber->wait();
    EXPECT_EQ(frames().size(), between + 1) << "nothing is left of what was dropped";
  }
}

TEST_F(SequenceStop, SeveralThreadsMayCallAll)
{
  const auto grabber = open(2);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] {
      for (int cycle = 0; cycle < 25; ++cycle) {
        grabber->start();
        grabber->rewind();
        grabber->observe();
        grabber->setSettleTime(cycle * 1e-5);
        grabber->trigger();
        grabber->getReport();
        grabber->stop();
        grabber->observe();
      }
    });
  for (std::thread& thread : threads)
    thread.join();
  grabber->stop();
  EXPECT_FALSE(grabber->isRunning());
  EXPECT_EQ(errorOf(*grabber), "");
  expectAtRest();
  const std::size_t before = frames().size();
  grabber->trigger(); // nothing remains of earlier requests
  grabber->wait();
  EXPECT_EQ(frames().size(), before + 1);
}

TEST_F(SequenceStop, NoRequestIsLostAtTheEndOfAStream)
{
  const auto grabber = open(0);
  camera_->exposure = camera_->delay = camera_->row_time = Milliseconds(0);
  for (std::size_t shots = 1; shots <= 200; ++shots) {
    grabber->trigger(); // often while the previous one is ending
    waitForFrames(shots);
  }
  grabber->wait();
  EXPECT_EQ(frames().size(), 200U);
}

TEST_F(SequenceStop, MayGoAwayWhileItRuns)
{
  for (int i = 0; i < 20; ++i) {
    const auto grabber = open(1);
    grabber->start();
    waitForFrames(frames().size() + 1);
  }
  expectAtRest();
  const std::size_t before = frames().size();
  camera_->trigger(); // nobody is registered any more
  camera_->wait();
  EXPECT_EQ(frames().size(), before);
}

} // namespace
} // namespace pcl::acmap::test
