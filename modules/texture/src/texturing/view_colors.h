#pragma once

#include <pcl/texture/texturing_kernel.h>

#include <array>

namespace pcl::acmap::texturing {

using Rgb = std::array<std::uint8_t, 3>;

/** Unpacks the colour of a point of a view. */
inline Rgb
colorOf(const ColoredView& view, std::size_t i)
{
  std::uint32_t packed;
  const auto place = static_cast<std::size_t>(view.points.index(i));
  std::memcpy(&packed,
              static_cast<const char*>(view.colors.first) + view.colors.stride * place,
              sizeof packed);
  return {static_cast<std::uint8_t>(packed >> 16),
          static_cast<std::uint8_t>(packed >> 8),
          static_cast<std::uint8_t>(packed)};
}

} // namespace pcl::acmap::texturing
