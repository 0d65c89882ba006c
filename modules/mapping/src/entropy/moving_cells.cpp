#include "moving_cells.h"

#include "wall_direction.h"

#include <pcl/core/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap {
namespace {

constexpr double layers_per_radian = wall_directions / (2 * M_PI);

void
requireCell(const EntropyCell& cell)
{
  const double farthest = 2.0 * static_cast<double>(entropy_reach);
  if (!(std::abs(cell.x) <= farthest && std::abs(cell.z) <= farthest &&
        cell.weight >= 0 && cell.weight < std::numeric_limits<float>::max()))
    throw acmap::BadArgument(
        "a cell of an observation must be finite and have no negative weight");
}

/** Order that takes cells from a few runs alternately. */
std::vector<std::size_t>
interleaved(std::size_t size)
{
  constexpr std::size_t runs = 8;
  const std::size_t length = (size + runs - 1) / runs;
  std::vector<std::size_t> order;
  order.reserve(size);
  for (std::size_t i = 0; i < length; ++i)
    for (std::size_t at = i; at < size; at += length)
      order.push_back(at);
  return order;
}

/** The layer of cells without direction. */
BinArray
undirectedLayer(BinArray grid)
{
  grid.bins += wall_directions * grid.layer;
  grid.marks += wall_directions * grid.layer / BinArray::block;
  return grid;
}

} // namespace

CellArrays
MovingCells::Arrays::view() const
{
  return {x.data(),
          z.data(),
          weight.data(),
          direction.data(),
          static_cast<std::int64_t>(x.size())};
}

MovingCells::MovingCells(const EntropyCells& observation,
                         const MapEntropySettings& settings,
                         double unit)
: bin_size_(settings.bin_size)
, unit_(unit)
, direction_aware_(settings.direction_aware)
{
  const std::vector<EntropyCell>& cells = observation.cells;
  std::for_each(cells.begin(), cells.end(), requireCell);
  if (!cells.empty()) {
    const EntropyCell& middle = cells[cells.size() / 2];
    reference_ = {middle.x, middle.z};
  }
  for (const std::size_t i : interleaved(cells.size()))
    add(cells[i],
        direction_aware_ && std::isfinite(cells[i].direction) ? directed_ : plain_);
  for (Arrays* arrays : {&plain_, &directed_})
    while (arrays->x.size() % BinArray::block != 0) {
      arrays->x.push_back(arrays->x.back());
      arrays->z.push_back(arrays->z.back());
      arrays->weight.push_back(0);
      arrays->direction.push_back(0);
    }
  setOutline();
}

void
MovingCells::add(const EntropyCell& cell, Arrays& arrays)
{
  const auto weight = static_cast<float>(cell.weight * unit_);
  arrays.x.push_back(static_cast<float>((cell.x - reference_[0]) / bin_size_));
  arrays.z.push_back(static_cast<float>((cell.z - reference_[1]) / bin_size_));
  arrays.weight.push_back(weight);
  arrays.direction.push_back(
      &arrays == &directed_ ? static_cast<float>(cell.direction * layers_per_radian)
                            : 0);
  extent_.add({cell.x, cell.z}, static_cast<double>(weight));
}

void
MovingCells::setOutline()
{
  Eigen::Array4d maximum =
      Eigen::Array4d::Constant(-std::numeric_limits<double>::max());
  Eigen::Array4d minimum = -maximum;
  for (const Arrays* arrays : {&plain_, &directed_})
    for (std::size_t i = 0; i < arrays->x.size(); ++i) {
      const auto x = static_cast<double>(arrays->x[i]);
      const auto z = static_cast<double>(arrays->z[i]);
      const Eigen::Array4d reach(x, x + z, z, z - x);
      maximum = maximum.max(reach);
      minimum = minimum.min(reach);
    }
  const auto corners = [](double x, double diagonal, double z) {
    return std::array<Eigen::Vector2d, 2>{Eigen::Vector2d(x, diagonal - x),
                                          Eigen::Vector2d(diagonal - z, z)};
  };
  const auto right = corners(maximum[0], maximum[1], maximum[2]);
  const auto left = corners(minimum[0], minimum[1], minimum[2]);
  outline_ = {right[0],
              right[1],
              {maximum[2] - maximum[3], maximum[2]},
              {minimum[0], maximum[3] + minimum[0]},
              left[0],
              left[1],
              {minimum[2] - minimum[3], minimum[2]},
              {maximum[0], minimum[3] + maximum[0]}};
}

CellMotion
MovingCells::motionUnder(const PlanarPose& pose) const
{
  const PlanarMotion motion(pose);
  const Eigen::Vector2d at = motion.place(reference_[0], reference_[1]) / bin_size_;
  return {motion.cosine(),
          motion.sine(),
          at[0],
          at[1],
          motion.direction(0) * layers_per_radian};
}

BinRange
MovingCells::rangeUnder(const PlanarPose& pose) const
{
  BinRange range;
  if (plain_.x.empty() && directed_.x.empty())
    return range;
  const CellMotion motion = motionUnder(pose);
  for (const Eigen::Vector2d& corner : outline_) {
    const std::int64_t x =
        binOf(motion.x0 + motion.cosine * corner[0] + motion.sine * corner[1]);
    const std::int64_t z =
        binOf(motion.z0 + motion.cosine * corner[1] - motion.sine * corner[0]);
    range.add(x - 1, z - 1);
    range.add(x + 1, z + 1);
  }
  return range;
}

void
MovingCells::fill(const EntropyGrid& grid, const PlanarPose& pose) const
{
  CellMotion motion = motionUnder(pose);
  motion.x0 -= static_cast<double>(grid.firstX());
  motion.z0 -= static_cast<double>(grid.firstZ());
  const BinArray& bins = grid.bins();
  const EntropyBins& kernels = entropyBins();
  kernels.fill(plain_.view(), motion, direction_aware_ ? undirectedLayer(bins) : bins);
  kernels.fillDirected(directed_.view(), motion, bins);
}

Eigen::Vector3d
MovingCells::forces(const EntropyGrid& grid, const PlanarPose& pose) const
{
  CellMotion motion = motionUnder(pose);
  motion.x0 -= static_cast<double>(grid.firstX());
  motion.z0 -= static_cast<double>(grid.firstZ());
  const BinArray& bins = grid.bins();
  const EntropyBins& kernels = entropyBins();
  const CellForces plain = kernels.forces(
      plain_.view(), motion, direction_aware_ ? undirectedLayer(bins) : bins);
  const CellForces directed = kernels.forcesDirected(directed_.view(), motion, bins);
  const Eigen::Vector2d force =
      Eigen::Vector2d(plain.x + directed.x, plain.z + directed.z) / bin_size_;
  const double turn = force.dot(PlanarMotion(pose).turn(reference_[0], reference_[1])) +
                      plain.turn + directed.turn - directed.layers * layers_per_radian;
  return {force[0], force[1], turn};
}

} // namespace pcl::acmap
