#include "fuzzed_points.h"

#include <algorithm>
#include <limits>

namespace pcl::acmap::test {
namespace {

using Limits = std::numeric_limits<float>;

constexpr float odd_values[] = {Limits::quiet_NaN(),
                                Limits::infinity(),
                                -Limits::infinity(),
                                Limits::max(),
                                -Limits::max(),
                                Limits::denorm_min(),
                                Limits::min(),
                                1e9F,
                                -1e9F,
                                -0.0F};

} // namespace

PointStyle::PointStyle(FuzzedBytes& bytes)
{
  constexpr float scales[] = {1, 0.02F, 1 / 3.0F, 1000, 1e6F, 1e-6F, 1e-30F, 1e30F};
  const std::uint8_t choice = bytes.byte();
  scale = scales[choice & 7];
  is_flat = choice & 8;
  is_fine = choice & 16;
  has_odd = choice & 32;
  steps = choice & 64 ? 7 : 255;
  far = choice & 128 ? 1e5F * scale : 0;
}

bool
PointStyle::isModerate() const
{
  return !has_odd && scale > 1e-7F && scale < 1e7F;
}

float
PointStyle::coordinate(FuzzedBytes& bytes) const
{
  const std::uint8_t byte = bytes.byte();
  if (has_odd && byte < std::size(odd_values))
    return odd_values[byte];
  auto value = static_cast<float>(static_cast<std::int8_t>(byte & steps));
  if (is_fine)
    value += static_cast<float>(bytes.byte()) / 256;
  return value * scale + far;
}

Eigen::Vector3f
PointStyle::point(FuzzedBytes& bytes) const
{
  Eigen::Vector3f point;
  point.x() = coordinate(bytes);
  point.y() = coordinate(bytes);
  point.z() = is_flat ? 0 : coordinate(bytes);
  return point;
}

std::vector<Eigen::Vector3f>
fuzzedPoints(FuzzedBytes& bytes, const PointStyle& style, std::size_t maximum)
{
  std::vector<Eigen::Vector3f> points;
  while (bytes.left() > 0 && points.size() < maximum)
    points.push_back(style.point(bytes));
  return points;
}

Eigen::Vector3f
fuzzedNormal(FuzzedBytes& bytes)
{
  Eigen::Vector3f normal;
  for (int axis = 0; axis < 3; ++axis)
    normal[axis] = bytes.small();
  return normal / normal.norm();
}

PointView
viewOf(const std::vector<Eigen::Vector3f>& points)
{
  return {points.data(), sizeof(Eigen::Vector3f), points.size()};
}

std::vector<std::int32_t>
usablePoints(const std::vector<Eigen::Vector3f>& points)
{
  std::vector<std::int32_t> usable;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite() &&
        std::find(points.begin(),
                  points.begin() + static_cast<std::ptrdiff_t>(i),
                  points[i]) == points.begin() + static_cast<std::ptrdiff_t>(i))
      usable.push_back(static_cast<std::int32_t>(i));
  return usable;
}

} // namespace pcl::acmap::test
