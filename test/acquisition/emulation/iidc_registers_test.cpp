#include "emulated_iidc_camera.h"
#include "iidc_addresses.h"

#include <gtest/gtest.h>

#include <cstring>

namespace pcl::acmap::test {
namespace {

using namespace iidc;

std::vector<std::uint8_t>
nothing(const Exposure& exposure)
{
  return std::vector<std::uint8_t>(exposure.setting.image_bytes);
}

float
floatOf(std::uint32_t bits)
{
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

std::uint32_t
bitsOf(float value)
{
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

class IidcRegisters : public testing::Test {
protected:
  std::uint32_t
  read(std::uint32_t offset)
  {
    return camera_.read(commands + offset).value();
  }

  void
  write(std::uint32_t offset, std::uint32_t value)
  {
    EXPECT_TRUE(camera_.write(commands + offset, value));
  }

  /** \brief Offset of the CSRs to which a register points. */
  std::uint32_t
  follow(std::uint32_t offset)
  {
    return 4 * read(offset) - command_base;
  }

  EmulatedIidcCamera camera_{nothing};
};

TEST_F(IidcRegisters, RomNamesTheCamera)
{
  const auto rom = [&](std::uint64_t index) {
    return camera_.read(config_rom + 4 * index).value();
  };
  EXPECT_EQ(rom(0) >> 24, 4U);
  EXPECT_EQ(rom(1), 0x31333934U);
  EXPECT_EQ(std::uint64_t{rom(3)} << 32 | rom(4), CameraIdentity{}.guid);
  std::uint64_t end = 0;
  while (camera_.read(config_rom + 4 * end))
    ++end;
  EXPECT_GT(end, 20U);
  EXPECT_LT(end, 64U);
}

TEST_F(IidcRegisters, RomOfPointGrey)
{
  CameraIdentity identity;
  EXPECT_EQ(configRomOf(identity).at(10), 0x1200A02DU);
  identity.point_grey_unit = true;
  EXPECT_EQ(configRomOf(identity).at(10), 0x1200B09DU);
}

TEST_F(IidcRegisters, FormatsModesRates)
{
  EXPECT_EQ(read(0x100), 0x81000000U);
  EXPECT_EQ(read(0x180), 0x0C000000U);
  EXPECT_EQ(read(0x19C), 0x90000000U);
  EXPECT_EQ(read(0x210), 0xF8000000U); // RGB8: 1.875 to 30 frames per second
  EXPECT_EQ(read(0x604), 4U << 29);
  write(0x604, 5U << 29);
  EXPECT_EQ(read(0x628), 0U);
  write(0x604, 2U << 29);
  EXPECT_EQ(read(0x628), 0x80000000U);
}

TEST_F(IidcRegisters, ReadOnlyAndUnknownOnes)
{
  write(0x100, 0);
  EXPECT_EQ(read(0x100), 0x81000000U);
  EXPECT_EQ(read(0xABC), 0xFFFFFFFFU);
  EXPECT_FALSE(camera_.read(commands + 2));
  CameraOptions options;
  options.refuse_unknown = true;
  EmulatedIidcCamera strict(nothing, options);
  EXPECT_FALSE(strict.read(commands + 0xABC));
  EXPECT_FALSE(strict.write(commands + 0xABC, 0));
}

TEST_F(IidcRegisters, InitializeMakesAllAsAtFirst)
{
  write(0x604, 5U << 29);
  write(0x000, 0x80000000);
  EXPECT_EQ(read(0x000), 0U);
  EXPECT_EQ(read(0x604), 4U << 29);
}

TEST_F(IidcRegisters, ScalableModeAfterItsHandshake)
{
  const std::uint32_t base = follow(0x2E0);
  EXPECT_EQ(read(base), 640U << 16 | 480);
  EXPECT_EQ(read(base + 0x10), 4U << 24);
  EXPECT_EQ(read(base + 0x3C), 921600U);
  EXPECT_EQ(read(base + 0x40), 4U << 16 | 4096);
  EXPECT_EQ(read(base + 0x48), 480U);
  write(base + 0x0C, 320U << 16 | 240);
  write(base + 0x10, 0U);
  EXPECT_EQ(read(base + 0x3C), 921600U);
  write(base + 0x7C, 0x40000000);
  EXPECT_EQ(read(base + 0x7C), 0xC0000000U);
  EXPECT_EQ(read(base + 0x7C), 0xC0000000U);
  EXPECT_EQ(read(base + 0x7C), 0x80000000U);
  EXPECT_EQ(read(base + 0x34), 76800U);
  EXPECT_EQ(read(base + 0x3C), 76800U);
  EXPECT_EQ(read(base + 0x48), 40U);
  write(base + 0x44, 1000U << 16);
  EXPECT_EQ(read(base + 0x44) >> 16, 1000U);
  EXPECT_EQ(read(base + 0x48), 77U);
}

TEST_F(IidcRegisters, ScalableModeKnowsItsLimits)
{
  const std::uint32_t base = follow(0x2E0 + 4 * 3);
  const auto flags = [&] {
    write(base + 0x7C, 0x40000000);
    return read(base + 0x7C) & 0x00C00000;
  };
  EXPECT_EQ(read(base + 0x14), 0x04200000U); // Mono16, Raw16
  EXPECT_EQ(flags(), 0U);
  write(base + 0x08, 8U << 16);
  EXPECT_EQ(flags(), 0x00800000U);
  write(base + 0x08, 0);
  write(base + 0x10, 4U << 24);
  EXPECT_EQ(flags(), 0x00800000U);
  write(base + 0x10, 10U << 24);
  write(base + 0x44, 4100U << 16);
  EXPECT_EQ(flags(), 0x00400000U);
  write(base + 0x44, 0);
  EXPECT_EQ(flags(), 0x00400000U);
  write(base + 0x44, 2560U << 16);
  EXPECT_EQ(flags(), 0U);
}

TEST_F(IidcRegisters, FeaturesThatThereAre)
{
  EXPECT_EQ(read(0x404), 0xD1890000U);
  EXPECT_EQ(read(0x408), 0x40000000U);
  EXPECT_EQ(read(0x51C), 0xCF0013E8U); // shutter: 1 to 1000, with an absolute value
  EXPECT_EQ(read(0x584), 0x8F000002U); // pan
  EXPECT_TRUE(read(0x530) & 0x00010000U);
}

TEST_F(IidcRegisters, ValueAndAbsoluteValueFollowEachOther)
{
  const std::uint32_t csr = follow(0x700 + 4 * Shutter);
  EXPECT_FLOAT_EQ(floatOf(read(csr)), 0.0001F);
  EXPECT_FLOAT_EQ(floatOf(read(csr + 4)), 0.1F);
  write(0x81C, 0x82000000 | 1000);
  EXPECT_FLOAT_EQ(floatOf(read(csr + 8)), 0.1F);
  write(csr + 8, bitsOf(0.05F));
  EXPECT_FLOAT_EQ(floatOf(read(csr + 8)), 0.1F); // not active
  write(0x81C, 0xC2000000);
  write(csr + 8, bitsOf(0.05F));
  EXPECT_NEAR(read(0x81C) & 0xFFF, 500, 2);
  for (const float wild : {1e30F, -1.0F, std::numeric_limits<float>::quiet_NaN()}) {
    write(csr + 8, bitsOf(wild));
    const float kept = floatOf(read(csr + 8));
    EXPECT_TRUE(kept >= 0.0001F && kept <= 0.1F) << wild;
  }
}

TEST_F(IidcRegisters, VendorRegistersAskForTheirKey)
{
  EXPECT_EQ(follow(0x480), 0x1000U);
  EXPECT_EQ(read(0x1040), 0x59595959U);
  write(0x12F8, 0x80000040);
  EXPECT_EQ(read(0x12F8), 0x83FF0000U);
  write(0x1000, 0x00B09D00);
  write(0x1004, 0x0005FFFF);
  write(0x12F8, 0x80000040);
  EXPECT_EQ(read(0x12F8), 0x83FF0000U);
  write(0x1004, 0x0004FFFF);
  write(0x12F8, 0x80000040);
  EXPECT_EQ(read(0x12F8), 0x83FF0040U);
  write(0x1048, 1);
  EXPECT_EQ(read(0x1048), 0x80000001U);
}

TEST_F(IidcRegisters, GarbageOnDemand)
{
  camera_.faults().overrideRegister(0x404, 17);
  EXPECT_EQ(read(0x404), 17U);
  camera_.faults().heal();
  camera_.faults().overrideAllRegisters(5);
  EXPECT_NE(read(0x404), read(0x404));
  camera_.faults().heal();
  EXPECT_EQ(read(0x404), 0xD1890000U);
  for (const RomFault fault : {RomFault::Cut,
                               RomFault::Zero,
                               RomFault::WrongBus,
                               RomFault::FarUnit,
                               RomFault::FarLeaves,
                               RomFault::HugeLeaf,
                               RomFault::Endless}) {
    camera_.faults().breakRom(fault);
    std::vector<std::uint32_t> rom;
    while (const auto quadlet = camera_.read(config_rom + 4 * rom.size()))
      rom.push_back(*quadlet);
    EXPECT_NE(rom, configRomOf({}));
  }
}

} // namespace
} // namespace pcl::acmap::test
