#include "shot_color.h"

#include <pcl/core/impl/parallel.h>

namespace pcl::acmap {

static_assert(ShotColor::max_images * 255 <= 65535);

ShotColor::ShotColor(int width, int height)
: width_(width)
, height_(height)
, sums_(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
{}

void
ShotColor::add(const CameraImage& image)
{
  const std::uint8_t* const from = image.values.data();
  const auto addTo = [&](std::size_t i, std::size_t value) {
    sums_[i] = static_cast<std::uint16_t>(sums_[i] + from[value]);
  };
  parallelForChunks(sums_.size() / 3, [&](std::size_t begin, std::size_t end) {
    if (image.channels == 3)
      for (std::size_t i = 3 * begin; i < 3 * end; ++i)
        addTo(i, i);
    else
      for (std::size_t i = 3 * begin; i < 3 * end; ++i)
        addTo(i, i / 3);
  });
  ++images_;
}

CameraImage
ShotColor::mean() const
{
  if (images_ == 0)
    return {};
  CameraImage image{width_, height_, 3, std::vector<std::uint8_t>(sums_.size())};
  for (std::size_t i = 0; i < sums_.size(); ++i)
    image.values[i] = static_cast<std::uint8_t>((sums_[i] + images_ / 2) / images_);
  return image;
}

} // namespace pcl::acmap
