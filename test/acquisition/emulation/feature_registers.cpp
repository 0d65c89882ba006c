#include "feature_registers.h"

#include "iidc_addresses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace pcl::acmap::test {
namespace {

using namespace iidc;

constexpr std::uint32_t has_absolute = 0x40000000;
constexpr std::uint32_t value_bits = 0x00000FFF;

struct FeatureShape {
  Feature feature;
  std::uint32_t minimum;
  std::uint32_t maximum;
  std::uint32_t value;
  float absolute_minimum; ///< equal to absolute_most if there is no absolute value
  float absolute_maximum;
};

constexpr std::array<FeatureShape, 6> shapes = {{
    {Brightness, 0, 255, 0, 0.0F, 6.25F},
    {AutoExposure, 0, 1023, 500, -7.5F, 2.5F},
    {Shutter, 1, 1000, 100, 0.0001F, 0.1F},
    {Gain, 16, 683, 16, 0.0F, 24.0F},
    {FrameRate, 1, 1000, 1000, 0.03F, 30.0F},
    {Pan, 0, 2, 0, 0.0F, 0.0F},
}};

bool
hasAbsolute(const FeatureShape& shape)
{
  return shape.absolute_minimum < shape.absolute_maximum;
}

/** \brief Offset of a feature in tables that have the low half 0x80 after the high
 * one. */
constexpr std::uint32_t
place(Feature feature)
{
  return 4 * feature;
}

constexpr std::uint32_t
absoluteOf(Feature feature)
{
  return absolute_base + 16 * feature;
}

std::uint32_t
bitsOf(float value)
{
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

float
floatOf(std::uint32_t bits)
{
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

float
absoluteValue(const FeatureShape& shape, std::uint32_t value)
{
  const float part = static_cast<float>(value - shape.minimum) /
                     static_cast<float>(shape.maximum - shape.minimum);
  return shape.absolute_minimum +
         part * (shape.absolute_maximum - shape.absolute_minimum);
}

std::uint32_t
wholeValue(const FeatureShape& shape, float absolute)
{
  const float part = (absolute - shape.absolute_minimum) /
                     (shape.absolute_maximum - shape.absolute_minimum);
  return shape.minimum + static_cast<std::uint32_t>(std::lround(
                             part * static_cast<float>(shape.maximum - shape.minimum)));
}

void
addFeature(RegisterMap& registers, const FeatureShape& shape)
{
  const std::uint32_t at = place(shape.feature);
  const std::uint32_t absolute = hasAbsolute(shape) ? has_absolute : 0;
  // Readable, can be switched on and off, automatic and manual.
  registers.fix(feature_inquiry + at,
                present | absolute | 0x0F000000 | shape.minimum << 12 | shape.maximum);
  registers.keep(feature_status + at,
                 present | feature_on | shape.value,
                 absolute | feature_on | feature_auto | value_bits);
  if (!absolute)
    return;
  const std::uint32_t csr = absoluteOf(shape.feature);
  registers.fix(absolute_csr + at, (command_base + csr) / 4);
  registers.fix(csr, bitsOf(shape.absolute_minimum));
  registers.fix(csr + 4, bitsOf(shape.absolute_maximum));
  registers.keep(csr + 8, bitsOf(absoluteValue(shape, shape.value)));
}

} // namespace

FeatureRegisters::FeatureRegisters(RegisterMap& registers)
: registers_(registers)
{
  std::uint32_t high = 0x80000000U >> WhiteBalance | 0x80000000U >> Trigger;
  std::uint32_t low = 0;
  for (const FeatureShape& shape : shapes) {
    addFeature(registers_, shape);
    (shape.feature < 32 ? high : low) |= 0x80000000U >> (shape.feature % 32);
  }
  registers_.fix(features_high, high);
  registers_.fix(features_low, low);

  registers_.fix(feature_inquiry + place(WhiteBalance),
                 present | 0x0F000000 | 0U << 12 | 1023);
  registers_.keep(feature_status + place(WhiteBalance),
                  present | feature_on | 512U << 12 | 512,
                  feature_on | feature_auto | 0x00FFFFFF);
  // Trigger: polarity, source 0 and software, mode 0.
  registers_.fix(feature_inquiry + place(Trigger),
                 present | 0x0E000000 | 0x00810000 | 0x00008000);
  registers_.keep(feature_status + place(Trigger), present, 0x03FFFFFF);
}

void
FeatureRegisters::written(std::uint32_t offset)
{
  for (const FeatureShape& shape : shapes) {
    const std::uint32_t status = feature_status + place(shape.feature);
    const std::uint32_t value = absoluteOf(shape.feature) + 8;
    if (!hasAbsolute(shape) || (offset != status && offset != value))
      continue;
    const std::uint32_t state = registers_.at(status);
    // The active one of the two values determines the other.
    if (state & absolute_control) {
      float absolute = floatOf(registers_.at(value));
      if (!(absolute >= shape.absolute_minimum)) // also if it is NaN
        absolute = shape.absolute_minimum;
      absolute = std::min(absolute, shape.absolute_maximum);
      registers_.set(value, bitsOf(absolute));
      registers_.set(status, (state & ~value_bits) | wholeValue(shape, absolute));
    }
    else {
      const std::uint32_t whole =
          std::clamp(state & value_bits, shape.minimum, shape.maximum);
      registers_.set(status, (state & ~value_bits) | whole);
      registers_.set(value, bitsOf(absoluteValue(shape, whole)));
    }
  }
}

std::chrono::duration<double>
FeatureRegisters::shutter() const
{
  return std::chrono::duration<double>(floatOf(registers_.at(absoluteOf(Shutter) + 8)));
}

double
FeatureRegisters::frameRate() const
{
  if (!(registers_.at(feature_status + place(FrameRate)) & feature_on))
    return std::numeric_limits<double>::infinity();
  return floatOf(registers_.at(absoluteOf(FrameRate) + 8));
}

bool
FeatureRegisters::triggered() const
{
  return registers_.at(feature_status + place(Trigger)) & feature_on;
}

} // namespace pcl::acmap::test
