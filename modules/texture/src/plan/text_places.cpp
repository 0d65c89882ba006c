#include "plan/text_places.h"

#include "plan/stroke_font.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace pcl::acmap {

namespace {

using Eigen::Vector2d;
using Quad = std::array<Vector2d, 4>;

Eigen::AlignedBox2d
boxOf(const Quad& quad)
{
  Eigen::AlignedBox2d box;
  for (const Vector2d& corner : quad)
    box.extend(corner);
  return box;
}

/** \brief Is there a line along a side of the first one with both on different sides? */
bool
areApartBySide(const Quad& one, const Quad& other)
{
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector2d side = one[(k + 1) % 4] - one[k], across(-side.y(), side.x());
    const auto extentOf = [&](const Quad& quad) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const Vector2d& corner : quad) {
        low = std::min(low, across.dot(corner - one[k]));
        high = std::max(high, across.dot(corner - one[k]));
      }
      return std::array<double, 2>{low, high};
    };
    const auto a = extentOf(one), b = extentOf(other);
    if (a[1] <= b[0] || b[1] <= a[0])
      return true;
  }
  return false;
}

} // namespace

Quad
quadOf(const PlanText& text, double scale)
{
  constexpr double margin = 0.25; // capital letters
  const double height = text.height * scale / 1000;
  const double width = height * widthOf(text.text);
  const double shift = text.align == PlanAlign::Left    ? 0
                       : text.align == PlanAlign::Right ? 1
                                                        : 0.5;
  const Vector2d along(std::cos(text.angle), std::sin(text.angle));
  const Vector2d upwards(-along.y(), along.x());
  const auto at = [&](double right, double up) -> Vector2d {
    return text.place + (right - shift * width) * along + up * upwards;
  };
  const double left = -margin * height, right = width + margin * height,
               up = (0.5 + margin) * height;
  return {at(left, -up), at(right, -up), at(right, up), at(left, up)};
}

void
TextPlaces::block(const Quad& quad)
{
  taken_.push_back({quad, boxOf(quad)});
}

bool
TextPlaces::areFree(const std::vector<PlanText>& lines, double scale) const
{
  return std::all_of(lines.begin(), lines.end(), [&](const PlanText& line) {
    const Quad quad = quadOf(line, scale);
    const Eigen::AlignedBox2d box = boxOf(quad);
    return std::none_of(taken_.begin(), taken_.end(), [&](const Taken& other) {
      return other.box.intersects(box) && !areApartBySide(quad, other.quad) &&
             !areApartBySide(other.quad, quad);
    });
  });
}

void
TextPlaces::take(const PlanText& text, double scale)
{
  block(quadOf(text, scale));
}

} // namespace pcl::acmap
