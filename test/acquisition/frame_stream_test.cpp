#include "frame_queue.h"
#include "session_frames.h"
#include "temporary_folder.h"

#include <pcl/acquisition/frame_stream.h>
#include <pcl/acquisition/guarded_projector.h>
#include <pcl/core/exceptions.h>

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

namespace pcl::acmap::test {
namespace {

using std::chrono::milliseconds;

TrinocularFrame::ConstPtr
numberedFrame(std::uint64_t number)
{
  const TrinocularFrame::Ptr frame(new TrinocularFrame);
  frame->number = number;
  return frame;
}

TEST(FrameQueue, GivesFramesInTheirOrder)
{
  FrameQueue queue(2);
  EXPECT_EQ(queue.pop(milliseconds(1)), nullptr);
  std::thread giver([&] {
    for (std::uint64_t i = 0; i < 50; ++i)
      queue.push(numberedFrame(i)); // blocks until there is room
  });
  for (std::uint64_t i = 0; i < 50; ++i) {
    const TrinocularFrame::ConstPtr frame = queue.pop(milliseconds(5000));
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->number, i);
  }
  giver.join();
}

TEST(FrameQueue, ClosedLetsNobodyWaitAndKeepsWhatIsThere)
{
  FrameQueue queue(1);
  queue.push(numberedFrame(0));
  std::thread giver([&] { queue.push(numberedFrame(1)); });
  std::this_thread::sleep_for(milliseconds(20));
  queue.close();
  giver.join();
  queue.push(numberedFrame(2));
  ASSERT_TRUE(queue.pop(milliseconds(1)));
  EXPECT_EQ(queue.pop(milliseconds(1)), nullptr);
}

TEST(FrameQueue, IsNeverTooShort)
{
  EXPECT_EQ(queueLength(std::size_t{1} << 30), 4u);
  EXPECT_GE(queueLength(std::size_t{640} * 480 * 3), 100u);
  EXPECT_GT(queueLength(0), 0u);
}

/** A session of six frames as a camera. */
class FrameStreams : public testing::Test {
protected:
  FrameStreams()
  {
    recordSession(folder_.path("session"), rigOf(16, 12), 6);
    camera_ = std::make_unique<TrinocularFileGrabber>(folder_.path("session"), 1000);
  }

  TemporaryFolder folder_;
  std::unique_ptr<TrinocularFileGrabber> camera_;
};

TEST_F(FrameStreams, PassAllFramesInOrderInTheThreadOfTheCaller)
{
  FrameStream stream(*camera_);
  camera_->start();
  std::vector<std::uint64_t> numbers;
  stream.pass([&, caller = std::this_thread::get_id()](const auto& frame) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    numbers.push_back(frame->number);
    return true;
  });
  EXPECT_EQ(numbers, (std::vector<std::uint64_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(stream.frames(), 6U);
  EXPECT_EQ(stream.next(milliseconds(1)), nullptr);
}

TEST_F(FrameStreams, EndWhereAFrameIsRefused)
{
  FrameStream stream(*camera_);
  camera_->start();
  stream.pass([&](const auto&) { return stream.frames() < 2; });
  EXPECT_EQ(stream.frames(), 2U);
  EXPECT_FALSE(camera_->isRunning());
}

TEST_F(FrameStreams, EndWhenTheyAreOver)
{
  FrameStream stream(*camera_);
  camera_->start();
  while (camera_->isRunning()) // all frames wait
    std::this_thread::sleep_for(milliseconds(1));
  std::size_t used = 0;
  stream.pass([&](const auto&) { return ++used > 0; }, [] { return true; });
  EXPECT_EQ(used, 6U) << "those that wait are passed";
}

TEST_F(FrameStreams, RethrowWhatTheCameraAndTheCallbacksThrow)
{
  damage(folder_.path("session/frame_000003.acf"), 40);
  FrameStream stream(*camera_);
  camera_->start();
  EXPECT_THROW(stream.pass([](const auto&) { return true; }), InputFileException);
  EXPECT_EQ(stream.frames(), 3U);
  camera_->rewind();
  FrameStream another(*camera_);
  camera_->start();
  EXPECT_THROW(another.pass([](const auto&) -> bool { throw std::logic_error("no"); }),
               std::logic_error);
}

TEST_F(FrameStreams, LeaveTheCameraToOthers)
{
  {
    FrameStream stream(*camera_);
    camera_->start();
  }
  EXPECT_FALSE(camera_->isRunning());
  camera_->rewind();
  camera_->start();
  camera_->wait();
  EXPECT_EQ(camera_->getError(), nullptr);
}

/** Counts what it is asked to show. */
struct CountedImages : PatternProjector {
  void
  show(const RgbImage&) override
  {
    ++shown;
  }

  void
  showNothing() override
  {
    ++shown;
  }

  std::atomic<int> shown = 0;
};

TEST(GuardedProjector, WaitsForWhoeverDraws)
{
  std::mutex drawing;
  const shared_ptr<CountedImages> images(new CountedImages);
  GuardedProjector projector(drawing, images);
  std::unique_lock lock(drawing);
  auto done = std::async(std::launch::async, [&] {
    projector.show({});
    projector.showNothing();
  });
  EXPECT_EQ(done.wait_for(milliseconds(50)), std::future_status::timeout);
  EXPECT_EQ(images->shown, 0);
  lock.unlock();
  done.get();
  EXPECT_EQ(images->shown, 2);
}

} // namespace
} // namespace pcl::acmap::test
