#include "lamp.h"

#include <utility>

namespace pcl::acmap::test {

Lamp::Lamp(std::shared_ptr<LightClock> light)
: light_(std::move(light))
{}

void
Lamp::show(const RgbImage& image)
{
  cast(image.values.at(0));
}

void
Lamp::showNothing()
{
  cast(0);
}

void
Lamp::cast(int level)
{
  before(level);
  light_->change(power * level);
  const std::lock_guard lock(mutex_);
  shown_.push_back(level);
}

std::vector<int>
Lamp::shown() const
{
  const std::lock_guard lock(mutex_);
  return shown_;
}

RgbImage
flatImage(int level)
{
  return {4, 2, std::vector<std::uint8_t>(24, static_cast<std::uint8_t>(level))};
}

std::vector<RgbImage>
levelPatterns(int count)
{
  std::vector<RgbImage> patterns;
  for (int i = 1; i <= count; ++i)
    patterns.push_back(flatImage(40 * i));
  return patterns;
}

} // namespace pcl::acmap::test
