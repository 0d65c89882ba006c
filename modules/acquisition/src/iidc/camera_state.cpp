#include "camera_state.h"
#include "camera_modes.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pcl::acmap {

namespace {

bool
isSame(const IidcMode& a, const IidcMode& b)
{
  return a.format == b.format && a.mode == b.mode && a.color == b.color &&
         a.width == b.width && a.height == b.height;
}

/** Converts the four letters of a register to the name of a filter; empty if they are
 * not one. */
std::string
filterOf(std::uint32_t letters)
{
  constexpr std::array<const char*, 5> filters = {
      "RGGB", "GBRG", "GRBG", "BGGR", "YYYY"};
  std::string text;
  for (int shift = 24; shift >= 0; shift -= 8)
    text.push_back(static_cast<char>((letters >> shift) & 0xFF));
  return std::find(filters.begin(), filters.end(), text) != filters.end() ? text : "";
}

/** Unlocks the advanced registers, which Point Grey's cameras accept only after their
 * identifier was written. */
void
unlockAdvanced(const RegisterAccess& camera, std::uint32_t basic)
{
  if ((basic & iidc::basic::advanced) == 0)
    return;
  const auto access = camera.behind(iidc::advanced_features);
  if (!access)
    return;
  try {
    access->write(iidc::access_name_high, iidc::point_grey_high);
    access->write(iidc::access_name_low, iidc::point_grey_low);
  }
  catch (const CameraException& exception) {
    if (exception.fault() != CameraFault::Unsupported)
      throw;
  }
}

/** Sets a value that was in range before: if it no longer is, the camera is faulty. */
void
setAgain(const RegisterAccess& camera,
         IidcFeature feature,
         const FeatureSetting& setting)
{
  try {
    writeFeature(camera, feature, setting);
  }
  catch (const BadArgumentException& exception) {
    throw CameraException(CameraFault::Malformed,
                          camera.place() + ": has other limits than before" +
                              exception.what());
  }
}

/** Enables the frame counter. \return true if the camera writes only its counter into
 * the frames */
bool
switchCounterOn(const RegisterAccess& camera)
{
  if ((camera.tryRead(iidc::frame_info).value_or(0) & iidc::on) == 0)
    return false;
  try {
    camera.write(iidc::frame_info, iidc::on | iidc::frame_counter);
  }
  catch (const CameraException& exception) {
    if (exception.fault() != CameraFault::Unsupported)
      throw;
    return false;
  }
  // Any other embedded information would precede the counter.
  constexpr std::uint32_t insertions = 0x000003FF;
  const std::uint32_t info = camera.tryRead(iidc::frame_info).value_or(0);
  return (info & iidc::on) != 0 && (info & insertions) == iidc::frame_counter;
}

} // namespace

CameraState::CameraState(IidcBusOpener opener)
: opener_(std::move(opener))
{}

void
CameraState::open()
{
  std::shared_ptr<IidcBus> bus = opener_();
  identify(*bus);
  exchangeBus(std::move(bus));
  try {
    wake();
    applyMode();
    const RegisterAccess camera = registers();
    for (const auto& [feature, setting] : wanted.features)
      setAgain(camera, feature, setting);
    writeTrigger(camera, wanted.trigger); // another program may have enabled it
  }
  catch (...) {
    exchangeBus(nullptr);
    throw;
  }
}

bool
CameraState::isOpen() const
{
  const std::lock_guard lock(bus_mutex_);
  return bus_ != nullptr;
}

std::shared_ptr<IidcBus>
CameraState::requireBus() const
{
  const std::lock_guard lock(bus_mutex_);
  if (!bus_)
    throw CameraException(CameraFault::Failed, "the camera is not open");
  return bus_;
}

std::shared_ptr<IidcBus>
CameraState::exchangeBus(std::shared_ptr<IidcBus> other)
{
  const std::lock_guard lock(bus_mutex_);
  return std::exchange(bus_, std::move(other));
}

RegisterAccess
CameraState::registers() const
{
  return {requireBus(), rom.registers};
}

void
CameraState::identify(IidcBus& bus)
{
  const ConfigRom found = readConfigRom(bus);
  if (rom.guid != 0 && rom.guid != found.guid)
    throw CameraException(CameraFault::NotFound,
                          bus.place() + ": is camera " + textOfGuid(found.guid) +
                              ", not " + textOfGuid(rom.guid));
  rom = found;
  place = bus.place();
}

/** Brings the camera into a defined state, independent of the state in which another
 * program left it. */
void
CameraState::wake()
{
  const RegisterAccess camera = registers();
  const std::uint32_t basic = camera.tryRead(iidc::basic_functions).value_or(0);
  if ((basic & iidc::basic::power_switch) != 0)
    camera.write(iidc::power, iidc::on);
  camera.write(iidc::iso_enable, 0);
  has_one_shot = (basic & iidc::basic::one_shot) != 0;
  modes = listModes(camera);
  unlockAdvanced(camera, basic);
  has_counter = switchCounterOn(camera);
}

/** Sets the rate by the frame rate feature, which is more precise than the packet size.
 * \return 0 if the camera does not have the feature */
float
CameraState::applyRate(const RegisterAccess& camera) const
{
  const IidcFeatureState rate = readFeature(camera, IidcFeature::FrameRate);
  constexpr float min_rate = 1e-3F; // Hz, the smallest rate that setMode accepts
  if (!rate.physical || !rate.can_be_set || rate.physical->maximum < min_rate)
    return 0;
  const float possible =
      std::clamp(wanted.rate, rate.physical->minimum, rate.physical->maximum);
  setAgain(camera, IidcFeature::FrameRate, PhysicalSetting{possible});
  return possible;
}

void
CameraState::applyMode()
{
  if (!wanted.mode)
    return;
  const auto mode = std::find_if(modes.begin(), modes.end(), [&](const auto& known) {
    return isSame(known, *wanted.mode);
  });
  if (mode == modes.end())
    throw CameraException(CameraFault::Unsupported,
                          place + ": has no mode " + wanted.mode->text());
  const RegisterAccess camera = registers();
  // Speed 2 is 400 Mb/s; it has no meaning for USB.
  camera.write(iidc::iso_channel, std::uint32_t{2} << 24);
  if (mode->format != scalable_format) {
    stream = setFixedMode(camera, *mode, wanted.rate);
    return;
  }
  stream = setScalableMode(camera, *mode, 0);
  const float rate = applyRate(camera);
  if (rate > 0)
    stream.rate = std::min(stream.rate, rate);
  else
    stream = setScalableMode(camera, *mode, wanted.rate);
}

ConfigRom
readConfigRom(IidcBus& bus)
{
  return readConfigRom([&](std::size_t index) {
    return bus.readQuadlet(config_rom_address + 4 * index);
  });
}

std::string
versionText(const ConfigRom& rom)
{
  if (rom.specification == specified_by_point_grey)
    return "Point Grey";
  switch (rom.version) {
  case 0x100:
    return "1.04";
  case 0x101:
    return "1.20";
  case 0x102:
    return "1.3" + std::to_string(rom.sub_version >> 4);
  default:
    return "unknown";
  }
}

std::string
colorFilterOf(const CameraState& state)
{
  const RegisterAccess camera = state.registers();
  std::string filter = filterOf(camera.tryRead(iidc::bayer_tile_mapping).value_or(0));
  const auto& mode = state.wanted.mode;
  const bool is_raw =
      mode && (mode->color == IidcColor::Raw8 || mode->color == IidcColor::Raw16);
  if (filter.empty() && is_raw && mode->format == scalable_format)
    filter = scalableColorFilter(camera, *mode);
  return filter.empty() ? "YYYY" : filter;
}

} // namespace pcl::acmap
