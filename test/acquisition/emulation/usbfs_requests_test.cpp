#include "iidc_addresses.h"
#include "usb_testbed.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <linux/usbdevice_fs.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

namespace pcl::acmap::test {
namespace {

using namespace std::chrono_literals;

/** \brief Requests of usbfs, without libusb. */
class UsbfsRequests : public testing::Test {
protected:
  static constexpr std::size_t frame_bytes = 640 * 480 * 3;

  void
  SetUp() override
  {
    openNode();
    ASSERT_EQ(claim(), 0);
    urb_->type = USBDEVFS_URB_TYPE_BULK;
    urb_->endpoint = 0x81;
    urb_->buffer = bytes_.data();
    urb_->buffer_length = static_cast<int>(bytes_.size());
  }

  void
  openNode()
  {
    const std::string number = std::to_string(cable_.address());
    const std::string node =
        "/dev/bus/usb/001/" + std::string(3 - number.size(), '0') + number;
    file_ = open(node.c_str(), O_RDWR | O_CLOEXEC);
    ASSERT_GE(file_, 0);
  }

  int
  claim()
  {
    unsigned interface = 0;
    return ioctl(file_, USBDEVFS_CLAIMINTERFACE, &interface);
  }

  void
  TearDown() override
  {
    if (file_ >= 0)
      close(file_);
  }

  bool
  isReady(std::chrono::milliseconds patience) const
  {
    pollfd wait{file_, POLLOUT, 0};
    return poll(&wait, 1, static_cast<int>(patience.count())) == 1;
  }

  /** \brief Returns a negative error number on failure. */
  int
  reap()
  {
    usbdevfs_urb* urb = nullptr;
    if (ioctl(file_, USBDEVFS_REAPURBNDELAY, &urb) < 0)
      return -errno;
    EXPECT_EQ(urb, urb_.get());
    return 0;
  }

  void
  startStream()
  {
    camera_.write(iidc::commands + iidc::current_rate, 4U << 29);
    camera_.write(iidc::commands + iidc::iso_enable, iidc::on);
  }

  EmulatedIidcCamera camera_{[](const Exposure& exposure) {
    return std::vector<std::uint8_t>(exposure.setting.image_bytes,
                                     static_cast<std::uint8_t>(exposure.number));
  }};
  UsbTestbed testbed_;
  EmulatedUsbCamera cable_{testbed_, camera_};
  std::vector<std::uint8_t> bytes_ = std::vector<std::uint8_t>(frame_bytes, 77);
  std::unique_ptr<usbdevfs_urb> urb_ = std::make_unique<usbdevfs_urb>();
  int file_ = -1;
};

TEST_F(UsbfsRequests, WhoPollsSleepsUntilThereIsSomething)
{
  ASSERT_EQ(ioctl(file_, USBDEVFS_SUBMITURB, urb_.get()), 0);
  EXPECT_FALSE(isReady(0ms));
  EXPECT_EQ(reap(), -EAGAIN);
  startStream();
  ASSERT_TRUE(isReady(5s));
  EXPECT_EQ(reap(), 0);
  EXPECT_EQ(urb_->status, 0);
  EXPECT_EQ(urb_->actual_length, static_cast<int>(frame_bytes));
  EXPECT_TRUE(bytes_ == std::vector<std::uint8_t>(frame_bytes, 0));
  EXPECT_EQ(reap(), -EAGAIN);
  EXPECT_FALSE(isReady(0ms));
}

TEST_F(UsbfsRequests, ADiscardedTransferComesBackAtOnce)
{
  EXPECT_EQ(ioctl(file_, USBDEVFS_DISCARDURB, urb_.get()), -1);
  EXPECT_EQ(errno, EINVAL);
  ASSERT_EQ(ioctl(file_, USBDEVFS_SUBMITURB, urb_.get()), 0);
  ASSERT_EQ(ioctl(file_, USBDEVFS_DISCARDURB, urb_.get()), 0);
  ASSERT_TRUE(isReady(5s));
  EXPECT_EQ(reap(), 0);
  EXPECT_EQ(urb_->status, -ENOENT);
  EXPECT_EQ(urb_->actual_length, 0);
}

TEST_F(UsbfsRequests, AfterUnplugWhatWaitedComesThenNothingMore)
{
  ASSERT_EQ(ioctl(file_, USBDEVFS_SUBMITURB, urb_.get()), 0);
  cable_.unplug();
  ASSERT_TRUE(isReady(5s));
  EXPECT_EQ(reap(), 0);
  EXPECT_EQ(urb_->status, -ESHUTDOWN);
  EXPECT_EQ(reap(), -ENODEV);
  EXPECT_EQ(ioctl(file_, USBDEVFS_SUBMITURB, urb_.get()), -1);
  EXPECT_EQ(errno, ENODEV);
}

TEST_F(UsbfsRequests, WhoGoesLeavesNothingBehind)
{
  ASSERT_EQ(ioctl(file_, USBDEVFS_SUBMITURB, urb_.get()), 0);
  startStream();
  ASSERT_TRUE(isReady(5s));
  // Closes while a frame is available and the interface is claimed.
  close(file_);
  openNode();
  // The mock detects the end of a client slightly later than the kernel would.
  const auto end = std::chrono::steady_clock::now() + 5s;
  while (isReady(0ms) && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(1ms);
  EXPECT_FALSE(isReady(0ms));
  EXPECT_EQ(claim(), 0);
  EXPECT_EQ(reap(), -EAGAIN);
}

} // namespace
} // namespace pcl::acmap::test
