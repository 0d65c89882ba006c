#include "iidc_camera_fixture.h"
#include "messages.h"

#include <pcl/core/exceptions.h>

namespace pcl::acmap::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class IidcFeatures : public IidcCameraTest {
protected:
  IidcFeatures()
  {
    camera_.open();
  }

  /** Message of the exception that a setter throws. */
  template <typename Work>
  std::string
  refusalOf(const Work& work)
  {
    return messageOf<BadArgumentException>(work, "none");
  }
};

TEST_F(IidcFeatures, TellWhatTheyCan)
{
  const IidcFeatureState gain = camera_.feature(IidcFeature::Gain);
  EXPECT_TRUE(gain.is_there);
  EXPECT_TRUE(gain.can_be_automatic);
  EXPECT_TRUE(gain.can_be_set);
  EXPECT_TRUE(gain.can_be_off);
  EXPECT_TRUE(gain.is_on);
  EXPECT_FALSE(gain.is_automatic);
  EXPECT_EQ(gain.minimum, 16U);
  EXPECT_EQ(gain.maximum, 683U);
  EXPECT_EQ(gain.value, 16U);
  ASSERT_TRUE(gain.physical);
  EXPECT_FLOAT_EQ(gain.physical->minimum, 0);
  EXPECT_FLOAT_EQ(gain.physical->maximum, 24);
  EXPECT_FALSE(camera_.feature(IidcFeature::Pan).physical);
  EXPECT_FALSE(camera_.feature(IidcFeature::Sharpness).is_there);
}

TEST_F(IidcFeatures, AreSetInSteps)
{
  camera_.setValue(IidcFeature::Shutter, 1);
  EXPECT_EQ(camera_.feature(IidcFeature::Shutter).value, 1U);
  camera_.setValue(IidcFeature::Shutter, 1000);
  EXPECT_EQ(camera_.feature(IidcFeature::Shutter).value, 1000U);
  camera_.setValue(IidcFeature::Pan, 2);
  EXPECT_EQ(camera_.feature(IidcFeature::Pan).value, 2U);
}

TEST_F(IidcFeatures, AreSetInPhysicalUnits)
{
  camera_.setPhysical(IidcFeature::Shutter, 0.0123F);
  EXPECT_FLOAT_EQ(camera_.feature(IidcFeature::Shutter).physical->value, 0.0123F);
  // The same in steps: the value that was set last is active.
  camera_.setValue(IidcFeature::Shutter, 1000);
  EXPECT_FLOAT_EQ(camera_.feature(IidcFeature::Shutter).physical->value, 0.1F);
}

TEST_F(IidcFeatures, RefuseWhatIsOutOfRange)
{
  EXPECT_THAT(refusalOf([&] { camera_.setValue(IidcFeature::Gain, 15); }),
              AllOf(HasSubstr("gain"), HasSubstr("[16, 683]")));
  EXPECT_THAT(refusalOf([&] { camera_.setValue(IidcFeature::Gain, 684); }),
              HasSubstr("684"));
  EXPECT_THAT(refusalOf([&] { camera_.setPhysical(IidcFeature::Shutter, 0.2F); }),
              AllOf(HasSubstr("shutter"), HasSubstr("0.1] s")));
  EXPECT_THAT(refusalOf([&] { camera_.setPhysical(IidcFeature::Gain, NAN); }),
              HasSubstr("dB"));
  EXPECT_EQ(camera_.feature(IidcFeature::Gain).value, 16U);
  // Rejected values are not set at the next opening either.
  camera_.close();
  camera_.open();
  EXPECT_EQ(camera_.feature(IidcFeature::Gain).value, 16U);
}

TEST_F(IidcFeatures, AreLeftToTheCamera)
{
  camera_.setAutomatic(IidcFeature::Exposure);
  EXPECT_TRUE(camera_.feature(IidcFeature::Exposure).is_automatic);
  camera_.setValue(IidcFeature::Exposure, 100);
  EXPECT_FALSE(camera_.feature(IidcFeature::Exposure).is_automatic);
}

TEST_F(IidcFeatures, ThatAreNotThereAreUnsupported)
{
  const auto unsupported = CameraFault::Unsupported;
  EXPECT_EQ(faultOf([&] { camera_.setValue(IidcFeature::Sharpness, 1); }), unsupported);
  EXPECT_EQ(faultOf([&] { camera_.setPhysical(IidcFeature::Pan, 1); }), unsupported);
  emulated_.faults().overrideRegister(iidc::feature_inquiry + 4 * iidc::Gain,
                                      0x80000000);
  EXPECT_EQ(faultOf([&] { camera_.setAutomatic(IidcFeature::Gain); }), unsupported);
  EXPECT_EQ(faultOf([&] { camera_.setValue(IidcFeature::Gain, 0); }), unsupported);
}

TEST_F(IidcFeatures, WhiteBalanceKeepsItsSecondValue)
{
  camera_.setValue(IidcFeature::WhiteBalance, 700);
  EXPECT_EQ(registerAt(iidc::feature_status + 4 * iidc::WhiteBalance) & 0xFFFFFF,
            512U << 12 | 700);
}

TEST_F(IidcFeatures, PhysicalValuesThatAreNoNumbersAreNotThere)
{
  const std::uint32_t shutter = iidc::absolute_base + 16 * iidc::Shutter;
  emulated_.faults().overrideRegister(shutter, 0x7FC00000); // NaN
  EXPECT_FALSE(camera_.feature(IidcFeature::Shutter).physical);
  EXPECT_EQ(faultOf([&] { camera_.setPhysical(IidcFeature::Shutter, 0.01F); }),
            CameraFault::Unsupported);
}

TEST_F(IidcFeatures, PhysicalValuesAtTheEndOfTheRegisterSpaceAreNotThere)
{
  emulated_.faults().overrideRegister(iidc::absolute_csr + 4 * iidc::Shutter,
                                      0x03FFFFFF); // room for one of the three
  EXPECT_FALSE(camera_.feature(IidcFeature::Shutter).physical);
}

TEST_F(IidcFeatures, TriggerIsSwitched)
{
  const std::uint32_t trigger = iidc::feature_status + 4 * iidc::Trigger;
  EXPECT_EQ(camera_.trigger(), IidcTrigger::Off);
  camera_.setTrigger(IidcTrigger::External);
  EXPECT_TRUE(registerAt(trigger) & iidc::feature_on);
  EXPECT_EQ(registerAt(trigger) & 0x000F0000, 0U); // mode 0
  camera_.setTrigger(IidcTrigger::Off);
  EXPECT_FALSE(registerAt(trigger) & iidc::feature_on);
  emulated_.faults().overrideRegister(iidc::feature_inquiry + 4 * iidc::Trigger, 0);
  EXPECT_EQ(faultOf([&] { camera_.setTrigger(IidcTrigger::External); }),
            CameraFault::Unsupported);
  EXPECT_EQ(camera_.trigger(), IidcTrigger::Off);
}

TEST_F(IidcFeatures, CameraWithLittleHasLittle)
{
  emulated_.faults().overrideRegister(iidc::basic_functions, 0);
  emulated_.faults().overrideRegister(iidc::frame_info, 0xFFFFFFFF);
  camera_.close();
  camera_.open();
  EXPECT_FALSE(camera_.hasOneShot());
  EXPECT_FALSE(camera_.hasFrameCounter());
  camera_.setMode(modeOf(7, IidcColor::Mono8), 30);
  camera_.startStream(2);
  EXPECT_EQ(faultOf([&] { camera_.takeOne(); }), CameraFault::Unsupported);
}

} // namespace
} // namespace pcl::acmap::test
