// The loops themselves, compiled once for each variant; as lanes.h.
#pragma once

#include "entropy_bins.h"
#include "lanes.h"

namespace {

using pcl::acmap::BinArray;
using pcl::acmap::CellArrays;
using pcl::acmap::CellForces;
using pcl::acmap::CellMotion;
using pcl::acmap::SmoothingKernel;

constexpr int wall_layers = 8;

/** Quadratic B-spline: how places, in bins, are shared by three of them. At a border
 * between bins both roundings give the same. */
struct Spline {
  Lanes middle; ///< the second of the three
  Lanes offset; ///< from its centre, within half a bin
  Lanes shares[3];

  explicit ACMAP_INLINE
  Spline(const Lanes& place)
  {
    const Lanes half = allLanes(0.5);
    const Lanes centred = place - half;
    middle = roundLanes(centred);
    offset = centred - middle;
    const Lanes before = half - offset, after = half + offset;
    shares[0] = half * before * before;
    shares[1] = allLanes(0.75) - offset * offset;
    shares[2] = half * after * after;
  }

  /** d share / d place */
  ACMAP_INLINE Lanes
  slope(int k) const
  {
    return k == 0   ? offset - allLanes(0.5)
           : k == 1 ? allLanes(-2) * offset
                    : offset + allLanes(0.5);
  }
};

/** Four cells in the grid. */
struct PlacedCells {
  Lanes across, along; ///< from the reference, in the map's axes
  Spline x, z;
  LaneInts first; ///< of the 3 x 3 bins, in layer 0

  ACMAP_INLINE
  PlacedCells(const CellArrays& cells,
              std::int64_t i,
              const CellMotion& motion,
              std::int64_t row)
  : PlacedCells(loadLanes(cells.x + i), loadLanes(cells.z + i), motion, row)
  {}

private:
  ACMAP_INLINE
  PlacedCells(const Lanes& u,
              const Lanes& v,
              const CellMotion& motion,
              std::int64_t row)
  : across(allLanes(motion.cosine) * u + allLanes(motion.sine) * v)
  , along(allLanes(motion.cosine) * v - allLanes(motion.sine) * u)
  , x(across + allLanes(motion.x0))
  , z(along + allLanes(motion.z0))
  , first(intsOf((x.middle - allLanes(1)) * allLanes(static_cast<double>(row)) +
                 (z.middle - allLanes(1))))
  {}
};

/** The layers of four cells: one, or three that share them. */
template <bool directed>
struct Layers {
  ACMAP_INLINE
  Layers(const CellArrays&, std::int64_t, const CellMotion&) {}

  static constexpr int count = 1;

  ACMAP_INLINE std::int64_t
  offset(int, int, const BinArray&) const
  {
    return 0;
  }
};

template <>
struct Layers<true> {
  Spline angle;
  LaneInts middle;

  ACMAP_INLINE
  Layers(const CellArrays& cells, std::int64_t i, const CellMotion& motion)
  : angle(loadLanes(cells.direction + i) + allLanes(motion.turn))
  , middle(intsOf(angle.middle))
  {}

  static constexpr int count = 3;

  ACMAP_INLINE std::int64_t
  offset(int layer, int cell, const BinArray& grid) const
  {
    return ((middle[cell] + layer - 1) & (wall_layers - 1)) * grid.layer;
  }
};

/** One cell of four into 3 x 3 bins; the fourth of a row gets nothing. */
ACMAP_INLINE void
fillBins(const BinArray& grid,
         std::int64_t first,
         const Lanes& along,
         double before,
         double middle,
         double after)
{
  constexpr auto block = static_cast<std::uint64_t>(BinArray::block);
  grid.marks[static_cast<std::uint64_t>(first) / block] = 1;
  grid.marks[static_cast<std::uint64_t>(first + 2) / block] = 1;
  double* bins = grid.bins + first;
  storeLanes(bins, loadLanes(bins) + allLanes(before) * along);
  bins += grid.row;
  storeLanes(bins, loadLanes(bins) + allLanes(middle) * along);
  bins += grid.row;
  storeLanes(bins, loadLanes(bins) + allLanes(after) * along);
}

template <bool directed>
void
fillCells(const CellArrays& cells, const CellMotion& motion, const BinArray& grid)
{
  for (std::int64_t i = 0; i < cells.size; i += lane_count) {
    const PlacedCells placed(cells, i, motion, grid.row);
    const Layers<directed> layers(cells, i, motion);
    const Lanes weight = loadLanes(cells.weight + i);
    Lanes along[4] = {
        placed.z.shares[0], placed.z.shares[1], placed.z.shares[2], allLanes(0)};
    transpose(along[0], along[1], along[2], along[3]);
    for (int layer = 0; layer < Layers<directed>::count; ++layer) {
      Lanes part = weight;
      if constexpr (directed)
        part = weight * layers.angle.shares[layer];
      const Lanes before = part * placed.x.shares[0];
      const Lanes middle = part * placed.x.shares[1];
      const Lanes after = part * placed.x.shares[2];
      for (int cell = 0; cell < lane_count; ++cell)
        fillBins(grid,
                 placed.first[cell] + layers.offset(layer, cell, grid),
                 along[cell],
                 before[cell],
                 middle[cell],
                 after[cell]);
    }
  }
}

/** What a field has around a cell, each bin along z: its level and how it rises along
 * x. */
struct Strip {
  Lanes level, rise;
};

ACMAP_INLINE Strip
readStrip(const double* bins, std::int64_t row, const Spline& x, int cell)
{
  const Lanes before = loadLanes(bins);
  const Lanes middle = loadLanes(bins + row);
  const Lanes after = loadLanes(bins + 2 * row);
  const double offset = x.offset[cell];
  return {allLanes(x.shares[0][cell]) * before + allLanes(x.shares[1][cell]) * middle +
              allLanes(x.shares[2][cell]) * after,
          allLanes(offset - 0.5) * before + allLanes(-2 * offset) * middle +
              allLanes(offset + 0.5) * after};
}

/** Of strips of four cells, one number a cell. */
ACMAP_INLINE Lanes
across(Lanes (&strips)[4], const Lanes& first, const Lanes& second, const Lanes& third)
{
  return first * strips[0] + second * strips[1] + third * strips[2];
}

template <bool directed>
CellForces
forcesOnCells(const CellArrays& cells, const CellMotion& motion, const BinArray& grid)
{
  Lanes sum_x = allLanes(0), sum_z = sum_x, sum_turn = sum_x, sum_layers = sum_x;
  for (std::int64_t i = 0; i < cells.size; i += lane_count) {
    const PlacedCells placed(cells, i, motion, grid.row);
    const Layers<directed> layers(cells, i, motion);
    const Lanes weight = loadLanes(cells.weight + i);
    Lanes level[4], rise[4], change[4];
    for (int cell = 0; cell < lane_count; ++cell) {
      if constexpr (directed) {
        level[cell] = rise[cell] = change[cell] = allLanes(0);
        for (int layer = 0; layer < 3; ++layer) {
          const Strip strip = readStrip(grid.bins + placed.first[cell] +
                                            layers.offset(layer, cell, grid),
                                        grid.row,
                                        placed.x,
                                        cell);
          const Lanes share = allLanes(layers.angle.shares[layer][cell]);
          level[cell] += share * strip.level;
          rise[cell] += share * strip.rise;
          change[cell] += allLanes(layers.angle.slope(layer)[cell]) * strip.level;
        }
      }
      else {
        const Strip strip =
            readStrip(grid.bins + placed.first[cell], grid.row, placed.x, cell);
        level[cell] = strip.level;
        rise[cell] = strip.rise;
      }
    }
    const Spline& z = placed.z;
    transpose(level[0], level[1], level[2], level[3]);
    transpose(rise[0], rise[1], rise[2], rise[3]);
    const Lanes by_x = weight * across(rise, z.shares[0], z.shares[1], z.shares[2]);
    const Lanes by_z = weight * across(level, z.slope(0), z.slope(1), z.slope(2));
    sum_x += by_x;
    sum_z += by_z;
    sum_turn += by_x * placed.along - by_z * placed.across;
    if constexpr (directed) {
      transpose(change[0], change[1], change[2], change[3]);
      sum_layers += weight * across(change, z.shares[0], z.shares[1], z.shares[2]);
    }
  }
  return {sumOf(sum_x), sumOf(sum_z), sumOf(sum_turn), sumOf(sum_layers)};
}

/** Inlined with a constant radius where it is the usual one. */
ACMAP_INLINE void
smoothAcrossBy(const double* const* rows,
               const double* weights,
               std::int64_t radius,
               std::int64_t size,
               double* out)
{
  for (std::int64_t j = 0; j < size; j += lane_count) {
    Lanes sum = allLanes(weights[0]) * loadLanes(rows[radius] + j);
    for (std::int64_t i = 1; i <= radius; ++i)
      sum += allLanes(weights[i]) *
             (loadLanes(rows[radius - i] + j) + loadLanes(rows[radius + i] + j));
    storeLanes(out + j, sum);
  }
}

ACMAP_INLINE void
smoothAlongBy(const double* bins,
              const double* weights,
              std::int64_t radius,
              std::int64_t size,
              double* out)
{
  for (std::int64_t j = 0; j < size; j += lane_count) {
    Lanes sum = allLanes(weights[0]) * loadLanes(bins + j);
    for (std::int64_t i = 1; i <= radius; ++i)
      sum += allLanes(weights[i]) * (loadLanes(bins + j - i) + loadLanes(bins + j + i));
    storeLanes(out + j, sum);
  }
}

constexpr std::int64_t usual_radius = 3; // sigma of one bin

void
smoothAcross(const double* const* rows,
             const SmoothingKernel& kernel,
             std::int64_t size,
             double* out)
{
  if (kernel.radius == usual_radius)
    smoothAcrossBy(rows, kernel.weights, usual_radius, size, out);
  else
    smoothAcrossBy(rows, kernel.weights, kernel.radius, size, out);
}

void
smoothAlong(const double* bins,
            const SmoothingKernel& kernel,
            std::int64_t size,
            double* out)
{
  if (kernel.radius == usual_radius)
    smoothAlongBy(bins, kernel.weights, usual_radius, size, out);
  else
    smoothAlongBy(bins, kernel.weights, kernel.radius, size, out);
}

double
sumUp(const double* bins, std::int64_t size, double* sums)
{
  Lanes sum = allLanes(0);
  for (std::int64_t j = 0; j < size; j += lane_count) {
    const Lanes q = loadLanes(bins + j);
    sum += q;
    storeLanes(sums + j, loadLanes(sums + j) + q);
  }
  return sumOf(sum);
}

double
takeLogarithms(double* bins, std::int64_t size)
{
  Lanes sum = allLanes(0);
  for (std::int64_t j = 0; j < size; j += lane_count) {
    const Lanes q = loadLanes(bins + j);
    const Lanes logarithm = reinterpret_cast<Lanes>(
        reinterpret_cast<LaneInts>(log2Lanes(q)) & (q > allLanes(0)));
    sum += q * logarithm;
    storeLanes(bins + j, logarithm);
  }
  return sumOf(sum);
}

} // namespace
