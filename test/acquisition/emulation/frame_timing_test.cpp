#include "emulated_iidc_camera.h"
#include "frame_bytes.h"
#include "iidc_addresses.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace pcl::acmap::test {
namespace {

using namespace iidc;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

class FrameTiming : public testing::Test {
protected:
  void
  write(std::uint32_t offset, std::uint32_t value)
  {
    EXPECT_TRUE(camera_.write(commands + offset, value));
  }

  std::uint32_t
  read(std::uint32_t offset)
  {
    return camera_.read(commands + offset).value();
  }

  CameraFrame
  awaitFrame()
  {
    const auto end = Clock::now() + 5s;
    while (Clock::now() < end) {
      if (auto frame = camera_.takeFrame())
        return std::move(*frame);
      std::this_thread::sleep_for(1ms);
    }
    ADD_FAILURE() << "no frame";
    return {};
  }

  void
  unlock()
  {
    write(access_high, 0x00B09D00);
    write(access_low, 0x0004FFFF);
  }

  std::atomic<int> exposures_ = 0;
  std::atomic<std::int64_t> exposure_us_ = 0;
  EmulatedIidcCamera camera_{[this](const Exposure& exposure) {
    ++exposures_;
    exposure_us_ = std::chrono::duration_cast<std::chrono::microseconds>(exposure.end -
                                                                         exposure.begin)
                       .count();
    return std::vector<std::uint8_t>(exposure.setting.image_bytes, 9);
  }};
};

TEST_F(FrameTiming, FramesComeAtTheirRate)
{
  write(current_rate, 4U << 29); // 30 a second
  const auto start = Clock::now();
  write(iso_enable, on);
  for (std::uint64_t number = 0; number < 6; ++number)
    EXPECT_EQ(awaitFrame().number, number);
  EXPECT_GE(Clock::now() - start, 190ms);
}

TEST_F(FrameTiming, TheFrameRateFeatureSlowsThemDown)
{
  write(feature_status + 4 * FrameRate, absolute_control | feature_on);
  write(absolute_base + 16 * FrameRate + 8, 0x41200000); // 10
  const auto start = Clock::now();
  write(iso_enable, on);
  awaitFrame();
  awaitFrame();
  EXPECT_GE(Clock::now() - start, 195ms);
}

TEST_F(FrameTiming, ExposuresAreAsLongAsTheShutterSays)
{
  write(feature_status + 4 * Shutter, absolute_control | feature_on);
  write(absolute_base + 16 * Shutter + 8, 0x3C23D70A); // 0.01
  write(one_shot, on);
  awaitFrame();
  EXPECT_NEAR(exposure_us_, 10000, 2);
}

TEST_F(FrameTiming, WhatNobodyTakesIsLost)
{
  write(current_rate, 4U << 29);
  write(iso_enable, on);
  while (exposures_ < 6)
    std::this_thread::sleep_for(1ms);
  std::vector<std::uint64_t> numbers;
  for (int i = 0; i < 4; ++i)
    numbers.push_back(awaitFrame().number);
  EXPECT_EQ(numbers[0], 0U);
  EXPECT_EQ(numbers[2], 2U);
  EXPECT_GE(numbers[3], 5U);
}

TEST_F(FrameTiming, OneShotIsOneFrame)
{
  write(one_shot, on);
  EXPECT_EQ(read(one_shot), on);
  EXPECT_EQ(awaitFrame().number, 0U);
  EXPECT_EQ(read(one_shot), 0U);
  std::this_thread::sleep_for(100ms);
  EXPECT_FALSE(camera_.takeFrame());
}

TEST_F(FrameTiming, ATriggerIsOneFrame)
{
  write(feature_status + 4 * Trigger, feature_on);
  write(iso_enable, on);
  std::this_thread::sleep_for(150ms);
  EXPECT_FALSE(camera_.takeFrame());
  for (std::uint64_t number = 0; number < 3; ++number) {
    write(software_trigger, on);
    EXPECT_EQ(awaitFrame().number, number);
  }
}

TEST_F(FrameTiming, StopIsTheEndOfWhatWaits)
{
  write(iso_enable, on);
  while (exposures_ < 2)
    std::this_thread::sleep_for(1ms);
  write(iso_enable, 0);
  EXPECT_FALSE(camera_.takeFrame());
  write(iso_enable, on);
  EXPECT_GE(awaitFrame().number, 2U);
}

TEST_F(FrameTiming, NumbersAreEmbeddedAsAsked)
{
  camera_.faults().failFrame(FrameFault::WrongCounter, 1);
  unlock();
  write(frame_info, 0x40); // number
  write(one_shot, on);
  CameraFrame frame = awaitFrame();
  const std::vector<std::uint8_t> head = {0, 0, 0, 0, 9, 9};
  EXPECT_TRUE(std::equal(head.begin(), head.end(), frame.bytes.begin()));
  write(one_shot, on);
  frame = awaitFrame();
  EXPECT_EQ(frame.bytes.at(0), 0xBA);
  write(frame_info, 0x44); // shutter, number
  write(one_shot, on);
  frame = awaitFrame();
  const std::uint32_t shutter = read(feature_status + 4 * Shutter);
  EXPECT_EQ(frame.bytes.at(0), shutter >> 24);
  EXPECT_EQ(frame.bytes.at(3), shutter & 0xFF);
  EXPECT_EQ(frame.bytes.at(7), 2);
  EXPECT_EQ(frame.bytes.at(8), 9);
}

TEST(FrameBytes, InterleavedInTheOrderWanted)
{
  TrinocularFrame frame;
  frame.images[0] = {2, 1, 1, {1, 2}};
  frame.images[1] = {2, 1, 1, {3, 4}};
  frame.images[2] = {2, 1, 1, {5, 6}};
  EXPECT_EQ(
      interleaved(frame,
                  {RigCamera::Vertical, RigCamera::Reference, RigCamera::Horizontal}),
      (std::vector<std::uint8_t>{5, 1, 3, 6, 2, 4}));
}

TEST(FrameBytes, MosaicTakesTheColourOfEachTile)
{
  const CameraImage colour{2, 2, 3, {10, 20, 30, 11, 21, 31, 12, 22, 32, 13, 23, 33}};
  EXPECT_EQ(mosaicOf(colour, "GBRG").values,
            (std::vector<std::uint8_t>{20, 31, 12, 23}));
  EXPECT_EQ(mosaicOf(colour, "RGGB").values,
            (std::vector<std::uint8_t>{10, 21, 22, 33}));
}

} // namespace
} // namespace pcl::acmap::test
