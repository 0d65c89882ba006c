#include "voxels/cell_sums.h"

#include <pcl/core/impl/parallel.h>

namespace pcl::acmap {

namespace {

/** Sums over a contiguous range of the points. */
struct Stretch {
  CellTable table;
  std::size_t invalid = 0;
  std::size_t distant = 0;
};

/** A batch of points with one array per number, so that the compiler can vectorize. */
struct Batch {
  static constexpr std::size_t capacity = 256;

  float point[3][capacity];
  float way[3][capacity]; ///< vector to the sensor, zero if it is unknown
  std::int32_t steps[3][capacity];
  std::int32_t offset[3][capacity];
  VoxelKey key[capacity];
  float squared_range[capacity];
  bool is_within[capacity];
  bool has_sensor[capacity];
};

/** Consecutive points are mostly neighbours: the cells of this number of points stay in
 * the second-level cache until they are joined to the others. */
constexpr std::size_t points_of_near_cells = std::size_t{1} << 14;

class Summation {
public:
  Summation(const PointView& points,
            const SensorView& sensors,
            const ColorView& colors,
            const VoxelLattice& lattice)
  : points_(points)
  , sensors_(sensors)
  , colors_(colors)
  , lattice_(lattice)
  {}

  void
  sum(std::size_t begin, std::size_t end, Stretch& stretch) const
  {
    Batch batch;
    CellTable near(std::min(end - begin, points_of_near_cells));
    stretch.table = CellTable(std::min(end - begin, 2 * points_of_near_cells));
    for (std::size_t next; begin < end; begin = next) {
      next = std::min(begin + points_of_near_cells, end);
      for (std::size_t first = begin; first < next; first += Batch::capacity) {
        const std::size_t size = std::min(Batch::capacity, next - first);
        gather(first, size, batch);
        locate(size, batch);
        add(first, size, batch, near, stretch);
      }
      stretch.table.join(near);
      near.clear();
    }
  }

private:
  void
  gather(std::size_t begin, std::size_t size, Batch& batch) const
  {
    for (std::size_t k = 0; k < size; ++k) {
      const Eigen::Vector3f point = points_[begin + k];
      const Eigen::Vector3f* sensor = sensors_[begin + k];
      batch.has_sensor[k] = sensor != nullptr;
      for (int axis = 0; axis < 3; ++axis) {
        batch.point[axis][k] = point[axis];
        batch.way[axis][k] = sensor ? (*sensor)[axis] - point[axis] : 0.0f;
      }
    }
  }

  void
  locate(std::size_t size, Batch& batch) const
  {
    lattice_.locate(batch.point, size, batch.key, batch.offset, batch.is_within);
    const auto scale = static_cast<float>(way_steps / lattice_.edge());
    for (std::size_t k = 0; k < size; ++k) {
      const float x = batch.way[0][k], y = batch.way[1][k], z = batch.way[2][k];
      batch.squared_range[k] = x * x + y * y + z * z;
      batch.key[k] |= octantAlong(x, y, z);
    }
    for (int axis = 0; axis < 3; ++axis)
      for (std::size_t k = 0; k < size; ++k)
        batch.steps[axis][k] = CellSums::stepsOf(batch.way[axis][k] * scale);
  }

  void
  add(std::size_t begin,
      std::size_t size,
      const Batch& batch,
      CellTable& table,
      Stretch& stretch) const
  {
    VoxelKey last_key = ~VoxelKey{0};
    std::size_t cell = 0;
    for (std::size_t k = 0; k < size; ++k) {
      const std::size_t i = begin + k;
      if (!batch.is_within[k]) {
        ++(points_[i].allFinite() ? stretch.distant : stretch.invalid);
        continue;
      }
      if (batch.key[k] != last_key)
        cell = table.find(batch.key[k]);
      last_key = batch.key[k];
      CellSums& sums = table.cells[cell];
      if (sums.count == 0) {
        sums.witness = static_cast<std::int32_t>(i);
        sums.squared_range = batch.squared_range[k];
      }
      sums.offerWitness(static_cast<std::int32_t>(i), batch.squared_range[k]);
      sums.add(batch.offset[0][k], batch.offset[1][k], batch.offset[2][k]);
      if (batch.has_sensor[k])
        for (int axis = 0; axis < 3; ++axis)
          sums.way[axis] += batch.steps[axis][k];
      if (colors_)
        addColor(i, cell, table.colors);
    }
  }

  void
  addColor(std::size_t i, std::size_t cell, std::vector<ColorSum>& sums) const
  {
    std::uint32_t packed;
    const auto place = static_cast<std::size_t>(points_.index(i));
    std::memcpy(&packed,
                static_cast<const char*>(colors_.first) + colors_.stride * place,
                sizeof packed);
    if (cell >= sums.size())
      sums.resize(cell + 1);
    sums[cell].red += (packed >> 16) & 0xff;
    sums[cell].green += (packed >> 8) & 0xff;
    sums[cell].blue += packed & 0xff;
  }

  const PointView& points_;
  const SensorView& sensors_;
  const ColorView& colors_;
  const VoxelLattice& lattice_;
};

/** Uses as many ranges as threads: the sums are exact, so the result does not depend on
 * their number. */
std::vector<Stretch>
sumStretches(const Summation& summation, std::size_t size)
{
  constexpr std::size_t worth_a_thread = std::size_t{1} << 18;
  const auto threads =
      static_cast<std::size_t>(oneapi::tbb::this_task_arena::max_concurrency());
  const std::size_t count = std::clamp<std::size_t>(size / worth_a_thread, 1, threads);
  std::vector<Stretch> stretches(count);
  oneapi::tbb::parallel_for(std::size_t{0}, count, [&](std::size_t k) {
    summation.sum(size * k / count, size * (k + 1) / count, stretches[k]);
  });
  return stretches;
}

/** Location of a cell in a range of the points. */
struct CellPlace {
  VoxelKey key;
  std::uint32_t stretch;
  std::uint32_t cell;
};

std::vector<CellPlace>
sortedPlaces(const std::vector<Stretch>& stretches)
{
  std::vector<CellPlace> places;
  for (std::uint32_t s = 0; s < stretches.size(); ++s) {
    const auto& cells = stretches[s].table.cells;
    for (std::uint32_t c = 0; c < cells.size(); ++c)
      places.push_back({cells[c].key, s, c});
  }
  std::sort(places.begin(), places.end(), [](const CellPlace& a, const CellPlace& b) {
    return a.key != b.key ? a.key < b.key : a.stretch < b.stretch;
  });
  return places;
}

void
joinStretches(const std::vector<Stretch>& stretches, VoxelMoments& voxels)
{
  const std::vector<CellPlace> places = sortedPlaces(stretches);
  voxels.cells.reserve(places.size());
  voxels.colors.reserve(places.size());
  for (std::size_t begin = 0, end; begin < places.size(); begin = end) {
    CellSums sums = stretches[places[begin].stretch].table.cells[places[begin].cell];
    ColorSum color;
    for (end = begin; end < places.size() && places[end].key == sums.key; ++end) {
      const CellTable& table = stretches[places[end].stretch].table;
      if (end > begin)
        sums.join(table.cells[places[end].cell]);
      if (table.colors.empty())
        continue;
      const ColorSum& more = table.colors[places[end].cell];
      color.red += more.red;
      color.green += more.green;
      color.blue += more.blue;
    }
    voxels.cells.push_back(toVoxelCell(sums, voxels.lattice.edge()));
    voxels.colors.push_back(color);
  }
}

} // namespace

VoxelMoments
sumVoxels(const PointView& points,
          const SensorView& sensors,
          double edge,
          unsigned threads,
          const ColorView& colors)
{
  return withThreads(threads, [&] {
    VoxelMoments voxels;
    voxels.lattice = VoxelLattice(points, edge);
    const Summation summation(points, sensors, colors, voxels.lattice);
    const std::vector<Stretch> stretches = sumStretches(summation, points.size());
    joinStretches(stretches, voxels);
    if (!colors)
      voxels.colors.clear();
    for (const Stretch& stretch : stretches) {
      voxels.invalid_points += stretch.invalid;
      voxels.distant_points += stretch.distant;
    }
    return voxels;
  });
}

VoxelMoments
coarserVoxels(const VoxelMoments& fine)
{
  VoxelMoments coarse;
  coarse.lattice = fine.lattice.coarser();
  coarse.invalid_points = fine.invalid_points;
  coarse.distant_points = fine.distant_points;
  std::vector<std::pair<VoxelKey, std::size_t>> order;
  order.reserve(fine.cells.size());
  for (std::size_t c = 0; c < fine.cells.size(); ++c) {
    VoxelPlace place = placeOf(fine.cells[c].key);
    for (std::int32_t& coordinate : place)
      coordinate /= 2;
    order.emplace_back(voxelKey(place), c);
  }
  std::sort(order.begin(), order.end());
  for (std::size_t begin = 0, end; begin < order.size(); begin = end) {
    VoxelCell& cell = coarse.cells.emplace_back(fine.cells[order[begin].second]);
    cell.key = order[begin].first;
    Moments sum; // in units of the edge of the fine voxels
    for (end = begin; end < order.size() && order[end].first == cell.key; ++end) {
      const VoxelCell& part = fine.cells[order[end].second];
      const VoxelPlace place = placeOf(part.key);
      sum.addShifted(part.moments,
                     (place[0] & 1) - 0.5,
                     (place[1] & 1) - 0.5,
                     (place[2] & 1) - 0.5);
      if (part.range < cell.range ||
          (part.range == cell.range && part.witness < cell.witness)) {
        cell.range = part.range;
        cell.witness = part.witness;
      }
    }
    cell.moments = sum.scaled(0.5);
    cell.way.setZero();
  }
  return coarse;
}

} // namespace pcl::acmap
