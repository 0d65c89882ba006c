#include "facing_table.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

constexpr std::size_t side = 24; ///< cells along the side of a cube, of 3 to 5 degrees

std::size_t
cellOf(double coordinate)
{
  const auto cell = static_cast<std::size_t>((coordinate + 1) / 2 * side);
  return std::min(cell, side - 1);
}

} // namespace

FacingTable::FacingTable()
: sums_(3 * side * side)
{}

void
FacingTable::add(const Eigen::Vector3d& normal, double area)
{
  const double length = normal.norm();
  if (!std::isfinite(length) || !(length > 0) || !(area > 0))
    return;
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  // one half of the sphere, on three faces of a cube
  const Eigen::Vector3d on_cube = normal / normal[axis];
  const std::size_t u = cellOf(on_cube[(axis + 1) % 3]);
  const std::size_t v = cellOf(on_cube[(axis + 2) % 3]);
  Sum& sum = sums_[(static_cast<std::size_t>(axis) * side + u) * side + v];
  sum.normals += std::copysign(area / length, normal[axis]) * normal;
  sum.area += area;
}

std::vector<FacingArea>
FacingTable::facings() const
{
  std::vector<FacingArea> facings;
  for (const Sum& sum : sums_)
    if (sum.area > 0)
      facings.push_back({sum.normals.normalized(), sum.area});
  return facings;
}

} // namespace pcl::acmap
