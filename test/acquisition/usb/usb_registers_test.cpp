#include "usb_camera_fixture.h"

#include <gmock/gmock.h>

#include <thread>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;

constexpr std::uint64_t rate = iidc::commands + iidc::current_rate;

class UsbRegisterAccess : public UsbCameraFixture {
protected:
  std::unique_ptr<IidcBus> bus_ = openUsbBus();
};

TEST_F(UsbRegisterAccess, AreReadAndWritten)
{
  EXPECT_EQ(0x31333934u, bus_->readQuadlet(iidc::config_rom + 4)) << "not upside down";
  for (const std::uint32_t value : {1u << 29, 4u << 29}) {
    bus_->writeQuadlet(rate, value);
    EXPECT_EQ(value, bus_->readQuadlet(rate));
  }
}

TEST_F(UsbRegisterAccess, AreNotEverywhere)
{
  std::string message;
  for (const std::uint64_t address :
       {iidc::commands + 1, std::uint64_t{0}, std::uint64_t{1} << 48})
    EXPECT_EQ(CameraFault::Unsupported,
              faultOf([&] { bus_->readQuadlet(address); }, &message))
        << std::hex << address;
  camera_.faults().failControl(ControlFault::Stall, 1);
  EXPECT_EQ(CameraFault::Unsupported,
            faultOf([&] { bus_->readQuadlet(rate); }, &message));
  EXPECT_THAT(message, HasSubstr("usb " + place()));
  EXPECT_THAT(message, HasSubstr("reading register fffff0f00600"));
  EXPECT_EQ(3u << 29, bus_->readQuadlet(rate)) << "the next one is answered again";
}

TEST_F(UsbRegisterAccess, AreAskedAgainWhenTheyAreSilent)
{
  camera_.faults().failControl(ControlFault::TimeOut, 2);
  EXPECT_EQ(3u << 29, bus_->readQuadlet(rate));
}

TEST_F(UsbRegisterAccess, AreNotAskedForEver)
{
  camera_.faults().failControl(ControlFault::TimeOut, 1000);
  const auto time = timeOf([&] {
    EXPECT_EQ(CameraFault::Silent, faultOf([&] { bus_->writeQuadlet(rate, 0); }));
  });
  EXPECT_LT(time, 10s);
  camera_.faults().heal();
  EXPECT_EQ(3u << 29, bus_->readQuadlet(rate));
}

TEST_F(UsbRegisterAccess, AreAskedAgainAfterNoiseOnTheCable)
{
  camera_.faults().failControl(ControlFault::Error, 2);
  EXPECT_EQ(3u << 29, bus_->readQuadlet(rate));
  camera_.faults().failControl(ControlFault::Error, 1000);
  EXPECT_EQ(CameraFault::Failed, faultOf([&] { bus_->readQuadlet(rate); }));
}

TEST_F(UsbRegisterAccess, AreGoneWithTheCamera)
{
  cable_.unplug();
  const auto time = timeOf([&] {
    EXPECT_EQ(CameraFault::Unplugged, faultOf([&] { bus_->readQuadlet(rate); }));
    EXPECT_EQ(CameraFault::Unplugged, faultOf([&] { bus_->writeQuadlet(rate, 0); }));
    EXPECT_EQ(CameraFault::Unplugged, faultOf([&] { bus_->startStream(4096, 4); }));
  });
  EXPECT_LT(time, 1s);
}

TEST_F(UsbRegisterAccess, AreGoneWhileTheyAreAsked)
{
  camera_.faults().failControl(ControlFault::TimeOut, 1000);
  std::thread hand([&] {
    std::this_thread::sleep_for(100ms);
    cable_.unplug();
  });
  const auto time = timeOf([&] {
    EXPECT_EQ(CameraFault::Unplugged, faultOf([&] { bus_->readQuadlet(rate); }));
  });
  hand.join();
  EXPECT_LT(time, 1100ms);
}

TEST_F(UsbRegisterAccess, AnswerManyThreads)
{
  const auto ask = [&](std::uint64_t address, std::uint32_t answer) {
    for (int i = 0; i < 100; ++i)
      EXPECT_EQ(answer, bus_->readQuadlet(address));
  };
  std::thread other([&] { ask(iidc::config_rom + 16, 0x00C0FFEE); });
  ask(iidc::config_rom + 12, 0x00B09D01);
  other.join();
}

} // namespace
} // namespace pcl::acmap::test
