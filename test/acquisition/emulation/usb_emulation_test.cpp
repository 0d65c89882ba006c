#include "usb_client.h"
#include "usb_testbed.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace pcl::acmap::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::size_t frame_bytes = 640 * 480 * 3;

/** \brief An image that repeats the frame number. */
std::vector<std::uint8_t>
numbered(const Exposure& exposure)
{
  return std::vector<std::uint8_t>(exposure.setting.image_bytes,
                                   static_cast<std::uint8_t>(exposure.number));
}

class UsbEmulation : public testing::Test {
protected:
  void
  startStream(UsbClient& client)
  {
    ASSERT_EQ(client.open(), 0);
    ASSERT_EQ(client.write(iidc::current_rate, 4U << 29), 4); // 30 frames per second
    ASSERT_EQ(client.write(iidc::iso_enable, iidc::on), 4);
  }

  void
  expectFrame(UsbClient& client, std::uint8_t number)
  {
    std::vector<std::uint8_t> bytes;
    ASSERT_EQ(client.receive(bytes, frame_bytes, 1000), 0);
    EXPECT_TRUE(bytes == std::vector<std::uint8_t>(frame_bytes, number))
        << bytes.size();
  }

  EmulatedIidcCamera camera_{numbered};
  UsbTestbed testbed_;
};

TEST_F(UsbEmulation, SaysWhatItIs)
{
  UsbIdentity identity;
  identity.serial = "123456";
  const EmulatedUsbCamera cable(testbed_, camera_, identity);
  UsbClient client;
  ASSERT_EQ(client.count(), 1U);
  ASSERT_EQ(client.open(), 0);
  libusb_device* device = libusb_get_device(client.handle());
  libusb_device_descriptor about;
  ASSERT_EQ(libusb_get_device_descriptor(device, &about), 0);
  EXPECT_EQ(about.idVendor, 0x1E10);
  EXPECT_EQ(about.idProduct, 0x2000);
  EXPECT_EQ(libusb_get_device_address(device), cable.address());
  EXPECT_EQ(libusb_get_max_packet_size(device, 0x81), 512);
  unsigned char serial[32];
  ASSERT_EQ(libusb_get_string_descriptor_ascii(
                client.handle(), about.iSerialNumber, serial, sizeof serial),
            6);
  EXPECT_STREQ(reinterpret_cast<const char*>(serial), "123456");
}

TEST_F(UsbEmulation, ADeviceWithoutAStreamRefusesIt)
{
  UsbIdentity identity;
  identity.bulk_endpoint = false;
  const EmulatedUsbCamera cable(testbed_, camera_, identity);
  UsbClient client;
  ASSERT_EQ(client.open(), 0);
  std::vector<std::uint8_t> bytes;
  EXPECT_NE(client.receive(bytes, frame_bytes, 200), 0);
}

TEST_F(UsbEmulation, OneClientOwnsTheInterface)
{
  const EmulatedUsbCamera cable(testbed_, camera_);
  UsbClient first;
  ASSERT_EQ(first.open(), 0);
  UsbClient second;
  EXPECT_EQ(second.open(), LIBUSB_ERROR_BUSY);
  second.close();
  first.close();
  EXPECT_EQ(second.open(), 0);
}

TEST_F(UsbEmulation, PiecesOfATransferMakeAFrame)
{
  UsbIdentity identity;
  identity.splits_bulk = true;
  const EmulatedUsbCamera cable(testbed_, camera_, identity);
  camera_.faults().failFrame(FrameFault::Short, 1);
  UsbClient client;
  startStream(client);
  expectFrame(client, 0);
  std::vector<std::uint8_t> bytes;
  ASSERT_EQ(client.receive(bytes, frame_bytes, 1000), 0);
  EXPECT_TRUE(bytes == std::vector<std::uint8_t>(frame_bytes / 3 * 2, 1))
      << bytes.size();
  expectFrame(client, 2);
}

TEST_F(UsbEmulation, ShortFrame)
{
  const EmulatedUsbCamera cable(testbed_, camera_);
  camera_.faults().failFrame(FrameFault::Short, 0);
  UsbClient client;
  startStream(client);
  std::vector<std::uint8_t> bytes;
  ASSERT_EQ(client.receive(bytes, frame_bytes, 1000), 0);
  EXPECT_EQ(bytes.size(), frame_bytes / 3 * 2);
  expectFrame(client, 1);
}

TEST_F(UsbEmulation, TheRestOfAFrameDoesNotOutliveItsStream)
{
  const EmulatedUsbCamera cable(testbed_, camera_);
  UsbClient client;
  startStream(client);
  std::vector<std::uint8_t> bytes;
  ASSERT_EQ(client.receive(bytes, 512, 1000), 0);
  ASSERT_EQ(client.receive(bytes, 1024, 1000), 0);
  EXPECT_TRUE(bytes == std::vector<std::uint8_t>(1024, 0)); // part of the same frame
  ASSERT_EQ(client.write(iidc::iso_enable, 0), 4);
  ASSERT_EQ(client.write(iidc::iso_enable, iidc::on), 4);
  ASSERT_EQ(client.receive(bytes, frame_bytes, 1000), 0);
  EXPECT_EQ(bytes.size(), frame_bytes);
  EXPECT_GT(bytes.at(0), 0);
}

TEST_F(UsbEmulation, AStallLastsUntilItIsCleared)
{
  const EmulatedUsbCamera cable(testbed_, camera_);
  camera_.faults().failFrame(FrameFault::Stall, 0);
  UsbClient client;
  startStream(client);
  std::vector<std::uint8_t> bytes;
  EXPECT_EQ(client.receive(bytes, frame_bytes, 1000), LIBUSB_ERROR_PIPE);
  EXPECT_EQ(client.receive(bytes, frame_bytes, 1000), LIBUSB_ERROR_PIPE);
  ASSERT_EQ(libusb_clear_halt(client.handle(), 0x81), 0);
  expectFrame(client, 1);
}

TEST_F(UsbEmulation, NoiseOnTheCableCostsAFrame)
{
  const EmulatedUsbCamera cable(testbed_, camera_);
  camera_.faults().failFrame(FrameFault::Error, 0);
  camera_.faults().failControl(ControlFault::Error, 1);
  UsbClient client;
  ASSERT_EQ(client.open(), 0);
  std::uint32_t value = 0;
  EXPECT_EQ(client.read(iidc::power, value), LIBUSB_ERROR_IO);
  client.close();
  startStream(client);
  std::vector<std::uint8_t> bytes;
  EXPECT_EQ(client.receive(bytes, frame_bytes, 1000), LIBUSB_ERROR_IO);
  EXPECT_EQ(bytes.size(), frame_bytes / 2);
  expectFrame(client, 1);
}

TEST_F(UsbEmulation, AnEmptyPacketMayFollowAFrame)
{
  const EmulatedUsbCamera cable(testbed_, camera_);
  camera_.faults().failFrame(FrameFault::EmptyEnd, 0);
  UsbClient client;
  startStream(client);
  expectFrame(client, 0);
  std::vector<std::uint8_t> bytes;
  EXPECT_EQ(client.receive(bytes, frame_bytes, 1000), 0);
  EXPECT_TRUE(bytes.empty());
  expectFrame(client, 1);
}

TEST_F(UsbEmulation, MemoryForTransfersEnds)
{
  UsbIdentity identity;
  identity.memory = frame_bytes - 1;
  const EmulatedUsbCamera cable(testbed_, camera_, identity);
  UsbClient client;
  startStream(client);
  std::vector<std::uint8_t> bytes;
  EXPECT_EQ(client.receive(bytes, frame_bytes, 1000), LIBUSB_ERROR_NO_MEM);
}

TEST_F(UsbEmulation, SilenceEndsByTimeAndByHealing)
{
  const EmulatedUsbCamera cable(testbed_, camera_);
  camera_.faults().setSilent(true);
  UsbClient client;
  startStream(client);
  std::vector<std::uint8_t> bytes;
  EXPECT_EQ(client.receive(bytes, frame_bytes, 200), LIBUSB_ERROR_TIMEOUT);
  EXPECT_TRUE(bytes.empty());
  camera_.faults().heal();
  EXPECT_EQ(client.receive(bytes, frame_bytes, 1000), 0);
  EXPECT_EQ(bytes.size(), frame_bytes);
}

TEST_F(UsbEmulation, ControlTransfersFailOnDemand)
{
  const EmulatedUsbCamera cable(testbed_, camera_);
  UsbClient client;
  ASSERT_EQ(client.open(), 0);
  std::uint32_t value = 0;
  camera_.faults().failControl(ControlFault::Stall, 2);
  EXPECT_EQ(client.read(iidc::power, value), LIBUSB_ERROR_PIPE);
  EXPECT_EQ(client.write(iidc::power, 0), LIBUSB_ERROR_PIPE);
  EXPECT_EQ(client.read(iidc::power, value), 4);
  EXPECT_EQ(value, iidc::on);
  camera_.faults().failControl(ControlFault::TimeOut, 1);
  EXPECT_EQ(client.read(iidc::power, value), LIBUSB_ERROR_TIMEOUT);
  EXPECT_EQ(client.read(iidc::power, value), 4);
}

TEST_F(UsbEmulation, UnplugInAFrameFailsAllThatWaits)
{
  const EmulatedUsbCamera cable(testbed_, camera_);
  camera_.faults().failFrame(FrameFault::Unplug, 1);
  UsbClient client;
  startStream(client);
  expectFrame(client, 0);
  std::vector<std::uint8_t> bytes;
  EXPECT_EQ(client.receive(bytes, frame_bytes, 1000), LIBUSB_ERROR_NO_DEVICE);
  EXPECT_FALSE(cable.plugged());
  EXPECT_EQ(client.receive(bytes, frame_bytes, 1000), LIBUSB_ERROR_NO_DEVICE);
  std::uint32_t value = 0;
  EXPECT_EQ(client.read(iidc::power, value), LIBUSB_ERROR_NO_DEVICE);
  client.close();
  EXPECT_EQ(client.open(), LIBUSB_ERROR_NO_DEVICE);
}

TEST_F(UsbEmulation, UnplugEndsATransferThatWaits)
{
  EmulatedUsbCamera cable(testbed_, camera_);
  UsbClient client;
  ASSERT_EQ(client.open(), 0);
  std::thread hand([&] {
    std::this_thread::sleep_for(100ms);
    cable.unplug();
  });
  std::vector<std::uint8_t> bytes;
  const auto before = Clock::now();
  EXPECT_EQ(client.receive(bytes, frame_bytes, 10000), LIBUSB_ERROR_NO_DEVICE);
  EXPECT_LT(Clock::now() - before, 2s);
  hand.join();
}

int LIBUSB_CALL
countEvent(libusb_context*, libusb_device*, libusb_hotplug_event event, void* counts)
{
  ++static_cast<std::atomic<int>*>(counts)[event == LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT];
  return 0;
}

TEST_F(UsbEmulation, HotPlugIsHeard)
{
  EmulatedUsbCamera cable(testbed_, camera_);
  UsbClient client;
  ASSERT_EQ(client.count(), 1U);
  std::atomic<int> counts[2] = {0, 0};
  ASSERT_EQ(libusb_hotplug_register_callback(client.context(),
                                             LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED |
                                                 LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT,
                                             0,
                                             0x1E10,
                                             LIBUSB_HOTPLUG_MATCH_ANY,
                                             LIBUSB_HOTPLUG_MATCH_ANY,
                                             countEvent,
                                             counts,
                                             nullptr),
            0);
  const auto await = [&](int arrived, int left) {
    const auto end = Clock::now() + 5s;
    while ((counts[0] < arrived || counts[1] < left) && Clock::now() < end) {
      timeval patience{0, 100000};
      libusb_handle_events_timeout(client.context(), &patience);
    }
    EXPECT_EQ(counts[0], arrived);
    EXPECT_EQ(counts[1], left);
  };
  const int address = cable.address();
  cable.unplug();
  await(0, 1);
  EXPECT_EQ(client.count(), 0U);
  cable.plug();
  await(1, 1);
  EXPECT_EQ(client.count(), 1U);
  EXPECT_NE(cable.address(), address);
  startStream(client);
  expectFrame(client, 0);
}

TEST_F(UsbEmulation, PermissionCanBeTakenAndGiven)
{
  EmulatedUsbCamera cable(testbed_, camera_);
  cable.setPermission(false);
  UsbClient client;
  ASSERT_EQ(client.count(), 1U);
  EXPECT_EQ(client.open(), LIBUSB_ERROR_ACCESS);
  cable.setPermission(true);
  EXPECT_EQ(client.open(), 0);
}

TEST_F(UsbEmulation, TwoCamerasSendEachTheirOwn)
{
  EmulatedIidcCamera other([](const Exposure& exposure) {
    return std::vector<std::uint8_t>(exposure.setting.image_bytes, 200);
  });
  const EmulatedUsbCamera cable(testbed_, camera_);
  const EmulatedUsbCamera second_cable(testbed_, other);
  UsbClient clients[2];
  ASSERT_EQ(clients[0].count(), 2U);
  std::vector<std::uint8_t> seen;
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_EQ(clients[i].open(i), 0);
    ASSERT_EQ(clients[i].write(iidc::iso_enable, iidc::on), 4);
  }
  for (UsbClient& client : clients) {
    std::vector<std::uint8_t> bytes;
    ASSERT_EQ(client.receive(bytes, frame_bytes, 1000), 0);
    ASSERT_EQ(bytes.size(), frame_bytes);
    seen.push_back(bytes.front());
  }
  EXPECT_NE(seen[0] == 200, seen[1] == 200);
}

} // namespace
} // namespace pcl::acmap::test
