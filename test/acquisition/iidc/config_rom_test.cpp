#include "iidc/config_rom.h"

#include "thrown_faults.h"

#include <pcl/core/camera_exception.h>
#include <pcl/core/random.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <vector>

namespace pcl::acmap::test {
namespace {

using testing::AllOf;
using testing::Each;
using testing::Ge;
using testing::HasSubstr;
using testing::Le;
using Quadlets = std::vector<std::uint32_t>;

// Indices in the table below.
constexpr std::size_t root = 5;
constexpr std::size_t unit_entry = 7;
constexpr std::size_t unit = 8;
constexpr std::size_t specification_entry = 9;
constexpr std::size_t details_entry = 11;
constexpr std::size_t details = 12;
constexpr std::size_t registers_entry = 13;
constexpr std::size_t model_entry = 15;
constexpr std::size_t maker_leaf = 17;
constexpr std::size_t maker_text = 20;
constexpr std::size_t model_leaf = 23;

/** The configuration ROM of a camera as defined by IEEE 1212 and IIDC 1.31. */
Quadlets
cameraRom()
{
  return {
      0x04040000, 0x31333934, 0xE0FF8102, 0x00B09D01, 0x00C0FFEE, // bus
      0x00020000, 0x0300B09D, 0xD1000001,                         // root
      0x00030000, 0x1200A02D, 0x13000102, 0xD4000001,             // unit
      0x00040000, 0x403C0000, 0x81000003, 0x82000008, 0x38000010, // details
      0x00050000, 0x00000000, 0x00000000, 0x506F696E, 0x74204772, 0x65790000,
      0x00050000, 0x00000000, 0x00000000, 0x44696769, 0x636C6F70, 0x73202000,
  };
}

ConfigRom
read(const Quadlets& quadlets)
{
  return readConfigRom(
      [&](std::size_t i) { return i < quadlets.size() ? quadlets[i] : 0; });
}

/** The error for a ROM in which one quadlet is replaced. */
std::string
faultWith(std::size_t index, std::uint32_t quadlet)
{
  Quadlets quadlets = cameraRom();
  quadlets.at(index) = quadlet;
  std::string message = "none";
  const CameraFault fault = faultOf([&] { read(quadlets); }, &message);
  EXPECT_TRUE(fault == CameraFault::Malformed || fault == CameraFault::None);
  return message;
}

TEST(ConfigRom, TellsWhoTheCameraIs)
{
  const ConfigRom rom = read(cameraRom());
  EXPECT_EQ(0x00B09D0100C0FFEEu, rom.guid);
  EXPECT_EQ("00b09d0100c0ffee", textOfGuid(rom.guid));
  EXPECT_EQ(specified_by_trade, rom.specification);
  EXPECT_EQ(0x102u, rom.version);
  EXPECT_EQ(0x10u, rom.sub_version);
  EXPECT_EQ(0xFFFFF0F00000u, rom.registers);
  EXPECT_EQ("Point Grey", rom.maker);
  EXPECT_EQ("Digiclops", rom.model);
}

TEST(ConfigRom, NeedsNoNamesAndNoSubVersion)
{
  Quadlets quadlets = cameraRom();
  quadlets[details] = 0x00010000;
  const ConfigRom rom = read(quadlets);
  EXPECT_EQ("", rom.maker);
  EXPECT_EQ("", rom.model);
  EXPECT_EQ(0u, rom.sub_version);
}

TEST(ConfigRom, TakesPointGreysOwnSpecification)
{
  Quadlets quadlets = cameraRom();
  quadlets[specification_entry] = 0x1200B09D;
  EXPECT_EQ(specified_by_point_grey, read(quadlets).specification);
}

TEST(ConfigRom, FindsTheCameraAmongOtherUnits)
{
  Quadlets quadlets = cameraRom();
  quadlets[unit_entry - 1] = 0xD1000018; // another unit, of a disk, at the end
  quadlets.insert(quadlets.end(), {0, 0x00010000, 0x1200609E});
  EXPECT_EQ("Digiclops", read(quadlets).model);
}

TEST(ConfigRom, MakesNamesPrintable)
{
  Quadlets quadlets = cameraRom();
  quadlets[maker_text] = 0x201B5B41; // a space, then a terminal escape sequence
  quadlets[maker_text + 1] = 0xFF0A2020;
  quadlets[maker_text + 2] = 0x20000041;
  EXPECT_EQ("?[A??", read(quadlets).maker);
  quadlets[maker_text] = 0x20202020;
  quadlets[maker_text + 1] = 0;
  EXPECT_EQ("", read(quadlets).maker);
}

TEST(ConfigRom, NamesWhatCannotBe)
{
  EXPECT_EQ("none", faultWith(2, 0)); // the original ROM is valid
  EXPECT_THAT(faultWith(0, 0x01040000), HasSubstr("does not begin as one"));
  EXPECT_THAT(faultWith(1, 0x34393331), HasSubstr("does not begin as one"));
  EXPECT_THAT(faultWith(0, 0xFF000000), HasSubstr("root directory begins behind"));
  EXPECT_THAT(faultWith(root, 0xFFFF0000), HasSubstr("root directory ends behind"));
  EXPECT_THAT(faultWith(root, 251u << 16), HasSubstr("root directory ends behind"));
  EXPECT_THAT(faultWith(root, 0), HasSubstr("no unit that is a camera"));
  EXPECT_THAT(faultWith(unit_entry, 0xD1000000), HasSubstr("unit is in itself"));
  EXPECT_THAT(faultWith(unit_entry, 0xD1FFFFFF), HasSubstr("unit begins behind"));
  EXPECT_THAT(faultWith(unit, 0x01000000), HasSubstr("unit ends behind"));
  EXPECT_THAT(faultWith(specification_entry, 0x1200609E), HasSubstr("no unit"));
  EXPECT_THAT(faultWith(details_entry, 0), HasSubstr("where its registers are"));
  EXPECT_THAT(faultWith(details_entry, 0xD4000000), HasSubstr("details is in itself"));
  EXPECT_THAT(faultWith(details_entry, 0xD4000100), HasSubstr("details begins"));
  EXPECT_THAT(faultWith(registers_entry, 0), HasSubstr("where its registers are"));
  EXPECT_THAT(faultWith(registers_entry, 0x40000100), HasSubstr("those of the bus"));
  EXPECT_THAT(faultWith(maker_leaf, 0x00010000), HasSubstr("maker is too short"));
  EXPECT_THAT(faultWith(maker_leaf, 0x00FF0000), HasSubstr("maker ends behind"));
  EXPECT_THAT(faultWith(model_entry, 0x82FFFFFF), HasSubstr("model begins behind"));
  EXPECT_THAT(faultWith(model_leaf, 0), HasSubstr("model is too short"));
}

/** The fault that is reported if the unit directory cannot be read. */
CameraFault
faultAfter(CameraFault fault)
{
  const auto faulty = [fault](std::size_t index) -> std::uint32_t {
    if (index > unit)
      throw CameraException(fault, "of the bus");
    return cameraRom()[index];
  };
  return faultOf([&] { readConfigRom(faulty); });
}

TEST(ConfigRom, PassesOnWhatReadingThrows)
{
  EXPECT_EQ(CameraFault::Unplugged, faultAfter(CameraFault::Unplugged));
  EXPECT_EQ(CameraFault::Silent, faultAfter(CameraFault::Silent));
  EXPECT_EQ(CameraFault::Malformed, faultAfter(CameraFault::Unsupported)) << "its end";
}

/** Reads a ROM and checks the result; returns true if it was accepted as a camera. */
bool
isTaken(const Quadlets& quadlets)
{
  std::map<std::size_t, int> reads;
  bool is_taken = true;
  try {
    const ConfigRom rom = readConfigRom([&](std::size_t index) {
      EXPECT_LT(index, config_rom_quadlets);
      ++reads[index];
      return quadlets.at(index);
    });
    EXPECT_GT(rom.registers, config_rom_address);
    EXPECT_THAT(rom.maker + rom.model, Each(AllOf(Ge(' '), Le('~'))));
  }
  catch (const CameraException& exception) {
    EXPECT_EQ(CameraFault::Malformed, exception.fault());
    is_taken = false;
  }
  for (const auto& [index, count] : reads)
    EXPECT_EQ(1, count) << "quadlet " << index;
  return is_taken;
}

TEST(ConfigRom, ReadsGarbageOnceAndNotBeyondItsEnd)
{
  Random random(1);
  int taken = 0;
  constexpr int runs = 20000;
  for (int run = 0; run < runs; ++run) {
    Quadlets quadlets = cameraRom();
    while (quadlets.size() < config_rom_quadlets)
      quadlets.push_back(static_cast<std::uint32_t>(random.bits()));
    // flips a few bits of the camera's entries, so that different branches are tested
    for (int i = 0; i < 4; ++i)
      quadlets[random.bits() % 29] ^= 1u << random.bits() % 32;
    taken += isTaken(quadlets) ? 1 : 0;
  }
  EXPECT_GT(taken, runs / 10);
  EXPECT_LT(taken, runs * 9 / 10);
}

TEST(ConfigRom, TakesNoGarbageForACamera)
{
  Random random(2);
  for (int run = 0; run < 2000; ++run) {
    Quadlets quadlets(config_rom_quadlets);
    for (std::uint32_t& quadlet : quadlets)
      quadlet = static_cast<std::uint32_t>(random.bits());
    EXPECT_FALSE(isTaken(quadlets));
  }
  EXPECT_FALSE(isTaken(Quadlets(config_rom_quadlets, 0)));
  EXPECT_FALSE(isTaken(Quadlets(config_rom_quadlets, ~0u)));
}

} // namespace
} // namespace pcl::acmap::test
