#include <pcl/simulation/surface_color.h>

#include "random_streams.h"

#include <algorithm>
#include <cmath>

namespace pcl {

namespace {

/** \brief Value at a lattice point, uniform with mean 0 and standard deviation 1. */
double
latticeValue(std::uint64_t stream, double i, double j)
{
  const auto number = [](double x) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(x));
  };
  const std::uint64_t bits =
      acmap::mixedBits(acmap::mixedBits(stream, number(i)), number(j));
  constexpr double half_width = 1.7320508075688772; // sqrt (3)
  return half_width * (static_cast<double>(bits >> 11) * 0x1.0p-52 - 1.0);
}

/** \brief Value noise: lattice values with bilinear interpolation. */
double
valueNoise(std::uint64_t stream, const Eigen::Vector2d& place)
{
  const double i = std::floor(place.x());
  const double j = std::floor(place.y());
  const double s = place.x() - i;
  const double t = place.y() - j;
  const double low =
      (1.0 - s) * latticeValue(stream, i, j) + s * latticeValue(stream, i + 1, j);
  const double high = (1.0 - s) * latticeValue(stream, i, j + 1) +
                      s * latticeValue(stream, i + 1, j + 1);
  // Interpolation reduces the standard deviation to 2/3, averaged over all positions.
  constexpr double loss = 1.5;
  return loss * ((1.0 - t) * low + t * high);
}

double
grainAt(std::size_t index, const Eigen::Vector2d& place)
{
  constexpr double coarse_cell = 0.16; // metres
  constexpr double fine_cell = 0.02;
  const std::uint64_t stream = acmap::mixedBits(index, 0);
  return (valueNoise(stream, place / coarse_cell) +
          valueNoise(~stream, place / fine_cell)) *
         std::sqrt(0.5);
}

/** \brief Coordinates of a point on each kind of surface. */
struct Coordinates {
  const Eigen::Vector3d& point;

  Eigen::Vector2d
  operator()(const SimulatedRectangle& rectangle) const
  {
    const Eigen::Vector3d at = point - rectangle.corner;
    return {at.dot(rectangle.edge_u) / rectangle.edge_u.norm(),
            at.dot(rectangle.edge_v) / rectangle.edge_v.norm()};
  }

  Eigen::Vector2d
  operator()(const SimulatedCylinder& cylinder) const
  {
    const Eigen::Vector3d axis = cylinder.axis.normalized();
    const Eigen::Vector3d first = axis.unitOrthogonal();
    const Eigen::Vector3d at = point - cylinder.base;
    const double angle = std::atan2(at.dot(axis.cross(first)), at.dot(first));
    return {cylinder.radius * angle, at.dot(axis)};
  }

  Eigen::Vector2d
  operator()(const SimulatedDisc& disc) const
  {
    const Eigen::Vector3d first = disc.normal.unitOrthogonal();
    const Eigen::Vector3d at = point - disc.center;
    return {at.dot(first), at.dot(disc.normal.cross(first))};
  }
};

} // namespace

Eigen::Vector2d
surfaceCoordinates(const SimulatedSurface& surface, const Eigen::Vector3d& point)
{
  return std::visit(Coordinates{point}, surface.shape);
}

std::array<std::uint8_t, 3>
surfaceColor(const SimulatedSurface& surface,
             std::size_t index,
             const Eigen::Vector3d& point)
{
  std::array<std::uint8_t, 3> color = surface.look.color;
  if (surface.look.texture == 0.0)
    return color;
  const double grain =
      surface.look.texture * grainAt(index, surfaceCoordinates(surface, point));
  for (std::uint8_t& channel : color)
    channel =
        static_cast<std::uint8_t>(std::lround(std::clamp(channel + grain, 0.0, 255.0)));
  return color;
}

} // namespace pcl
