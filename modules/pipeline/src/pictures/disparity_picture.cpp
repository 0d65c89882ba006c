#include <pcl/pipeline/disparity_picture.h>

#include <algorithm>
#include <cmath>

namespace pcl {

std::vector<std::uint8_t>
disparityPicture(const DisparityImage& disparities)
{
  constexpr float darkest = 64; // clearly distinct from black
  constexpr float brightest = 255;
  constexpr float min_range = 1e-6F; // px
  std::vector<std::uint8_t> greys(disparities.values.size(), 0);
  std::vector<float> found;
  for (const float disparity : disparities.values)
    if (std::isfinite(disparity))
      found.push_back(disparity);
  if (found.empty())
    return greys;
  std::sort(found.begin(), found.end());
  const std::size_t cut = found.size() / 100;
  const float minimum = found[cut];
  const float range = std::max(found[found.size() - 1 - cut] - minimum, min_range);
  for (std::size_t i = 0; i < greys.size(); ++i) {
    const float disparity = disparities.values[i];
    if (!std::isfinite(disparity))
      continue;
    const float share = std::clamp((disparity - minimum) / range, 0.0F, 1.0F);
    greys[i] =
        static_cast<std::uint8_t>(std::lround(darkest + share * (brightest - darkest)));
  }
  return greys;
}

} // namespace pcl
