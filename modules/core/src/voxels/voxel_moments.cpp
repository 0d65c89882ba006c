#include "voxels/shared_cells.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/point_shares.h>

#include <atomic>
#include <optional>
#include <utility>

namespace pcl::acmap {

namespace {

/** Numbers of points that are in no cell. */
struct LeftOut {
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
  /** \param[in] size number of points that are summed, the first ones */
  Summation(const PointView& points,
            std::size_t size,
            const SensorView& sensors,
            const ColorView& colors,
            const VoxelLattice& lattice)
  : points_(points)
  , size_(size)
  , sensors_(sensors)
  , colors_(colors)
  , lattice_(lattice)
  {}

  std::size_t
  size() const
  {
    return size_;
  }

  std::size_t
  stretches() const
  {
    return (size_ + points_of_near_cells - 1) / points_of_near_cells;
  }

  /** Sums a stretch of consecutive points.
   * \param[in,out] near their cells are added to those of earlier stretches */
  void
  sum(std::size_t stretch, CellTable& near, LeftOut& left_out) const
  {
    Batch batch;
    pollRun();
    const std::size_t begin = stretch * points_of_near_cells;
    const std::size_t end = std::min(begin + points_of_near_cells, size_);
    for (std::size_t first = begin; first < end; first += Batch::capacity) {
      const std::size_t size = std::min(Batch::capacity, end - first);
      gather(first, size, batch);
      locate(size, batch);
      add(first, size, batch, near, left_out);
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
      LeftOut& left_out) const
  {
    VoxelKey last_key = ~VoxelKey{0};
    std::size_t cell = 0;
    for (std::size_t k = 0; k < size; ++k) {
      const std::size_t i = begin + k;
      if (!batch.is_within[k]) {
        ++(points_[i].allFinite() ? left_out.distant : left_out.invalid);
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
  addColor(std::size_t i, std::size_t cell, ChunkedArray<ColorSum>& sums) const
  {
    std::uint32_t packed;
    const auto place = static_cast<std::size_t>(points_.index(i));
    std::memcpy(&packed,
                static_cast<const char*>(colors_.first) + colors_.stride * place,
                sizeof packed);
    sums.extendTo(cell + 1);
    sums[cell].red += (packed >> 16) & 0xff;
    sums[cell].green += (packed >> 8) & 0xff;
    sums[cell].blue += packed & 0xff;
  }

  const PointView& points_;
  std::size_t size_;
  const SensorView& sensors_;
  const ColorView& colors_;
  const VoxelLattice& lattice_;
};

/** Keys between parts of about the same number of points. */
std::vector<VoxelKey>
limitsOf(const PointView& points, const VoxelLattice& lattice)
{
  constexpr std::size_t parts = 64, points_of_part = 64;
  std::vector<VoxelKey> keys;
  VoxelHit hit;
  for (std::size_t i = 0; i < points.size();
       i += points.size() / (parts * points_of_part) + 1) {
    pollRun();
    if (lattice.locate(points[i], hit))
      keys.push_back(voxelKey(hit.place));
  }
  std::sort(keys.begin(), keys.end());
  std::vector<VoxelKey> limits;
  for (std::size_t k = points_of_part; k < keys.size(); k += points_of_part)
    limits.push_back(keys[k]);
  return limits;
}

constexpr std::size_t worth_a_thread = std::size_t{1} << 18;

/** Number of tasks for the points, at most as many as threads. */
std::size_t
tasksFor(std::size_t points)
{
  const auto threads =
      static_cast<std::size_t>(oneapi::tbb::this_task_arena::max_concurrency());
  return std::clamp<std::size_t>(points / worth_a_thread, 1, threads);
}

/** Adds all points to the cells. The sums are exact, so the result does not depend on the
 * number of tasks. */
LeftOut
sumAll(const Summation& summation, std::size_t tasks, SharedCells& all)
{
  std::vector<LeftOut> of_tasks(tasks);
  std::atomic<std::size_t> next = 0;
  const auto sumShared = [&](std::size_t task) {
    CellTable near(std::min(summation.size(), points_of_near_cells));
    for (std::size_t stretch; (stretch = next++) < summation.stretches();) {
      near.clear();
      summation.sum(stretch, near, of_tasks[task]);
      all.join(near);
    }
  };
  if (all.parts() > 1 || summation.size() >= 2 * worth_a_thread)
    oneapi::tbb::parallel_for(std::size_t{0}, tasks, sumShared);
  else
    for (std::size_t stretch = 0; stretch < summation.stretches(); ++stretch)
      summation.sum(stretch, all.only(), of_tasks.front());
  LeftOut left_out;
  for (const LeftOut& of_task : of_tasks) {
    left_out.invalid += of_task.invalid;
    left_out.distant += of_task.distant;
  }
  return left_out;
}

/** Adds the cells of other processes. */
void
joinShares(const PointShares& shares, SharedCells& all, LeftOut& left_out)
{
  while (std::optional<ByteParcel> parcel = shares.receive()) {
    left_out.invalid += parcel->take<std::size_t>();
    left_out.distant += parcel->take<std::size_t>();
    all.join(unpackedCells(*parcel));
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
    const PointShares* const shares = points.shares();
    if (shares)
      shares->request(voxels.lattice, sensors.isKnown(), static_cast<bool>(colors));
    const std::size_t size = shares ? shares->own : points.size();
    const std::size_t tasks = tasksFor(size);
    SharedCells all(tasks > 1 || shares ? limitsOf(points, voxels.lattice)
                                        : std::vector<VoxelKey>());
    const Summation summation(points, size, sensors, colors, voxels.lattice);
    LeftOut left_out = sumAll(summation, tasks, all);
    if (shares)
      joinShares(*shares, all, left_out);
    all.moveTo(voxels);
    voxels.invalid_points = left_out.invalid;
    voxels.distant_points = left_out.distant;
    return voxels;
  });
}

void
sendCells(const PointView& points,
          const SensorView& sensors,
          const ColorView& colors,
          const VoxelLattice& lattice,
          std::int32_t first,
          unsigned threads,
          const std::function<void(ByteParcel)>& send)
{
  withThreads(threads, [&] {
    SharedCells all(limitsOf(points, lattice));
    LeftOut left_out =
        sumAll(Summation(points, points.size(), sensors, colors, lattice),
               tasksFor(points.size()),
               all);
    for (std::size_t part = 0; part < all.parts(); ++part) {
      ByteParcel parcel;
      parcel.put(std::exchange(left_out.invalid, 0));
      parcel.put(std::exchange(left_out.distant, 0));
      packCells(all.take(part), first, parcel);
      send(std::move(parcel));
    }
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
