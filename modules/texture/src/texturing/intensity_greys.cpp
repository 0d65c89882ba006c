#include "texturing/intensity_greys.h"

#include <pcl/PCLPointField.h>
#include <pcl/core/impl/quantile.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace pcl::acmap::texturing {

namespace {

template <typename Value>
double
valueAt(const char* place)
{
  Value value;
  std::memcpy(&value, place, sizeof value);
  return static_cast<double>(value);
}

double
valueOf(const IntensityView& intensities, std::size_t i)
{
  const char* const place =
      static_cast<const char*>(intensities.first) + i * intensities.stride;
  switch (intensities.datatype) {
  case PCLPointField::INT8:
    return valueAt<std::int8_t>(place);
  case PCLPointField::UINT8:
    return valueAt<std::uint8_t>(place);
  case PCLPointField::INT16:
    return valueAt<std::int16_t>(place);
  case PCLPointField::UINT16:
    return valueAt<std::uint16_t>(place);
  case PCLPointField::INT32:
    return valueAt<std::int32_t>(place);
  case PCLPointField::UINT32:
    return valueAt<std::uint32_t>(place);
  case PCLPointField::FLOAT32:
    return valueAt<float>(place);
  case PCLPointField::FLOAT64:
    return valueAt<double>(place);
  default:
    return std::numeric_limits<double>::quiet_NaN();
  }
}

} // namespace

IntensityGreys::Scale
IntensityGreys::scaleOf(LargeVector<double> values)
{
  constexpr double bright_level = 230;
  values.erase(std::remove_if(values.begin(),
                              values.end(),
                              [](double value) { return !std::isfinite(value); }),
               values.end());
  if (values.empty())
    return {0, 0};
  const auto percentile = [&](std::size_t percent) {
    return valueOfRank(values, percent * (values.size() - 1) / 100);
  };
  const double black = std::min(0.0, percentile(1)), bright = percentile(99);
  return {black, bright > black ? bright_level / (bright - black) : 0};
}

LargeVector<std::uint32_t>
IntensityGreys::packed(const IntensityView& intensities, std::size_t count)
{
  LargeVector<double> values;
  values.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(valueOf(intensities, i));
  if (!scale_)
    scale_ = scaleOf(values);
  LargeVector<std::uint32_t> greys;
  greys.reserve(count);
  for (const double value : values) {
    const double level =
        std::isfinite(value) ? scale_->factor * (value - scale_->black) : 0.0;
    const auto grey =
        static_cast<std::uint32_t>(std::lround(std::clamp(level, 0.0, 255.0)));
    greys.push_back(grey << 16U | grey << 8U | grey);
  }
  return greys;
}

} // namespace pcl::acmap::texturing
