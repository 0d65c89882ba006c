#include "iidc_camera_fixture.h"

#include <pcl/core/exceptions.h>

#include <algorithm>
#include <random>

namespace pcl::acmap::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/** Persistent noise: each register always returns the same value. */
MemoryCable::Garble
lastingNoise(std::uint64_t seed)
{
  return [seed](std::uint64_t address) {
    std::mt19937_64 random(seed * 0x9E3779B97F4A7C15 + address);
    return static_cast<std::uint32_t>(random());
  };
}

void
expectSense(const std::vector<IidcMode>& modes)
{
  EXPECT_LE(modes.size(), 3U * 8 + 8 * 11);
  for (const IidcMode& mode : modes) {
    EXPECT_TRUE((mode.format >= 0 && mode.format <= 2) || mode.format == 7);
    EXPECT_TRUE(mode.mode >= 0 && mode.mode <= 7);
    EXPECT_TRUE(mode.width > 0 && mode.width <= 32768);
    EXPECT_TRUE(mode.height > 0 && mode.height <= 32768);
    EXPECT_LE(mode.color, IidcColor::Raw16);
    EXPECT_EQ(mode.rates.empty(), mode.format == 7);
    EXPECT_TRUE(std::is_sorted(mode.rates.begin(), mode.rates.end()));
  }
}

/** Calls a function, which may only throw these exceptions, whatever the camera
 * returns. */
template <typename Work>
void
survive(const Work& work)
{
  try {
    work();
  }
  catch (const CameraException& exception) {
    EXPECT_NE(exception.fault(), CameraFault::None);
  }
}

template <typename Work>
void
surviveSetting(const Work& work)
{
  try {
    survive(work);
  }
  catch (const BadArgumentException&) { // outside the range that the camera reported
  }
}

class IidcGarbage : public IidcCameraTest {
protected:
  void
  useAll(std::size_t modes_to_try)
  {
    const std::vector<IidcMode> modes = camera_.modes();
    expectSense(modes);
    for (std::size_t i = 0; i < std::min(modes_to_try, modes.size()); ++i)
      survive([&] {
        const IidcMode& mode = modes[i * modes.size() / modes_to_try];
        EXPECT_GT(camera_.setMode(mode, 14), 0);
        stream();
      });
    survive([&] { camera_.colorFilter(); });
    survive([&] { camera_.setTrigger(IidcTrigger::External); });
    for (const IidcFeature feature :
         {IidcFeature::Gain, IidcFeature::Shutter, IidcFeature::WhiteBalance}) {
      survive([&] { camera_.feature(feature); });
      surviveSetting([&] { camera_.setValue(feature, 100); });
      surviveSetting([&] { camera_.setPhysical(feature, 1); });
      survive([&] { camera_.setAutomatic(feature); });
    }
  }

  void
  stream()
  {
    try {
      camera_.startStream(2);
      camera_.runFreely();
      IidcFrame frame;
      camera_.nextFrame(frame, 0ms);
      camera_.takeOne();
    }
    catch (const CameraException&) {
    }
    camera_.stopStream();
  }
};

TEST_F(IidcGarbage, ThatChangesWithEachRead)
{
  const auto begin = Clock::now();
  int opened = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    emulated_.faults().overrideAllRegisters(seed);
    IidcCamera fresh(cable_.opener());
    survive([&] { fresh.open(); });
    survive([&] { camera_.open(); });
    opened += camera_.isOpen() ? 1 : 0;
    useAll(3);
    camera_.close();
  }
  EXPECT_GT(opened, 0);
  EXPECT_LT(Clock::now() - begin, 60s);
}

TEST_F(IidcGarbage, ThatStays)
{
  const auto begin = Clock::now();
  int opened = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    cable_.garble = lastingNoise(seed);
    survive([&] { camera_.open(); });
    opened += camera_.isOpen() ? 1 : 0;
    useAll(2);
    camera_.close();
  }
  EXPECT_GT(opened, 0);
  EXPECT_LT(Clock::now() - begin, 60s);
}

TEST_F(IidcGarbage, ThatIsOneNumber)
{
  for (const std::uint32_t number :
       {0U, 1U, 0x80000000U, 0x7FFFFFFFU, 0xFFFFFFFFU, 0x40000000U, 0x03FFFFFFU}) {
    SCOPED_TRACE(number);
    cable_.garble = [number](std::uint64_t) { return number; };
    survive([&] { camera_.open(); });
    useAll(3);
    camera_.close();
  }
}

/** A configured camera that reports different capabilities when it is opened again. */
TEST_F(IidcGarbage, AfterSettings)
{
  camera_.open();
  camera_.setMode(modeOf(7, IidcColor::Rgb8), 14);
  camera_.setPhysical(IidcFeature::Shutter, 0.01F);
  camera_.setValue(IidcFeature::Gain, 100);
  camera_.close();
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    emulated_.faults().overrideAllRegisters(seed);
    survive([&] { camera_.open(); });
    camera_.close();
  }
  emulated_.faults().heal();
  emulated_.faults().overrideRegister(iidc::feature_inquiry + 4 * iidc::Gain,
                                      0x81000000 | 200U << 12 | 300);
  EXPECT_NE(faultOf([&] { camera_.open(); }), CameraFault::None);
  emulated_.faults().heal();
  camera_.open();
  EXPECT_EQ(camera_.feature(IidcFeature::Gain).value, 100U);
}

/** Lets each access fail once: opening is aborted, and can be repeated without side
 * effects. */
TEST_F(IidcGarbage, AnyAccessMayFail)
{
  camera_.open();
  camera_.setMode(modeOf(7, IidcColor::Rgb8), 14);
  camera_.setValue(IidcFeature::Gain, 100);
  camera_.close();
  cable_.accesses = 0;
  camera_.open();
  const std::size_t accesses = cable_.accesses;
  ASSERT_GT(accesses, 50U);
  camera_.close();
  for (const CameraFault fault :
       {CameraFault::Unplugged, CameraFault::Silent, CameraFault::Unsupported})
    for (std::size_t failing = 0; failing < accesses; ++failing) {
      SCOPED_TRACE(failing);
      cable_.failure = fault;
      cable_.failing_access = failing;
      cable_.accesses = 0;
      const CameraFault told = faultOf([&] { camera_.open(); });
      EXPECT_EQ(camera_.isOpen(), told == CameraFault::None);
      // A missing register may be optional.
      EXPECT_TRUE(told == fault || fault == CameraFault::Unsupported);
      camera_.close();
    }
  cable_.failing_access = ~std::size_t{0};
  camera_.open();
  EXPECT_EQ(camera_.feature(IidcFeature::Gain).value, 100U);
}

TEST_F(IidcGarbage, InTheRom)
{
  for (const RomFault fault : {RomFault::Cut,
                               RomFault::Zero,
                               RomFault::WrongBus,
                               RomFault::FarUnit,
                               RomFault::FarLeaves,
                               RomFault::HugeLeaf}) {
    SCOPED_TRACE(static_cast<int>(fault));
    emulated_.faults().breakRom(fault);
    EXPECT_NE(faultOf([&] { camera_.open(); }), CameraFault::None);
    EXPECT_FALSE(camera_.isOpen());
  }
  emulated_.faults().breakRom(RomFault::Endless); // nobody reads that far
  camera_.open();
}

} // namespace
} // namespace pcl::acmap::test
