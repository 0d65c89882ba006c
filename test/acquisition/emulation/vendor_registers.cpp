#include "vendor_registers.h"

#include "iidc_addresses.h"

#include <array>
#include <stdexcept>

namespace pcl::acmap::test {
namespace {

using namespace iidc;

constexpr std::uint32_t frame_info_bits = 0x000003FF;

// The identifier 0x00B09D000004 in two registers. The low half of the second one is a
// timeout for the lock, which this camera ignores: the lock stays open.
constexpr std::uint32_t key_high = 0x00B09D00;
constexpr std::uint32_t key_low = 0x0004;

/** \brief What FRAME_INFO embeds, starting with bit 31 (the least significant). */
enum Embedded {
  TimeStamp,
  GainOf,
  ShutterOf,
  BrightnessOf,
  ExposureOf,
  White,
  Counter
};

std::uint32_t
quadletOf(const std::string& tiles)
{
  if (tiles.size() != 4)
    throw std::invalid_argument("a Bayer pattern has four letters");
  std::uint32_t quadlet = 0;
  for (const char tile : tiles)
    quadlet = quadlet << 8 | static_cast<unsigned char>(tile);
  return quadlet;
}

} // namespace

VendorRegisters::VendorRegisters(RegisterMap& registers,
                                 const std::string& tiles,
                                 bool locked)
: registers_(registers)
, locked_(locked)
{
  registers_.fix(advanced_csr, (command_base + advanced_base) / 4);
  registers_.keep(access_high, 0);
  registers_.keep(access_low, 0);
  registers_.fix(bayer_tiles, quadletOf(tiles));
  registers_.keep(image_data_format, present, 1);
  registers_.keep(frame_info, present | frame_info_bits << 16, frame_info_bits);
}

bool
VendorRegisters::lets(std::uint32_t offset) const
{
  const bool advanced = offset >= advanced_base && offset < format7_base;
  return !locked_ || !advanced || offset == access_high || offset == access_low;
}

void
VendorRegisters::written(std::uint32_t offset)
{
  if (offset == access_low && registers_.at(access_high) == key_high)
    locked_ = locked_ && registers_.at(access_low) >> 16 != key_low;
}

void
VendorRegisters::embed(std::vector<std::uint8_t>& image,
                       std::uint32_t cycle,
                       std::uint32_t number) const
{
  std::array<std::uint32_t, 10> values{};
  values[TimeStamp] = cycle;
  values[GainOf] = registers_.at(feature_status + 4 * Gain);
  values[ShutterOf] = registers_.at(feature_status + 4 * Shutter);
  values[BrightnessOf] = registers_.at(feature_status + 4 * Brightness);
  values[ExposureOf] = registers_.at(feature_status + 4 * AutoExposure);
  values[White] = registers_.at(feature_status + 4 * WhiteBalance);
  values[Counter] = number;
  std::size_t at = 0;
  for (std::size_t bit = 0; bit < values.size(); ++bit)
    if (registers_.at(frame_info) >> bit & 1)
      for (int shift = 24; shift >= 0 && at < image.size(); shift -= 8)
        image[at++] = static_cast<std::uint8_t>(values[bit] >> shift);
}

} // namespace pcl::acmap::test
