#include "usb_camera_fixture.h"

#include <atomic>
#include <thread>

namespace pcl::acmap::test {
namespace {

using namespace std::chrono_literals;

class UsbStreaming : public UsbCameraFixture {
protected:
  /** \brief Receives frames, which must be complete, equal to the source, and
   * consecutive. */
  static void
  expectFrames(IidcBus& bus, int count, std::uint64_t first)
  {
    IidcFrame frame;
    std::uint64_t last_stamp = 0;
    for (int i = 0; i < count; ++i) {
      ASSERT_EQ(IidcWait::Frame, bus.nextFrame(frame, patience)) << i;
      EXPECT_TRUE(frame.is_whole) << i;
      EXPECT_TRUE(frame.bytes == bytesOf(first + i, frame_bytes)) << i;
      EXPECT_GT(frame.stamp, last_stamp) << i;
      last_stamp = frame.stamp;
    }
  }

  void
  startRunning(std::size_t frames = 4)
  {
    bus_->startStream(frame_bytes, frames);
    run(*bus_);
  }

  CameraFault
  faultOfWaiting()
  {
    return faultOf([&] {
      for (int i = 0; i < 200; ++i)
        bus_->nextFrame(frame_, 100ms);
    });
  }

  std::unique_ptr<IidcBus> bus_ = openUsbBus();
  IidcFrame frame_;
};

TEST_F(UsbStreaming, BringsFramesWholeAndInOrder)
{
  const auto before = std::chrono::system_clock::now().time_since_epoch();
  startRunning();
  expectFrames(*bus_, 12, 0);
  ASSERT_EQ(IidcWait::Frame, bus_->nextFrame(frame_, patience));
  const auto after = std::chrono::system_clock::now().time_since_epoch();
  EXPECT_GT(frame_.stamp, before / 1us);
  EXPECT_LE(frame_.stamp, after / 1us);
}

TEST_F(UsbStreaming, KeepsFramesThatWait)
{
  startRunning(4);
  std::this_thread::sleep_for(400ms); // the camera has exposed about twelve frames
  expectFrames(*bus_, 4, 0);
}

TEST_F(UsbStreaming, IsNotThereUnlessStarted)
{
  EXPECT_EQ(CameraFault::Failed, faultOf([&] { bus_->nextFrame(frame_, 1ms); }));
  bus_->stopStream();
  startRunning();
  EXPECT_EQ(CameraFault::Failed, faultOf([&] { bus_->startStream(frame_bytes, 4); }));
  expectFrames(*bus_, 2, 0);
  bus_->stopStream();
  EXPECT_EQ(CameraFault::Failed, faultOf([&] { bus_->nextFrame(frame_, 1ms); }));
}

TEST_F(UsbStreaming, RefusesFramesThatCannotBe)
{
  for (const std::size_t bytes :
       {std::size_t{0}, std::size_t{1} << 31, ~std::size_t{0}})
    EXPECT_EQ(CameraFault::Failed, faultOf([&] { bus_->startStream(bytes, 4); }));
  startRunning(0); // is raised to two, as fewer would lose frames
  expectFrames(*bus_, 3, 0);
}

TEST_F(UsbStreaming, TellsOfShortFramesAndGoesOn)
{
  camera_.faults().failFrame(FrameFault::Short, 1);
  startRunning();
  expectFrames(*bus_, 1, 0);
  ASSERT_EQ(IidcWait::Frame, bus_->nextFrame(frame_, patience));
  EXPECT_FALSE(frame_.is_whole);
  EXPECT_EQ(frame_bytes / 3 * 2, frame_.bytes.size());
  expectFrames(*bus_, 3, 2);
}

TEST_F(UsbStreaming, TellsOfFramesLongerThanAskedFor)
{
  bus_->startStream(frame_bytes - 100, 4); // by less than a packet too short
  run(*bus_);
  ASSERT_EQ(IidcWait::Frame, bus_->nextFrame(frame_, patience));
  EXPECT_FALSE(frame_.is_whole);
  EXPECT_EQ(frame_bytes, frame_.bytes.size());
}

TEST_F(UsbStreaming, TimesOutInSilence)
{
  camera_.faults().setSilent(true);
  startRunning();
  EXPECT_EQ(IidcWait::TimedOut, bus_->nextFrame(frame_, 0ms));
  EXPECT_EQ(IidcWait::TimedOut, bus_->nextFrame(frame_, -1s));
  const auto time =
      timeOf([&] { EXPECT_EQ(IidcWait::TimedOut, bus_->nextFrame(frame_, 200ms)); });
  EXPECT_GE(time, 199ms);
  EXPECT_LT(time, patience);
  camera_.faults().heal();
  EXPECT_EQ(IidcWait::Frame, bus_->nextFrame(frame_, patience));
  EXPECT_TRUE(frame_.is_whole);
}

TEST_F(UsbStreaming, IsCancelledFromAnotherThread)
{
  bus_->startStream(frame_bytes, 4);
  std::chrono::steady_clock::time_point cancelled;
  std::thread other([&] {
    std::this_thread::sleep_for(200ms);
    cancelled = std::chrono::steady_clock::now();
    bus_->cancel();
  });
  EXPECT_EQ(IidcWait::Cancelled,
            bus_->nextFrame(frame_, std::chrono::milliseconds::max()));
  const auto ended = std::chrono::steady_clock::now();
  other.join();
  EXPECT_LT(ended - cancelled, 100ms);
  EXPECT_EQ(IidcWait::TimedOut, bus_->nextFrame(frame_, 1ms)) << "once is once";
}

TEST_F(UsbStreaming, IsCancelledBeforeItWaits)
{
  bus_->startStream(frame_bytes, 4);
  bus_->cancel();
  EXPECT_EQ(IidcWait::Cancelled, bus_->nextFrame(frame_, patience));
  bus_->cancel();
  bus_->stopStream();
  startRunning(); // the cancellation does not affect a new stream
  expectFrames(*bus_, 2, 0);
}

TEST_F(UsbStreaming, GoesOnAfterAStall)
{
  camera_.faults().failFrame(FrameFault::Stall, 2);
  startRunning();
  expectFrames(*bus_, 2, 0);
  ASSERT_EQ(IidcWait::Frame, bus_->nextFrame(frame_, patience));
  EXPECT_TRUE(frame_.is_whole);
  EXPECT_TRUE(frame_.bytes == bytesOf(3, frame_bytes));
  expectFrames(*bus_, 3, 4);
}

TEST_F(UsbStreaming, FailsWhenItStallsForEver)
{
  camera_.faults().failFramesFrom(FrameFault::Stall, 1);
  startRunning();
  expectFrames(*bus_, 1, 0);
  EXPECT_EQ(CameraFault::Failed, faultOfWaiting());
  camera_.faults().heal();
  bus_->stopStream();
  halt(*bus_);
  startRunning();
  EXPECT_EQ(IidcWait::Frame, bus_->nextFrame(frame_, patience));
}

TEST_F(UsbStreaming, GoesOnAfterNoiseOnTheCable)
{
  camera_.faults().failFrame(FrameFault::Error, 1);
  startRunning();
  expectFrames(*bus_, 1, 0);
  ASSERT_EQ(IidcWait::Frame, bus_->nextFrame(frame_, patience));
  EXPECT_TRUE(frame_.is_whole);
}

TEST_F(UsbStreaming, FailsWhenThereIsNothingButNoise)
{
  camera_.faults().failFramesFrom(FrameFault::Error, 1);
  startRunning();
  expectFrames(*bus_, 1, 0);
  EXPECT_LT(timeOf([&] { EXPECT_EQ(CameraFault::Failed, faultOfWaiting()); }),
            patience);
}

TEST_F(UsbStreaming, TakesNoEmptyPacketForAFrame)
{
  camera_.faults().failFramesFrom(FrameFault::EmptyEnd, 0);
  startRunning();
  expectFrames(*bus_, 6, 0);
}

TEST_F(UsbStreaming, TakesLessWhereMemoryIsShort)
{
  bus_.reset();
  cable_.unplug();
  UsbIdentity identity;
  identity.memory = 3 * frame_bytes;
  const EmulatedUsbCamera cable(testbed_, camera_, identity);
  bus_ = openUsbBus();
  startRunning(8);
  expectFrames(*bus_, 6, 0);

  std::string message;
  const auto longer = [&] {
    bus_->stopStream();
    halt(*bus_); // otherwise a waiting frame would finish at once and release its
                 // memory
    bus_->startStream(2 * frame_bytes, 8);
  };
  EXPECT_EQ(CameraFault::Failed, faultOf(longer, &message));
  EXPECT_NE(std::string::npos, message.find("usbfs_memory_mb")) << message;
  bus_.reset(); // before the cable is destroyed
}

TEST_F(UsbStreaming, EndsWhenTheCableGoesWithinAFrame)
{
  camera_.faults().failFrame(FrameFault::Unplug, 3);
  startRunning();
  expectFrames(*bus_, 3, 0);
  const auto time =
      timeOf([&] { EXPECT_EQ(CameraFault::Unplugged, faultOfWaiting()); });
  EXPECT_LT(time, 1s);
  for (int i = 0; i < 10; ++i)
    EXPECT_EQ(CameraFault::Unplugged, faultOf([&] { bus_->nextFrame(frame_, 1ms); }));
  EXPECT_EQ(CameraFault::Unplugged, faultOf([&] { power(*bus_); }));
  EXPECT_LT(timeOf([&] { bus_->stopStream(); }), patience);
  EXPECT_LT(timeOf([&] { bus_.reset(); }), patience);
}

TEST_F(UsbStreaming, GivesTheFramesThatCameBeforeTheCableWent)
{
  camera_.faults().failFrame(FrameFault::Unplug, 3);
  startRunning(4);
  while (cable_.plugged())
    std::this_thread::sleep_for(1ms);
  expectFrames(*bus_, 3, 0);
  EXPECT_EQ(CameraFault::Unplugged, faultOfWaiting());
}

TEST_F(UsbStreaming, EndsWhenTheCableGoesAfterSomeNoise)
{
  camera_.faults().failFramesFrom(FrameFault::Error, 1);
  startRunning();
  expectFrames(*bus_, 1, 0);
  EXPECT_EQ(IidcWait::TimedOut, bus_->nextFrame(frame_, 60ms));
  cable_.unplug(); // while the stream waits for its restart
  EXPECT_LT(timeOf([&] { EXPECT_EQ(CameraFault::Unplugged, faultOfWaiting()); }), 1s);
  EXPECT_EQ(CameraFault::Unplugged, faultOfWaiting());
}

TEST_F(UsbStreaming, EndsWhenTheCableGoesInSilence)
{
  bus_->startStream(frame_bytes, 4);
  std::thread hand([&] {
    std::this_thread::sleep_for(100ms);
    cable_.unplug();
  });
  EXPECT_LT(timeOf([&] { EXPECT_EQ(CameraFault::Unplugged, faultOfWaiting()); }),
            1100ms);
  hand.join();
  EXPECT_LT(timeOf([&] { bus_.reset(); }), patience); // while it is streaming
}

TEST_F(UsbStreaming, ComesAgainWithTheCable)
{
  for (int i = 0; i < 3; ++i) {
    startRunning();
    expectFrames(*bus_, 2, 0);
    cable_.unplug();
    EXPECT_EQ(CameraFault::Unplugged, faultOfWaiting());
    bus_.reset();
    EXPECT_EQ(CameraFault::NotFound, faultOf([] { openUsbBus(); }));
    cable_.plug();
    bus_ = openUsbBus("00b09d0100c0ffee");
  }
}

TEST_F(UsbStreaming, StartsAndStopsAHundredTimes)
{
  for (int i = 0; i < 100; ++i) {
    startRunning();
    const int frames = i % 10 == 0 ? 1 : 0; // most are stopped before the first frame
    for (int k = 0; k < frames; ++k)
      ASSERT_EQ(IidcWait::Frame, bus_->nextFrame(frame_, patience)) << i;
    if (i % 2 == 0)
      halt(*bus_);
    bus_->stopStream();
  }
  halt(*bus_);
  startRunning();
  ASSERT_EQ(IidcWait::Frame, bus_->nextFrame(frame_, patience));
  EXPECT_TRUE(frame_.is_whole);
}

TEST_F(UsbStreaming, GoesOnWhileRegistersAreUsed)
{
  startRunning();
  std::atomic<bool> is_over{false};
  std::thread other([&] {
    while (!is_over)
      EXPECT_EQ(5u << 29, bus_->readQuadlet(iidc::commands + iidc::current_mode));
  });
  expectFrames(*bus_, 12, 0);
  is_over = true;
  other.join();
}

TEST_F(UsbStreaming, TakesAFrameThatEndsWithinAPacket)
{
  // 328 x 200 bytes in camera packets of 1000 bytes and USB packets of 512 bytes
  const std::uint64_t mode = iidc::commands + iidc::format7_base;
  const auto settle = [&] {
    bus_->writeQuadlet(mode + 0x7C, 0x40000000);
    while (bus_->readQuadlet(mode + 0x7C) & 0x40000000)
      ;
  };
  bus_->writeQuadlet(mode + 0x0C, 328u << 16 | 200u);
  bus_->writeQuadlet(mode + 0x10, iidc::Mono8 << 24);
  settle();
  bus_->writeQuadlet(mode + 0x44, 1000u << 16);
  settle();
  bus_->writeQuadlet(iidc::commands + iidc::current_format, 7u << 29);
  bus_->writeQuadlet(iidc::commands + iidc::current_mode, 0);
  const std::size_t bytes = 66 * 1000;
  bus_->startStream(bytes, 4);
  bus_->writeQuadlet(iidc::commands + iidc::iso_enable, iidc::on);
  for (std::uint64_t number = 0; number < 3; ++number) {
    ASSERT_EQ(IidcWait::Frame, bus_->nextFrame(frame_, patience));
    EXPECT_TRUE(frame_.is_whole);
    auto image = bytesOf(number, 328 * 200);
    image.resize(bytes);
    EXPECT_TRUE(frame_.bytes == image);
  }
}

TEST_F(UsbStreaming, IsTheSameOnAnySystem)
{
  bus_.reset();
  cable_.unplug();
  UsbIdentity fast;
  fast.super_speed = true;
  UsbIdentity old;
  old.splits_bulk = true;
  for (const UsbIdentity& identity : {fast, old}) {
    const EmulatedUsbCamera cable(testbed_, camera_, identity);
    bus_ = openUsbBus();
    camera_.faults().failFrame(FrameFault::Short, 2);
    startRunning();
    expectFrames(*bus_, 2, 0);
    ASSERT_EQ(IidcWait::Frame, bus_->nextFrame(frame_, patience));
    EXPECT_EQ(frame_bytes / 3 * 2, frame_.bytes.size());
    expectFrames(*bus_, 2, 3);
    bus_.reset();
  }
}

} // namespace
} // namespace pcl::acmap::test
