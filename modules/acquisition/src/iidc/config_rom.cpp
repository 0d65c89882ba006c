#include "config_rom.h"

#include <pcl/core/camera_exception.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace pcl::acmap {

namespace {

constexpr std::uint32_t name_of_bus = 0x31333934; // "1394"
constexpr std::uint32_t min_bus_information = 4;
constexpr std::uint64_t address_space = 0xFFFFF0000000;
constexpr std::uint32_t first_unit_quadlet = 0x200; // those of the bus are below it

enum Key : std::uint32_t {
  SpecificationKey = 0x12,
  VersionKey = 0x13,
  SubVersionKey = 0x38,
  RegistersKey = 0x40,
  MakerKey = 0x81,
  ModelKey = 0x82,
  UnitKey = 0xD1,
  UnitDependentKey = 0xD4
};

[[noreturn]] void
fail(const std::string& what)
{
  throw CameraException(CameraFault::Malformed, "configuration ROM: " + what);
}

/** \brief An entry of a directory: a number, or the offset of another block. */
struct RomEntry {
  std::size_t index;
  std::uint32_t key;
  std::uint32_t value;
};

using Directory = std::vector<RomEntry>;

class Rom {
public:
  explicit Rom(const RomQuadlet& read)
  : read_(read)
  {}

  std::uint32_t
  at(std::size_t index)
  {
    auto& quadlet = quadlets_.at(index);
    try {
      if (!quadlet)
        quadlet = read_(index);
    }
    catch (const CameraException& exception) {
      if (exception.fault() == CameraFault::Unsupported)
        fail("it ends too early"); // the camera has no register at this address
      throw;
    }
    return *quadlet;
  }

  /** \brief Length of the block that begins at index; it is verified to be inside the
   * ROM. */
  std::size_t
  lengthOf(std::size_t index, const std::string& name)
  {
    if (index >= config_rom_quadlets)
      fail(name + " begins behind the end");
    const std::size_t length = at(index) >> 16;
    if (length >= config_rom_quadlets - index)
      fail(name + " ends behind the end");
    return length;
  }

  Directory
  directory(std::size_t index, const std::string& name)
  {
    const std::size_t length = lengthOf(index, name);
    Directory entries;
    for (std::size_t i = index + 1; i <= index + length; ++i)
      entries.push_back({i, at(i) >> 24, at(i) & 0xFFFFFF});
    return entries;
  }

private:
  const RomQuadlet& read_;
  std::array<std::optional<std::uint32_t>, config_rom_quadlets> quadlets_;
};

const RomEntry*
find(const Directory& directory, std::uint32_t key)
{
  for (const RomEntry& entry : directory)
    if (entry.key == key)
      return &entry;
  return nullptr;
}

/** \brief Index of the block to which an entry points. All offsets are positive,
 * therefore reading cannot end in a cycle. */
std::size_t
targetOf(const RomEntry& entry, const std::string& name)
{
  if (entry.value == 0)
    fail(name + " is in itself");
  return entry.index + entry.value;
}

/** \brief The text of a leaf; the first two quadlets contain its type and language. */
std::string
textOf(Rom& rom, const Directory& directory, std::uint32_t key, const std::string& name)
{
  const RomEntry* entry = find(directory, key);
  if (!entry)
    return "";
  const std::size_t leaf = targetOf(*entry, name);
  const std::size_t length = rom.lengthOf(leaf, name);
  if (length < 2)
    fail(name + " is too short");
  std::string text;
  for (std::size_t i = 3; i <= length; ++i)
    for (int shift = 24; shift >= 0; shift -= 8)
      text += static_cast<char>(rom.at(leaf + i) >> shift & 0xFF);
  text.resize(std::min(text.find('\0'), text.size()));
  for (char& letter : text)
    letter = letter >= ' ' && letter <= '~' ? letter : '?';
  text.resize(text.find_last_not_of(' ') + 1);
  return text.substr(std::min(text.find_first_not_of(' '), text.size()));
}

bool
isCamera(const Directory& unit)
{
  const RomEntry* specification = find(unit, SpecificationKey);
  return specification && (specification->value == specified_by_trade ||
                           specification->value == specified_by_point_grey);
}

Directory
cameraUnit(Rom& rom)
{
  const std::size_t bus_information = rom.at(0) >> 24;
  if (bus_information < min_bus_information || rom.at(1) != name_of_bus)
    fail("it does not begin as one");
  for (const RomEntry& entry : rom.directory(bus_information + 1, "root directory"))
    if (entry.key == UnitKey) {
      Directory unit = rom.directory(targetOf(entry, "unit"), "unit");
      if (isCamera(unit))
        return unit;
    }
  fail("it has no unit that is a camera");
}

} // namespace

ConfigRom
readConfigRom(const RomQuadlet& read)
{
  Rom rom(read);
  const Directory unit = cameraUnit(rom);
  ConfigRom result;
  result.guid = std::uint64_t{rom.at(3)} << 32 | rom.at(4);
  result.specification = find(unit, SpecificationKey)->value;
  if (const RomEntry* version = find(unit, VersionKey))
    result.version = version->value;

  const RomEntry* details = find(unit, UnitDependentKey);
  if (!details)
    fail("the unit does not say where its registers are");
  const Directory own = rom.directory(targetOf(*details, "details"), "details");
  const RomEntry* registers = find(own, RegistersKey);
  if (!registers)
    fail("the unit does not say where its registers are");
  if (registers->value < first_unit_quadlet)
    fail("the unit's registers are among those of the bus");
  result.registers = address_space + std::uint64_t{registers->value} * 4;
  if (const RomEntry* sub_version = find(own, SubVersionKey))
    result.sub_version = sub_version->value;
  result.maker = textOf(rom, own, MakerKey, "name of the maker");
  result.model = textOf(rom, own, ModelKey, "name of the model");
  return result;
}

std::string
textOfGuid(std::uint64_t guid)
{
  std::string text(16, '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, guid >>= 4)
    *digit = "0123456789abcdef"[guid & 0xF];
  return text;
}

} // namespace pcl::acmap
