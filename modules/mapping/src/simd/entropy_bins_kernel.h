// The loops, compiled once for each variant; see lanes.h.
#pragma once

#include "entropy_bins.h"
#include "lanes.h"

namespace {

using pcl::acmap::BinArray;
using pcl::acmap::CellArrays;
using pcl::acmap::CellForces;
using pcl::acmap::CellMotion;
using pcl::acmap::SmoothingKernel;
using pcl::acmap::SmoothingLevels;

constexpr int wall_layers = 8;

/** Quadratic B-spline that distributes positions, in bins, over three bins. At a border
 * between bins, rounding up or down gives the same result. */
struct Spline {
  Lanes middle;      ///< index of the second of the three
  FourFloats offset; ///< offset from its centre, within half a bin
  FourFloats shares[3];

  explicit ACMAP_INLINE
  Spline(const Lanes& place)
  {
    const Lanes centred = place - allLanes(0.5);
    middle = roundLanes(centred);
    offset = floatsOf(centred - middle);
    const FourFloats before = 0.5F - offset, after = 0.5F + offset;
    shares[0] = 0.5F * before * before;
    shares[1] = 0.75F - offset * offset;
    shares[2] = 0.5F * after * after;
  }

  /** d share / d position */
  ACMAP_INLINE FourFloats
  slope(int k) const
  {
    return k == 0 ? offset - 0.5F : k == 1 ? -2 * offset : offset + 0.5F;
  }
};

/** Positions of four cells in the grid. */
struct PlacedCells {
  Lanes across, along; ///< relative to the reference, in the map's axes
  Spline x, z;
  LaneInts first; ///< first of the 3 x 3 bins, in layer 0

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

/** The layers of four cells: one, or three over which they are distributed. */
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

/** Adds one of four cells to 3 x 3 bins; the fourth bin of a row gets zero. */
ACMAP_INLINE void
fillBins(const BinArray& grid,
         std::int64_t first,
         const FourFloats& along,
         float before,
         float middle,
         float after)
{
  constexpr auto block = static_cast<std::uint64_t>(BinArray::block);
  grid.marks[static_cast<std::uint64_t>(first) / block] = 1;
  grid.marks[static_cast<std::uint64_t>(first + 2) / block] = 1;
  float* bins = grid.bins + first;
  store(bins, load<FourFloats>(bins) + before * along);
  bins += grid.row;
  store(bins, load<FourFloats>(bins) + middle * along);
  bins += grid.row;
  store(bins, load<FourFloats>(bins) + after * along);
}

template <bool directed>
void
fillCells(const CellArrays& cells, const CellMotion& motion, const BinArray& grid)
{
  for (std::int64_t i = 0; i < cells.size; i += lane_count) {
    const PlacedCells placed(cells, i, motion, grid.row);
    const Layers<directed> layers(cells, i, motion);
    const auto weight = load<FourFloats>(cells.weight + i);
    FourFloats along[4] = {
        placed.z.shares[0], placed.z.shares[1], placed.z.shares[2], allFour(0)};
    transpose(along[0], along[1], along[2], along[3]);
    for (int layer = 0; layer < Layers<directed>::count; ++layer) {
      FourFloats part = weight;
      if constexpr (directed)
        part = weight * layers.angle.shares[layer];
      const FourFloats before = part * placed.x.shares[0];
      const FourFloats middle = part * placed.x.shares[1];
      const FourFloats after = part * placed.x.shares[2];
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

/** Values of a field around a cell, for each bin along z: its level (low half) and its
 * slope along x (high half). */
struct StripReader {
  Floats factors[3];

  ACMAP_INLINE
  StripReader(const Spline& x, int cell)
  {
    for (int k = 0; k < 3; ++k)
      factors[k] = join(allFour(x.shares[k][cell]), allFour(x.slope(k)[cell]));
  }

  ACMAP_INLINE Floats
  read(const float* bins, std::int64_t row) const
  {
    return factors[0] * twice(bins) + factors[1] * twice(bins + row) +
           factors[2] * twice(bins + 2 * row);
  }

private:
  static ACMAP_INLINE Floats
  twice(const float* bins)
  {
    const auto floats = load<FourFloats>(bins);
    return join(floats, floats);
  }
};

template <bool directed>
CellForces
forcesOnCells(const CellArrays& cells, const CellMotion& motion, const BinArray& grid)
{
  Lanes sum_x = allLanes(0), sum_z = sum_x, sum_turn = sum_x, sum_layers = sum_x;
  for (std::int64_t i = 0; i < cells.size; i += lane_count) {
    const PlacedCells placed(cells, i, motion, grid.row);
    const Layers<directed> layers(cells, i, motion);
    const auto weight = load<FourFloats>(cells.weight + i);
    Floats strips[4];
    FourFloats changes[4];
    for (int cell = 0; cell < lane_count; ++cell) {
      const StripReader reader(placed.x, cell);
      const float* bins = grid.bins + placed.first[cell];
      if constexpr (directed) {
        strips[cell] = Floats{};
        changes[cell] = FourFloats{};
        for (int layer = 0; layer < 3; ++layer) {
          const Floats strip =
              reader.read(bins + layers.offset(layer, cell, grid), grid.row);
          strips[cell] += layers.angle.shares[layer][cell] * strip;
          changes[cell] += layers.angle.slope(layer)[cell] * lowOf(strip);
        }
      }
      else
        strips[cell] = reader.read(bins, grid.row);
    }
    const Spline& z = placed.z;
    transpose(strips[0], strips[1], strips[2], strips[3]);
    const Floats by_z_and_x =
        join(weight, weight) * (join(z.slope(0), z.shares[0]) * strips[0] +
                                join(z.slope(1), z.shares[1]) * strips[1] +
                                join(z.slope(2), z.shares[2]) * strips[2]);
    const Lanes by_x = lanesOf(highOf(by_z_and_x)), by_z = lanesOf(lowOf(by_z_and_x));
    sum_x += by_x;
    sum_z += by_z;
    sum_turn += by_x * placed.along - by_z * placed.across;
    if constexpr (directed) {
      transpose(changes[0], changes[1], changes[2], changes[3]);
      sum_layers +=
          lanesOf(weight * (z.shares[0] * changes[0] + z.shares[1] * changes[1] +
                            z.shares[2] * changes[2]));
    }
  }
  return {sumOf(sum_x), sumOf(sum_z), sumOf(sum_turn), sumOf(sum_layers)};
}

/** Weighted sum over a bin and its neighbours on both sides, which are \a apart. */
template <typename Vector>
ACMAP_INLINE Vector
smooth(const float* bins, std::int64_t apart, const SmoothingKernel& kernel)
{
  Vector sum = kernel.weights[0] * load<Vector>(bins);
  for (std::int64_t i = 1; i <= kernel.radius; ++i)
    sum += kernel.weights[i] *
           (load<Vector>(bins - i * apart) + load<Vector>(bins + i * apart));
  return sum;
}

/** Calls loop with a kernel whose radius is a compile-time constant in the usual case,
 * a sigma of one bin. */
template <typename Loop>
ACMAP_INLINE auto
withUsualRadius(const SmoothingKernel& kernel, const Loop& loop)
{
  constexpr std::int64_t usual = 3;
  return kernel.radius == usual ? loop(SmoothingKernel{kernel.weights, usual})
                                : loop(kernel);
}

constexpr std::int64_t float_count = 8;

void
smoothAcross(const float* bins,
             std::int64_t row,
             const SmoothingKernel& kernel,
             std::int64_t size,
             float* out)
{
  withUsualRadius(
      kernel, [=](const SmoothingKernel& by) __attribute__((always_inline)) {
        std::int64_t j = 0;
        for (; j + float_count <= size; j += float_count) {
          __builtin_prefetch(bins + j + (by.radius + 3) * row);
          store(out + j, smooth<Floats>(bins + j, row, by));
        }
        if (j < size)
          store(out + j, smooth<FourFloats>(bins + j, row, by));
      });
}

double
takeLogarithms(const float* bins,
               const SmoothingKernel& kernel,
               std::int64_t size,
               float* out)
{
  // The parts are short enough for the rounding of float sums to be far below that of
  // bins.
  constexpr std::int64_t part = 16 * float_count;
  return withUsualRadius(
      kernel, [=](const SmoothingKernel& by) __attribute__((always_inline)) {
        Lanes sum = allLanes(0);
        std::int64_t j = 0;
        while (j + float_count <= size) {
          const std::int64_t end = size - j > part ? j + part : size;
          Floats sum_of_part{};
          for (; j + float_count <= end; j += float_count) {
            const auto q = smooth<Floats>(bins + j, 1, by);
            const auto logarithm = log2Floats<FloatBits>(q);
            sum_of_part += q * logarithm;
            store(out + j, logarithm);
          }
          sum += lanesOf(lowOf(sum_of_part)) + lanesOf(highOf(sum_of_part));
        }
        if (j < size) {
          const auto q = smooth<FourFloats>(bins + j, 1, by);
          const auto logarithm = log2Floats<FourBits>(q);
          sum += lanesOf(q * logarithm);
          store(out + j, logarithm);
        }
        return sumOf(sum);
      });
}

void
takeFromLevels(const float* bins,
               const SmoothingKernel& kernel,
               const SmoothingLevels& from,
               std::int64_t size,
               float* out)
{
  withUsualRadius(
      kernel, [=](const SmoothingKernel& by) __attribute__((always_inline)) {
        std::int64_t j = 0;
        for (; j + float_count <= size; j += float_count)
          store(out + j,
                from.level + load<Floats>(from.levels + j) -
                    smooth<Floats>(bins + j, 1, by));
        if (j < size)
          store(out + j,
                from.level + load<FourFloats>(from.levels + j) -
                    smooth<FourFloats>(bins + j, 1, by));
      });
}

double
sumUp(const float* bins, std::int64_t size, double* sums)
{
  Lanes sum = allLanes(0);
  for (std::int64_t j = 0; j < size; j += lane_count) {
    const Lanes q = loadLanes(bins + j);
    sum += q;
    store(sums + j, load<Lanes>(sums + j) + q);
  }
  return sumOf(sum);
}

double
takeExactLogarithms(double* values, std::int64_t size)
{
  Lanes sum = allLanes(0);
  for (std::int64_t j = 0; j < size; j += lane_count) {
    const Lanes q = load<Lanes>(values + j);
    const Lanes logarithm = reinterpret_cast<Lanes>(
        reinterpret_cast<LaneInts>(log2Lanes(q)) & (q > allLanes(0)));
    sum += q * logarithm;
    store(values + j, logarithm);
  }
  return sumOf(sum);
}

} // namespace
