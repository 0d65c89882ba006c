#include "iidc_camera_fixture.h"

#include <thread>

namespace pcl::acmap::test {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string>
textsOf(const std::vector<IidcMode>& modes)
{
  std::vector<std::string> texts;
  for (const IidcMode& mode : modes)
    texts.push_back(mode.text());
  return texts;
}

TEST_F(IidcCameraTest, TellsWhoItIs)
{
  EXPECT_FALSE(camera_.isOpen());
  camera_.open();
  EXPECT_TRUE(camera_.isOpen());
  EXPECT_EQ(camera_.place(), "memory");
  EXPECT_EQ(camera_.identity().maker, "Point Grey Research");
  EXPECT_EQ(camera_.identity().model, "Emulated Digiclops");
  EXPECT_EQ(camera_.identity().serial(), "00b09d0100c0ffee");
  EXPECT_EQ(camera_.identity().version, "1.30");
  EXPECT_TRUE(camera_.hasOneShot());
  EXPECT_TRUE(camera_.hasFrameCounter());
  camera_.close();
  EXPECT_FALSE(camera_.isOpen());
  EXPECT_EQ(camera_.identity().model, "Emulated Digiclops");
  EXPECT_EQ(faultOf([&] { camera_.feature(IidcFeature::Gain); }), CameraFault::Failed);
}

TEST_F(IidcCameraTest, OpeningTwiceIsOpeningOnce)
{
  camera_.open();
  const std::size_t accesses = cable_.accesses;
  camera_.open();
  EXPECT_EQ(cable_.accesses, accesses);
}

TEST_F(IidcCameraTest, ListsItsModesAscending)
{
  camera_.open();
  const std::vector<IidcMode> modes = camera_.modes();
  EXPECT_THAT(textsOf(modes),
              ElementsAre("0:4 640x480 RGB8",
                          "0:5 640x480 Mono8",
                          "7:0 640x480 Mono8",
                          "7:0 640x480 RGB8",
                          "7:0 640x480 Raw8",
                          "7:3 640x480 Mono16",
                          "7:3 640x480 Raw16"));
  EXPECT_THAT(modes.front().rates, ElementsAre(1.875F, 3.75F, 7.5F, 15.0F, 30.0F));
  EXPECT_TRUE(modes.back().rates.empty());
}

TEST_F(IidcCameraTest, FindsTheModeOfARig)
{
  camera_.open();
  EXPECT_EQ(camera_.findMode(640, 480, 3).text(), "7:0 640x480 RGB8");
  EXPECT_EQ(camera_.findMode(640, 480, 2).text(), "7:3 640x480 Mono16");
  EXPECT_EQ(camera_.findMode(640, 480, 1).text(), "7:0 640x480 Mono8");
  std::string message;
  EXPECT_EQ(faultOf([&] { camera_.findMode(1024, 768, 3); }, &message),
            CameraFault::Unsupported);
  EXPECT_THAT(message, HasSubstr("1024 x 768"));
  EXPECT_THAT(message, HasSubstr("7:3 640x480 Raw16"));
}

TEST_F(IidcCameraTest, TakesTheNearestRateOfAFixedMode)
{
  camera_.open();
  const IidcMode mode = modeOf(0, IidcColor::Rgb8);
  EXPECT_EQ(camera_.setMode(mode, 14), 15.0F);
  EXPECT_EQ(registerAt(iidc::current_rate), 3U << 29);
  EXPECT_EQ(registerAt(iidc::current_mode), 4U << 29);
  EXPECT_EQ(registerAt(iidc::current_format), 0U);
  EXPECT_EQ(camera_.setMode(mode, 0.01F), 1.875F);
  EXPECT_EQ(camera_.setMode(mode, 1000), 30.0F);
  EXPECT_EQ(registerAt(iidc::current_rate), 4U << 29);
}

TEST_F(IidcCameraTest, ARateOfAScalableModeIsAFeature)
{
  camera_.open();
  const IidcMode mode = modeOf(7, IidcColor::Rgb8);
  EXPECT_FLOAT_EQ(camera_.setMode(mode, 14), 14.0F);
  EXPECT_EQ(registerAt(iidc::current_format), 7U << 29);
  EXPECT_EQ(registerAt(iidc::current_mode), 0U);
  const IidcFeatureState rate = camera_.feature(IidcFeature::FrameRate);
  ASSERT_TRUE(rate.physical);
  EXPECT_FLOAT_EQ(rate.physical->value, 14.0F);
  EXPECT_FLOAT_EQ(camera_.setMode(mode, 1000), 30.0F); // maximum of the feature
}

TEST_F(IidcCameraTest, WithoutTheFeatureTheLengthOfPacketsIsTheRate)
{
  emulated_.faults().overrideRegister(iidc::feature_inquiry + 4 * iidc::FrameRate, 0);
  camera_.open();
  const IidcMode mode = modeOf(7, IidcColor::Rgb8);
  for (const float wanted : {1.0F, 7.0F, 14.0F, 30.0F}) {
    const float rate = camera_.setMode(mode, wanted);
    EXPECT_NEAR(rate, wanted, 0.02F * wanted); // packets consist of whole quadlets
    camera_.startStream(2);
    EXPECT_GE(cable_.frame_bytes, mode.bytes());
    EXPECT_FLOAT_EQ(rate,
                    8000.0F * static_cast<float>(registerAt(0x4044) >> 16) /
                        static_cast<float>(cable_.frame_bytes));
    camera_.stopStream();
  }
  EXPECT_LT(camera_.setMode(mode, 1000), 36.0F); // a packet has at most 4096 bytes
}

TEST_F(IidcCameraTest, RefusesModesAndRatesThatCannotBe)
{
  camera_.open();
  IidcMode mode = modeOf(7, IidcColor::Rgb8);
  for (const float rate : {0.0F, -1.0F, 1000.1F, std::nanf(""), INFINITY})
    EXPECT_THROW(camera_.setMode(mode, rate), BadArgumentException) << rate;
  mode.mode = 5;
  EXPECT_EQ(faultOf([&] { camera_.setMode(mode, 14); }), CameraFault::Unsupported);
  EXPECT_EQ(faultOf([&] { camera_.startStream(2); }), CameraFault::Unsupported);
}

TEST_F(IidcCameraTest, AModeThatFailsLeavesTheOneBefore)
{
  camera_.open();
  camera_.setMode(modeOf(0, IidcColor::Rgb8), 15);
  emulated_.faults().overrideRegister(iidc::format7_base + 0x040, 0);
  EXPECT_EQ(faultOf([&] { camera_.setMode(modeOf(7, IidcColor::Rgb8), 15); }),
            CameraFault::Malformed);
  camera_.close();
  camera_.open();
  EXPECT_EQ(registerAt(iidc::current_format), 0U);
  EXPECT_EQ(registerAt(iidc::current_mode), 4U << 29);
}

TEST_F(IidcCameraTest, PacketsThatCannotBeAreMalformed)
{
  camera_.open();
  const IidcMode mode = modeOf(7, IidcColor::Rgb8);
  for (const std::uint32_t range : {0U, 4U << 16, 4096U, 8U << 16 | 4U}) {
    emulated_.faults().overrideRegister(iidc::format7_base + 0x040, range);
    EXPECT_EQ(faultOf([&] { camera_.setMode(mode, 14); }), CameraFault::Malformed)
        << range;
  }
}

TEST_F(IidcCameraTest, AFrameIsCountedWhereTheCameraMiscounts)
{
  camera_.open();
  for (const std::uint32_t packets : {0U, 1U, 0xFFFFFFFFU}) {
    emulated_.faults().overrideRegister(iidc::format7_base + 0x048, packets);
    camera_.setMode(modeOf(7, IidcColor::Rgb8), 30);
    camera_.startStream(2);
    EXPECT_EQ(cable_.frame_bytes, 921600U); // 225 packets of 4096 bytes
    camera_.stopStream();
  }
}

TEST_F(IidcCameraTest, SettingsAreSetAgain)
{
  camera_.open();
  camera_.setMode(modeOf(7, IidcColor::Rgb8), 20);
  camera_.setPhysical(IidcFeature::Shutter, 0.02F);
  camera_.setValue(IidcFeature::Gain, 100);
  camera_.setAutomatic(IidcFeature::Exposure);
  camera_.setTrigger(IidcTrigger::External);
  emulated_.cyclePower();
  ASSERT_NE(registerAt(iidc::current_format), 7U << 29);
  camera_.close();
  camera_.open();
  EXPECT_EQ(registerAt(iidc::current_format), 7U << 29);
  EXPECT_FLOAT_EQ(camera_.feature(IidcFeature::FrameRate).physical->value, 20.0F);
  EXPECT_FLOAT_EQ(camera_.feature(IidcFeature::Shutter).physical->value, 0.02F);
  EXPECT_EQ(camera_.feature(IidcFeature::Gain).value, 100U);
  EXPECT_TRUE(camera_.feature(IidcFeature::Exposure).is_automatic);
  EXPECT_EQ(camera_.trigger(), IidcTrigger::External);
  EXPECT_TRUE(registerAt(iidc::feature_status + 4 * iidc::Trigger) & iidc::feature_on);
  EXPECT_TRUE(camera_.hasFrameCounter());
  EXPECT_EQ(registerAt(iidc::frame_info) & 0x3FF, 0x40U);
}

TEST_F(IidcCameraTest, AnotherCameraIsNotTheOneOfBefore)
{
  CameraOptions options;
  options.identity.guid = 0x1234;
  EmulatedIidcCamera other(greyImage, options);
  MemoryCable other_cable(other);
  bool is_swapped = false;
  IidcCamera camera(
      [&] { return is_swapped ? other_cable.opener()() : cable_.opener()(); });
  camera.open();
  camera.close();
  is_swapped = true;
  EXPECT_EQ(faultOf([&] { camera.open(); }), CameraFault::NotFound);
  EXPECT_FALSE(camera.isOpen());
  EXPECT_EQ(camera.identity().guid, CameraIdentity{}.guid);
  is_swapped = false;
  camera.open();
  EXPECT_TRUE(camera.isOpen());
}

TEST_F(IidcCameraTest, AStreamLeftOnByAnotherProgramIsStopped)
{
  emulated_.write(iidc::commands + iidc::iso_enable, iidc::on);
  camera_.open();
  EXPECT_EQ(registerAt(iidc::iso_enable), 0U);
}

TEST_F(IidcCameraTest, FramesComeOneAfterAnotherOrOneByOne)
{
  camera_.open();
  camera_.setMode(modeOf(7, IidcColor::Mono8), 30);
  IidcFrame frame;
  EXPECT_EQ(faultOf([&] { camera_.nextFrame(frame, 1ms); }), CameraFault::Failed);
  camera_.startStream(2);
  EXPECT_EQ(camera_.nextFrame(frame, 50ms), IidcWait::TimedOut);
  camera_.takeOne();
  ASSERT_EQ(camera_.nextFrame(frame, 10s), IidcWait::Frame);
  EXPECT_TRUE(frame.is_whole);
  EXPECT_EQ(frame.bytes.at(640), 0x55);
  EXPECT_EQ(camera_.nextFrame(frame, 50ms), IidcWait::TimedOut);
  camera_.runFreely();
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(camera_.nextFrame(frame, 10s), IidcWait::Frame);
  camera_.stopStream();
  EXPECT_EQ(registerAt(iidc::iso_enable), 0U);
}

TEST_F(IidcCameraTest, AWaitCanBeCancelled)
{
  camera_.open();
  camera_.setMode(modeOf(7, IidcColor::Mono8), 30);
  camera_.startStream(2);
  std::thread other([&] {
    std::this_thread::sleep_for(20ms);
    camera_.cancel();
  });
  IidcFrame frame;
  EXPECT_EQ(camera_.nextFrame(frame, 60s), IidcWait::Cancelled);
  other.join();
}

TEST_F(IidcCameraTest, WithoutTheCameraNothingThrowsThatMustNot)
{
  camera_.stopStream();
  camera_.cancel();
  camera_.close();
  camera_.open();
  camera_.setMode(modeOf(7, IidcColor::Mono8), 30);
  camera_.startStream(2);
  cable_.is_plugged = false;
  EXPECT_EQ(faultOf([&] { camera_.runFreely(); }), CameraFault::Unplugged);
  camera_.stopStream();
  camera_.close();
  EXPECT_EQ(faultOf([&] { camera_.open(); }), CameraFault::Unplugged);
}

class IidcCameraWithTiles : public IidcCameraTest {
protected:
  static CameraOptions
  gbrg()
  {
    CameraOptions options;
    options.tiles = "GBRG";
    return options;
  }

  IidcCameraWithTiles()
  : IidcCameraTest(gbrg())
  {}
};

TEST_F(IidcCameraWithTiles, KnowsItsColourFilter)
{
  camera_.open();
  camera_.setMode(modeOf(7, IidcColor::Rgb8), 14);
  EXPECT_EQ(camera_.colorFilter(), "GBRG");
  // Without Point Grey's register the mode tells the filter, for raw images only.
  emulated_.faults().overrideRegister(iidc::bayer_tiles, 0xFFFFFFFF);
  emulated_.faults().overrideRegister(iidc::format7_base + 0x058, 3U << 24);
  EXPECT_EQ(camera_.colorFilter(), "YYYY");
  camera_.setMode(modeOf(7, IidcColor::Raw8), 14);
  EXPECT_EQ(camera_.colorFilter(), "BGGR");
  emulated_.faults().overrideRegister(iidc::format7_base + 0x058, 0xFFFFFFFF);
  EXPECT_EQ(camera_.colorFilter(), "YYYY");
}

class IidcCameraUnsettled : public IidcCameraTest {
protected:
  static CameraOptions
  endless()
  {
    CameraOptions options;
    options.setting_reads = 1U << 30;
    return options;
  }

  IidcCameraUnsettled()
  : IidcCameraTest(endless())
  {}
};

TEST_F(IidcCameraUnsettled, IsSilent)
{
  camera_.open();
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(faultOf([&] { camera_.setMode(modeOf(7, IidcColor::Rgb8), 14); }),
            CameraFault::Silent);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 10s);
}

} // namespace
} // namespace pcl::acmap::test
