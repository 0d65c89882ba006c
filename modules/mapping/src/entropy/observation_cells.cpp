#include "wall_direction.h"

#include <pcl/mapping/map_entropy_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace pcl::acmap {
namespace {

/** Coordinates and directions are summed up as integers, so that no order matters. */
constexpr double steps = 1 << 20;

/** A point's cell, and where in it the point is. */
struct Entry {
  std::int64_t column, row;
  int sector; ///< of the direction; -1: none
  std::int64_t x, z, normal_x, normal_z;

  auto
  key() const
  {
    return std::tie(column, row, sector);
  }
};

Entry
entryOf(const Eigen::Vector3f& point, double direction, double cell)
{
  Entry entry{};
  const double u = point[0] / cell;
  const double v = point[2] / cell;
  entry.column = static_cast<std::int64_t>(std::floor(u));
  entry.row = static_cast<std::int64_t>(std::floor(v));
  entry.x = std::llround((u - std::floor(u)) * steps);
  entry.z = std::llround((v - std::floor(v)) * steps);
  entry.sector = -1;
  if (std::isnan(direction))
    return entry;
  constexpr double sectors_per_radian = 4 * wall_directions / (2 * M_PI);
  entry.sector = static_cast<int>(std::floor((direction + M_PI) * sectors_per_radian));
  entry.normal_x = std::llround(std::cos(direction) * steps);
  entry.normal_z = std::llround(std::sin(direction) * steps);
  return entry;
}

/** Entries [first, last) are of one cell. */
EntropyCell
sumUp(const Entry* first, const Entry* last, double size)
{
  Entry sum{};
  for (const Entry* entry = first; entry != last; ++entry) {
    sum.x += entry->x;
    sum.z += entry->z;
    sum.normal_x += entry->normal_x;
    sum.normal_z += entry->normal_z;
  }
  EntropyCell cell;
  cell.weight = static_cast<double>(last - first);
  const double share = 1 / (steps * cell.weight);
  cell.x = size * (static_cast<double>(first->column) + share * double(sum.x));
  cell.z = size * (static_cast<double>(first->row) + share * double(sum.z));
  cell.direction = first->sector < 0 ? std::nan("")
                                     : std::atan2(static_cast<double>(sum.normal_z),
                                                  static_cast<double>(sum.normal_x));
  return cell;
}

} // namespace

EntropyCells
aggregateCells(const PointView& points,
               const PointView& normals,
               const MapEntropySettings& settings)
{
  const double size = settings.bin_size / 2;
  EntropyCells result;
  result.points = points.size();
  std::vector<Entry> entries;
  entries.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f point = points[i];
    if (!point.allFinite()) {
      ++result.invalid_points;
      continue;
    }
    if (point.cwiseAbs().maxCoeff() > entropy_reach) {
      ++result.distant_points;
      continue;
    }
    const double direction =
        settings.direction_aware ? wallDirection(points, normals, i) : std::nan("");
    result.directed_points += !std::isnan(direction);
    entries.push_back(entryOf(point, direction, size));
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.key() < b.key();
  });
  const Entry* const end = entries.data() + entries.size();
  for (const Entry* first = entries.data(); first != end;) {
    const Entry* last = first;
    while (last != end && last->key() == first->key())
      ++last;
    result.cells.push_back(sumUp(first, last, size));
    first = last;
  }
  return result;
}

} // namespace pcl::acmap
