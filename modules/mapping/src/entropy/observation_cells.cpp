#include "cell_table.h"
#include "entropy_grid.h"
#include "point_weights.h"
#include "wall_direction.h"

#include <pcl/mapping/impl/map_entropy_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl::acmap {
namespace {

/** Positions and normals are summed as integers with this number of steps per half bin,
 * or per unit. */
constexpr double steps = 1 << 15;

/** A coordinate of a point in bins. */
struct BinCoordinate {
  std::int64_t bin;
  std::uint64_t place; ///< position in the bin
  int half;            ///< half of the bin, 0 or 1

  BinCoordinate(float coordinate, double bin_size)
  {
    const double at = static_cast<double>(coordinate) / bin_size;
    bin = binOf(at);
    const double within = at - static_cast<double>(bin);
    place = static_cast<std::uint64_t>(within * (2 * steps) + 0.5);
    half = within >= 0.5;
  }
};

/** The cells of one bin and sector are consecutive when sorted by their keys: first the
 * bin's x; then the bin's z, the sector, and the quarter of the bin. */
constexpr std::int64_t quarters = 4, sectors = 64;

EntropyCellSums&
cellOf(EntropyCellTable& table,
       const BinCoordinate& x,
       const BinCoordinate& z,
       const WallDirection& normal)
{
  const std::int64_t sector = normal.isDirected() ? 1 + normal.sector() : 0;
  return table.at(x.bin, (z.bin * sectors + sector) * quarters + 2 * x.half + z.half);
}

bool
isBefore(const EntropyCellSums& a, const EntropyCellSums& b)
{
  return a.column != b.column ? a.column < b.column : a.row < b.row;
}

bool
areOfOneBin(const EntropyCellSums& a, const EntropyCellSums& b)
{
  return a.column == b.column && (a.row & ~(quarters - 1)) == (b.row & ~(quarters - 1));
}

EntropyCell
toCell(const EntropyCellSums& sums, double bin_size, double unit)
{
  const auto weight = static_cast<double>(sums.weight);
  const double share = 1 / (2 * steps * weight);
  const std::int64_t row =
      (sums.row & ~(sectors * quarters - 1)) / (sectors * quarters);
  EntropyCell cell;
  cell.weight = weight * unit;
  cell.x = bin_size *
           (static_cast<double>(sums.column) + share * static_cast<double>(sums.x));
  cell.z = bin_size * (static_cast<double>(row) + share * static_cast<double>(sums.z));
  cell.direction = sums.normal_x == 0 && sums.normal_z == 0
                       ? std::nan("")
                       : std::atan2(static_cast<double>(sums.normal_z),
                                    static_cast<double>(sums.normal_x));
  return cell;
}

/** Adds cells [first, last), which are the quarters of one bin: they are merged to one
 * cell if none of them contains half of the weight. */
void
addCells(EntropyCellSums* first,
         EntropyCellSums* last,
         double bin_size,
         double unit,
         EntropyCells& to)
{
  EntropyCellSums all = *first;
  std::uint64_t maximum = first->weight;
  for (const EntropyCellSums* quarter = first + 1; quarter < last; ++quarter) {
    maximum = std::max(maximum, quarter->weight);
    all.weight += quarter->weight;
    all.x += quarter->x;
    all.z += quarter->z;
    all.normal_x += quarter->normal_x;
    all.normal_z += quarter->normal_z;
  }
  if (2 * maximum < all.weight) {
    to.cells.push_back(toCell(all, bin_size, unit));
    return;
  }
  for (const EntropyCellSums* quarter = first; quarter < last; ++quarter)
    to.cells.push_back(toCell(*quarter, bin_size, unit));
}

} // namespace

EntropyCells
aggregateCells(const PointView& points,
               const PointView& normals,
               const MapEntropySettings& settings,
               const float* weights)
{
  const PointWeights integers(weights, largestWeight(weights, points.size()));
  EntropyCells result;
  result.points = points.size();
  EntropyCellTable table;
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
    const WallDirection normal =
        settings.direction_aware ? wallDirection(points, normals, i) : WallDirection();
    result.directed_points += normal.isDirected();
    const std::uint64_t weight = integers[i];
    if (weight == 0)
      continue;
    const BinCoordinate x(point[0], settings.bin_size);
    const BinCoordinate z(point[2], settings.bin_size);
    EntropyCellSums& cell = cellOf(table, x, z, normal);
    cell.weight += weight;
    cell.x += weight * x.place;
    cell.z += weight * z.place;
    if (!normal.isDirected())
      continue;
    const double factor = static_cast<double>(weight) * steps;
    cell.normal_x += static_cast<std::int64_t>(factor * normal.x);
    cell.normal_z += static_cast<std::int64_t>(factor * normal.z);
  }
  std::vector<EntropyCellSums>& cells = table.cells();
  std::sort(cells.begin(), cells.end(), isBefore);
  EntropyCellSums* const end = cells.data() + cells.size();
  for (EntropyCellSums* first = cells.data(); first != end;) {
    EntropyCellSums* last = first;
    while (last != end && areOfOneBin(*first, *last))
      ++last;
    addCells(first, last, settings.bin_size, integers.unit(), result);
    first = last;
  }
  return result;
}

} // namespace pcl::acmap
