#include "plane_raster.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::bench {
namespace {

// Corners that are meant to be on a cell's border may be off it by rounding.
constexpr double rounding = 1e-6; // cells

int
firstCell(double metres)
{
  return static_cast<int>(std::floor(metres / raster_cell + rounding));
}

int
endCell(double metres)
{
  return static_cast<int>(std::ceil(metres / raster_cell - rounding));
}

} // namespace

PlaneFrame
makePlaneFrame(const Eigen::Vector4d& coefficients)
{
  const Eigen::Vector3d normal = coefficients.head<3>();
  PlaneFrame frame;
  frame.origin = -coefficients[3] * normal;
  const Eigen::Vector3d axis =
      Eigen::Vector3d::Unit(std::abs(normal.x()) < 0.8 ? 0 : 2);
  frame.u = (axis - axis.dot(normal) * normal).normalized();
  frame.v = normal.cross(frame.u);
  return frame;
}

CellSet::CellSet(const Eigen::AlignedBox2d& box)
{
  if (box.isEmpty())
    return;
  first_i_ = firstCell(box.min().x());
  end_i_ = std::max(first_i_, endCell(box.max().x()));
  first_j_ = firstCell(box.min().y());
  end_j_ = std::max(first_j_, endCell(box.max().y()));
  cells_.assign(static_cast<std::size_t>(end_i_ - first_i_) *
                    static_cast<std::size_t>(end_j_ - first_j_),
                0);
}

bool
CellSet::hasPlace(const Eigen::Vector2d& place) const
{
  return has(static_cast<int>(std::floor(place.x() / raster_cell)),
             static_cast<int>(std::floor(place.y() / raster_cell)));
}

void
CellSet::addInside(const std::vector<FlatLoop>& loops)
{
  std::vector<std::vector<double>> crossings(
      static_cast<std::size_t>(end_i_ - first_i_)); // of the line through centres of i
  for (const FlatLoop& loop : loops)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      Eigen::Vector2d a = loop[k] / raster_cell;
      Eigen::Vector2d b = loop[(k + 1) % loop.size()] / raster_cell;
      if (a.x() > b.x())
        std::swap(a, b);
      const int first = std::max(first_i_, static_cast<int>(std::ceil(a.x() - 0.5)));
      for (int i = first; i < end_i_ && i + 0.5 < b.x(); ++i)
        crossings[static_cast<std::size_t>(i - first_i_)].push_back(
            a.y() + (i + 0.5 - a.x()) / (b.x() - a.x()) * (b.y() - a.y()));
    }
  for (int i = first_i_; i < end_i_; ++i) {
    std::vector<double>& of_line = crossings[static_cast<std::size_t>(i - first_i_)];
    std::sort(of_line.begin(), of_line.end());
    for (std::size_t k = 0; k + 1 < of_line.size(); k += 2) {
      const int first =
          std::max(first_j_, static_cast<int>(std::ceil(of_line[k] - 0.5)));
      for (int j = first; j < end_j_ && j + 0.5 < of_line[k + 1]; ++j)
        add(i, j);
    }
  }
}

bool
CellSet::hasNear(int i, int j, int reach) const
{
  for (int di = -reach; di <= reach; ++di)
    for (int dj = -reach; dj <= reach; ++dj)
      if (di * di + dj * dj <= reach * reach && has(i + di, j + dj))
        return true;
  return false;
}

bool
CellSet::hasAllNear(int i, int j, int reach) const
{
  for (int di = -reach; di <= reach; ++di)
    for (int dj = -reach; dj <= reach; ++dj)
      if (di * di + dj * dj <= reach * reach && !has(i + di, j + dj))
        return false;
  return true;
}

double
CellSet::area() const
{
  return raster_cell * raster_cell *
         static_cast<double>(std::count(cells_.begin(), cells_.end(), 1));
}

Eigen::AlignedBox2d
boxOf(const std::vector<FlatLoop>& loops)
{
  Eigen::AlignedBox2d box;
  for (const FlatLoop& loop : loops)
    for (const Eigen::Vector2d& place : loop)
      box.extend(place);
  return box;
}

} // namespace pcl::acmap::bench
