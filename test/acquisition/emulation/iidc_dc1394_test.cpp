#include "iidc_addresses.h"
#include "usb_testbed.h"

#include <dc1394/dc1394.h>
#include <gtest/gtest.h>

#include <cstring>
#include <memory>

// libdc1394 does not free the configuration descriptor that it requests from libusb at
// each start of a capture.
extern "C" __attribute__((visibility("default"))) const char*
__lsan_default_suppressions()
{
  return "leak:libusb-1.0.so";
}

// libdc1394 also supports IIDC over USB and is independent of acmap: it tests that the
// emulated camera behaves like a real one.
namespace pcl::acmap::test {
namespace {

std::vector<std::uint8_t>
bytesOf(const Exposure& exposure)
{
  std::vector<std::uint8_t> bytes(exposure.setting.image_bytes);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<std::uint8_t>(i * 7 + i / 251 + exposure.number * 31);
  return bytes;
}

struct FreeDc1394 {
  void
  operator()(dc1394_t* context) const
  {
    dc1394_free(context);
  }
  void
  operator()(dc1394camera_t* camera) const
  {
    dc1394_camera_free(camera);
  }
  void
  operator()(dc1394camera_list_t* list) const
  {
    dc1394_camera_free_list(list);
  }
};

constexpr std::uint32_t buffers = 4;

class IidcDc1394 : public testing::Test {
protected:
  void
  SetUp() override
  {
    context_.reset(dc1394_new());
    dc1394camera_list_t* list = nullptr;
    ASSERT_EQ(dc1394_camera_enumerate(context_.get(), &list), DC1394_SUCCESS);
    const std::unique_ptr<dc1394camera_list_t, FreeDc1394> found(list);
    ASSERT_EQ(found->num, 1U);
    EXPECT_EQ(found->ids[0].guid, CameraIdentity{}.guid);
    camera_.reset(dc1394_camera_new(context_.get(), found->ids[0].guid));
    ASSERT_TRUE(camera_);
  }

  void
  TearDown() override
  {
    camera_.reset();
    context_.reset();
  }

  /** \brief Captures frames, which must be equal to the source and consecutive. */
  void
  capture(std::size_t frames, std::uint64_t first)
  {
    for (std::size_t i = 0; i < frames; ++i) {
      dc1394video_frame_t* frame = nullptr;
      ASSERT_EQ(
          dc1394_capture_dequeue(camera_.get(), DC1394_CAPTURE_POLICY_WAIT, &frame),
          DC1394_SUCCESS);
      EXPECT_FALSE(dc1394_capture_is_frame_corrupt(camera_.get(), frame));
      const std::vector<std::uint8_t> want = bytesOf({first + i, {}, {}, setting_});
      ASSERT_GE(frame->total_bytes, want.size());
      EXPECT_EQ(std::memcmp(frame->image, want.data(), want.size()), 0) << i;
      ASSERT_EQ(dc1394_capture_enqueue(camera_.get(), frame), DC1394_SUCCESS);
    }
  }

  void
  setFixedMode()
  {
    ASSERT_EQ(dc1394_video_set_iso_speed(camera_.get(), DC1394_ISO_SPEED_400),
              DC1394_SUCCESS);
    ASSERT_EQ(dc1394_video_set_mode(camera_.get(), DC1394_VIDEO_MODE_640x480_RGB8),
              DC1394_SUCCESS);
    ASSERT_EQ(dc1394_video_set_framerate(camera_.get(), DC1394_FRAMERATE_15),
              DC1394_SUCCESS);
    setting_.image_bytes = 921600;
    ASSERT_EQ(
        dc1394_capture_setup(camera_.get(), buffers, DC1394_CAPTURE_FLAGS_DEFAULT),
        DC1394_SUCCESS);
  }

  EmulatedIidcCamera emulated_{bytesOf};
  UsbTestbed testbed_;
  EmulatedUsbCamera cable_{testbed_, emulated_};
  VideoSetting setting_;
  std::unique_ptr<dc1394_t, FreeDc1394> context_;
  std::unique_ptr<dc1394camera_t, FreeDc1394> camera_;
};

TEST_F(IidcDc1394, KnowsTheCamera)
{
  EXPECT_STREQ(camera_->vendor, "Point Grey Research");
  EXPECT_STREQ(camera_->model, "Emulated Digiclops");
  EXPECT_EQ(camera_->iidc_version, DC1394_IIDC_VERSION_1_30);
  EXPECT_EQ(camera_->vendor_id, 0x00B09DU);
  EXPECT_EQ(camera_->one_shot_capable, DC1394_TRUE);
  dc1394video_modes_t modes;
  ASSERT_EQ(dc1394_video_get_supported_modes(camera_.get(), &modes), DC1394_SUCCESS);
  ASSERT_EQ(modes.num, 4U);
  EXPECT_EQ(modes.modes[0], DC1394_VIDEO_MODE_640x480_RGB8);
  EXPECT_EQ(modes.modes[1], DC1394_VIDEO_MODE_640x480_MONO8);
  EXPECT_EQ(modes.modes[2], DC1394_VIDEO_MODE_FORMAT7_0);
  EXPECT_EQ(modes.modes[3], DC1394_VIDEO_MODE_FORMAT7_3);
}

TEST_F(IidcDc1394, FramesOfAFixedMode)
{
  setFixedMode();
  ASSERT_EQ(dc1394_video_set_transmission(camera_.get(), DC1394_ON), DC1394_SUCCESS);
  capture(12, 0);
  ASSERT_EQ(dc1394_video_set_transmission(camera_.get(), DC1394_OFF), DC1394_SUCCESS);
  EXPECT_EQ(dc1394_capture_stop(camera_.get()), DC1394_SUCCESS);
}

TEST_F(IidcDc1394, FramesOfAScalableMode)
{
  // Packets of 1000 bytes do not divide the image: the padding of the last packet is
  // ignored.
  ASSERT_EQ(dc1394_video_set_mode(camera_.get(), DC1394_VIDEO_MODE_FORMAT7_0),
            DC1394_SUCCESS);
  ASSERT_EQ(dc1394_format7_set_roi(camera_.get(),
                                   DC1394_VIDEO_MODE_FORMAT7_0,
                                   DC1394_COLOR_CODING_RGB8,
                                   1000,
                                   8,
                                   16,
                                   320,
                                   200),
            DC1394_SUCCESS);
  std::uint64_t total = 0;
  ASSERT_EQ(dc1394_format7_get_total_bytes(
                camera_.get(), DC1394_VIDEO_MODE_FORMAT7_0, &total),
            DC1394_SUCCESS);
  setting_.image_bytes = std::size_t{320} * 200 * 3;
  ASSERT_EQ(dc1394_capture_setup(camera_.get(), buffers, DC1394_CAPTURE_FLAGS_DEFAULT),
            DC1394_SUCCESS);
  ASSERT_EQ(dc1394_video_set_transmission(camera_.get(), DC1394_ON), DC1394_SUCCESS);
  capture(12, 0);
  ASSERT_EQ(dc1394_video_set_transmission(camera_.get(), DC1394_OFF), DC1394_SUCCESS);
  EXPECT_EQ(dc1394_capture_stop(camera_.get()), DC1394_SUCCESS);
}

TEST_F(IidcDc1394, OneShot)
{
  setFixedMode();
  for (std::uint64_t number = 0; number < 3; ++number) {
    ASSERT_EQ(dc1394_video_set_one_shot(camera_.get(), DC1394_ON), DC1394_SUCCESS);
    capture(1, number);
    dc1394bool_t pending = DC1394_TRUE;
    ASSERT_EQ(dc1394_video_get_one_shot(camera_.get(), &pending), DC1394_SUCCESS);
    EXPECT_EQ(pending, DC1394_FALSE);
  }
  EXPECT_EQ(dc1394_capture_stop(camera_.get()), DC1394_SUCCESS);
}

} // namespace
} // namespace pcl::acmap::test
