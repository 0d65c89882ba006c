#include "messages.h"

#include <pcl/core/stream_thread.h>

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

namespace pcl::acmap::test {
namespace {

constexpr StreamThread::Seconds at_once{0};

std::string
errorOf(const StreamThread& stream)
{
  return messageOf([&] {
    if (stream.error())
      std::rethrow_exception(stream.error());
  });
}

void
waitFor(const std::atomic<int>& count, int wanted)
{
  while (count < wanted)
    std::this_thread::yield();
}

TEST(StreamThreadEnd, ComesOnceAfterTheLastStepOfEachStream)
{
  std::string calls; // of the thread; read after it has ended
  StreamThread stream(
      [&] {
        calls += 's';
        return true;
      },
      at_once,
      [&] { calls += 'e'; });
  EXPECT_EQ(calls, "");
  stream.add(1);
  stream.wait();
  EXPECT_EQ(calls, "se");
  stream.stop(); // not running, so that the end function is not called
  stream.add(1);
  stream.wait();
  EXPECT_EQ(calls, "sese");
  EXPECT_EQ(errorOf(stream), "");
}

TEST(StreamThreadEnd, ComesWhereverTheStreamEnds)
{
  std::atomic<int> ends{0};
  std::string fault;
  bool is_stopped_within = false;
  StreamThread* self = nullptr;
  StreamThread stream(
      [&] {
        if (!fault.empty())
          throw std::runtime_error(fault);
        if (is_stopped_within)
          self->stop();
        return is_stopped_within;
      },
      at_once,
      [&] {
        EXPECT_TRUE(self->isRunning());
        EXPECT_TRUE(self->isWithin());
        EXPECT_EQ(errorOf(*self), fault);
        self->wait(); // does not wait for the end function itself
        ++ends;
      });
  self = &stream;
  EXPECT_FALSE(stream.isWithin());
  stream.add(StreamThread::endless); // the step returns that there are no more
  stream.wait();
  EXPECT_EQ(ends, 1);
  is_stopped_within = true;
  stream.add(StreamThread::endless);
  stream.wait();
  EXPECT_EQ(ends, 2);
  fault = "step fault";
  stream.add(StreamThread::endless);
  stream.wait();
  EXPECT_EQ(ends, 3);
  EXPECT_EQ(errorOf(stream), fault);
}

TEST(StreamThreadEnd, StopWaitsForIt)
{
  for (int round = 0; round < 20; ++round) {
    std::atomic<int> steps{0};
    std::atomic<int> ends{0};
    StreamThread stream([&] { return ++steps > 0; },
                        at_once,
                        [&] {
                          std::this_thread::sleep_for(std::chrono::milliseconds(2));
                          ++ends;
                        });
    stream.add(StreamThread::endless);
    if (round % 2 == 0)
      waitFor(steps, 1);
    stream.stop();
    EXPECT_EQ(ends, 1);
    EXPECT_FALSE(stream.isRunning());
    const int before = steps;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(steps, before);
  }
}

TEST(StreamThreadEnd, ItsFaultIsKeptWhereThereIsNone)
{
  bool fails = false;
  StreamThread stream(
      [&] {
        if (fails)
          throw std::runtime_error("step fault");
        return false;
      },
      at_once,
      [] { throw std::runtime_error("end fault"); });
  stream.add(1);
  stream.wait();
  EXPECT_EQ(errorOf(stream), "end fault");
  fails = true;
  stream.add(1);
  stream.wait();
  EXPECT_EQ(errorOf(stream), "step fault");
}

TEST(StreamThreadEnd, FramesAskedForMeanwhileAreAStreamOfTheirOwn)
{
  std::atomic<int> steps{0};
  std::atomic<int> ends{0};
  std::atomic<bool> goes_on{false};
  StreamThread stream(
      [&] {
        if (++steps == 1)
          throw std::runtime_error("step fault");
        return true;
      },
      at_once,
      [&] {
        ++ends;
        while (!goes_on)
          std::this_thread::yield();
      });
  stream.add(1);
  waitFor(ends, 1);
  stream.add(2); // must be neither lost nor blocked
  EXPECT_TRUE(stream.isRunning());
  goes_on = true;
  stream.wait();
  EXPECT_EQ(steps, 3);
  EXPECT_EQ(ends, 2);
  EXPECT_EQ(errorOf(stream), "") << "the second stream ended well";
}

TEST(StreamThreadEnd, MayAskForMoreUnlessSomebodyStops)
{
  std::atomic<int> steps{0};
  std::atomic<int> ends{0};
  StreamThread* self = nullptr;
  StreamThread stream([&] { return ++steps > 0; },
                      at_once,
                      [&] {
                        ++ends;
                        self->add(1);
                      });
  self = &stream;
  stream.add(1);
  waitFor(ends, 3);
  stream.stop();
  EXPECT_FALSE(stream.isRunning());
  EXPECT_GE(ends, 3);
  EXPECT_LE(steps, ends);
}

} // namespace
} // namespace pcl::acmap::test
