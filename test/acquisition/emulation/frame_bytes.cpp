#include "frame_bytes.h"

#include <cstddef>

namespace pcl::acmap::test {

std::vector<std::uint8_t>
interleaved(const TrinocularFrame& frame, const ChannelOrder& order)
{
  std::vector<std::uint8_t> bytes(3 * frame.image(order[0]).values.size());
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const std::vector<std::uint8_t>& values = frame.image(order[channel]).values;
    for (std::size_t i = 0; i < values.size(); ++i)
      bytes.at(3 * i + channel) = values[i];
  }
  return bytes;
}

CameraImage
mosaicOf(const CameraImage& colour, const std::string& tiles)
{
  const std::string channels = "RGB";
  CameraImage mosaic{colour.width, colour.height, 1, {}};
  mosaic.values.reserve(colour.values.size() / 3);
  for (std::int32_t y = 0; y < colour.height; ++y)
    for (std::int32_t x = 0; x < colour.width; ++x) {
      const std::size_t channel = channels.find(tiles.at(2 * (y % 2) + x % 2));
      const auto pixel = static_cast<std::size_t>(y) * colour.width + x;
      mosaic.values.push_back(colour.values.at(3 * pixel + channel));
    }
  return mosaic;
}

} // namespace pcl::acmap::test
