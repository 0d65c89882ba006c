#include "feature_registers.h"

#include <pcl/core/impl/arguments.h>

#include <cmath>
#include <cstring>

namespace pcl::acmap {

namespace {

/** Offsets of the registers of a physical value: minimum, maximum and current value. */
constexpr std::uint64_t physical_minimum = 0;
constexpr std::uint64_t physical_maximum = 4;
constexpr std::uint64_t physical_now = 8;

std::uint64_t
registerOf(std::uint64_t table, IidcFeature feature)
{
  return table + 4 * static_cast<std::uint64_t>(feature);
}

float
floatOf(std::uint32_t bits)
{
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

std::uint32_t
bitsOf(float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

/** Returns nothing if the camera does not have these registers, or their values are not
 * valid numbers. */
std::optional<IidcFeatureState::Physical>
readPhysical(const RegisterAccess& camera, IidcFeature feature)
{
  const auto registers = camera.behind(registerOf(iidc::physical_value, feature));
  if (!registers)
    return std::nullopt;
  const IidcFeatureState::Physical physical{
      floatOf(registers->tryRead(physical_minimum).value_or(0)),
      floatOf(registers->tryRead(physical_maximum).value_or(0)),
      floatOf(registers->tryRead(physical_now).value_or(0))};
  if (!std::isfinite(physical.minimum) || !std::isfinite(physical.maximum) ||
      !std::isfinite(physical.value) || physical.minimum > physical.maximum)
    return std::nullopt;
  return physical;
}

const char*
unitOf(IidcFeature feature)
{
  switch (feature) {
  case IidcFeature::Shutter:
    return "s";
  case IidcFeature::Gain:
    return "dB";
  case IidcFeature::FrameRate:
    return "Hz";
  default:
    return "in the camera's unit";
  }
}

void
requireAble(const RegisterAccess& camera,
            IidcFeature feature,
            bool is_able,
            const char* what)
{
  if (!is_able)
    throw CameraException(CameraFault::Unsupported,
                          camera.place() + ": " + nameOf(feature) + " cannot be " +
                              what);
}

void
setAutomatic(const RegisterAccess& camera,
             IidcFeature feature,
             const IidcFeatureState& state)
{
  requireAble(camera, feature, state.can_be_automatic, "left to the camera");
  camera.write(registerOf(iidc::feature_status, feature),
               iidc::feature::is_there | iidc::feature::is_on |
                   iidc::feature::is_automatic | state.value);
}

void
setSteps(const RegisterAccess& camera,
         IidcFeature feature,
         const IidcFeatureState& state,
         unsigned value)
{
  requireAble(camera, feature, state.can_be_set, "set");
  requireInRange(nameOf(feature), value, state.minimum, state.maximum, "steps");
  const std::uint64_t status = registerOf(iidc::feature_status, feature);
  // White balance has a second value in the bits above, which must not change.
  const std::uint32_t second = feature == IidcFeature::WhiteBalance
                                   ? camera.read(status) & 0x00FFF000
                                   : std::uint32_t{0};
  camera.write(status, iidc::feature::is_there | iidc::feature::is_on | second | value);
}

void
setPhysical(const RegisterAccess& camera,
            IidcFeature feature,
            const IidcFeatureState& state,
            float value)
{
  const auto registers = camera.behind(registerOf(iidc::physical_value, feature));
  requireAble(camera,
              feature,
              state.can_be_set && state.physical.has_value() && registers.has_value(),
              "set in physical units");
  requireInRange(nameOf(feature),
                 value,
                 state.physical->minimum,
                 state.physical->maximum,
                 unitOf(feature));
  camera.write(registerOf(iidc::feature_status, feature),
               iidc::feature::is_there | iidc::feature::has_physical |
                   iidc::feature::is_on | state.value);
  registers->write(physical_now, bitsOf(value));
}

} // namespace

IidcFeatureState
readFeature(const RegisterAccess& camera, IidcFeature feature)
{
  using namespace iidc::feature;
  const std::uint32_t inquiry =
      camera.tryRead(registerOf(iidc::feature_inquiry, feature)).value_or(0);
  const std::uint32_t status =
      camera.tryRead(registerOf(iidc::feature_status, feature)).value_or(0);
  IidcFeatureState state;
  state.is_there = (inquiry & is_there) != 0 && (status & is_there) != 0;
  if (!state.is_there)
    return state;
  state.can_be_automatic = (inquiry & can_be_automatic) != 0;
  state.can_be_set = (inquiry & can_be_set) != 0;
  state.can_be_off = (inquiry & can_be_off) != 0;
  state.is_on = (status & is_on) != 0;
  state.is_automatic = (status & is_automatic) != 0;
  state.minimum = (inquiry >> 12) & value;
  state.maximum = inquiry & value;
  state.value = status & value;
  if ((inquiry & has_physical) != 0)
    state.physical = readPhysical(camera, feature);
  return state;
}

void
writeFeature(const RegisterAccess& camera,
             IidcFeature feature,
             const FeatureSetting& setting)
{
  const IidcFeatureState state = readFeature(camera, feature);
  if (!state.is_there)
    throw CameraException(CameraFault::Unsupported,
                          camera.place() + ": has no " + nameOf(feature));
  if (const auto* const steps = std::get_if<StepSetting>(&setting))
    setSteps(camera, feature, state, steps->value);
  else if (const auto* const physical = std::get_if<PhysicalSetting>(&setting))
    setPhysical(camera, feature, state, physical->value);
  else
    setAutomatic(camera, feature, state);
}

void
writeTrigger(const RegisterAccess& camera, IidcTrigger trigger)
{
  const bool is_external = trigger == IidcTrigger::External;
  const std::uint32_t inquiry = camera.tryRead(iidc::trigger_inquiry).value_or(0);
  if ((inquiry & iidc::feature::is_there) == 0) {
    if (is_external)
      throw CameraException(CameraFault::Unsupported,
                            camera.place() + ": has no trigger input");
    return;
  }
  camera.write(iidc::trigger_mode,
               iidc::feature::is_there |
                   (is_external ? iidc::feature::is_on : std::uint32_t{0}));
}

} // namespace pcl::acmap
