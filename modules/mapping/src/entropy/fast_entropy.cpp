#include "entropy_grid.h"
#include "map_extent.h"
#include "planar_motion.h"
#include "wall_direction.h"

#include <pcl/exceptions.h>
#include <pcl/mapping/map_entropy_kernel.h>

#include <oneapi/tbb/parallel_for.h>

#include <array>
#include <cmath>

namespace pcl::acmap {
namespace {

/** Quadratic B-spline: how a place u, in bins, is shared by three of them. */
struct Spline {
  explicit Spline(double u)
  : first(static_cast<std::int64_t>(std::floor(u)) - 1)
  {
    const double d = u - std::floor(u) - 0.5;
    shares = {0.5 * (0.5 - d) * (0.5 - d), 0.75 - d * d, 0.5 * (0.5 + d) * (0.5 + d)};
    slopes = {d - 0.5, -2 * d, d + 0.5};
  }

  std::int64_t first;
  std::array<double, 3> shares, slopes; ///< slopes: d share / d u
};

/** Where a cell lies in the grid under a pose. */
struct Placed {
  Placed(const EntropyCell& cell, const PlanarMotion& motion, double bin_size)
  : Placed(motion.place(cell.x, cell.z) / bin_size)
  {}

  explicit Placed(const Eigen::Vector2d& bins)
  : x(bins[0])
  , z(bins[1])
  {}

  Spline x, z;
};

int
layerOf(const Spline& angle, int k)
{
  const auto layer = (angle.first + k) % wall_directions;
  return static_cast<int>(layer < 0 ? layer + wall_directions : layer);
}

/** A cell with its share of one layer: once, or three times where it has a
 * direction. */
template <typename Visit>
void
forEachLayer(const EntropyCell& cell,
             const PlanarMotion& motion,
             bool direction_aware,
             const Visit& visit)
{
  if (!direction_aware)
    return visit(0, 1.0, 0.0);
  if (std::isnan(cell.direction))
    return visit(wall_directions, 1.0, 0.0);
  const Spline angle(motion.direction(cell.direction) * wall_directions / (2 * M_PI));
  for (int k = 0; k < 3; ++k)
    visit(layerOf(angle, k), angle.shares[k], angle.slopes[k]);
}

BinRange
rangeOf(const EntropyCells& observation, const PlanarMotion& motion, double bin_size)
{
  BinRange range;
  if (observation.cells.empty())
    return range;
  Eigen::Array2d least = motion.place(observation.cells[0].x, observation.cells[0].z);
  Eigen::Array2d most = least;
  for (const EntropyCell& cell : observation.cells) {
    const Eigen::Array2d place = motion.place(cell.x, cell.z);
    least = least.min(place);
    most = most.max(place);
  }
  const Placed first(least / bin_size);
  const Placed last(most / bin_size);
  range.add(first.x.first, first.z.first);
  range.add(last.x.first + 2, last.z.first + 2);
  return range;
}

void
fill(EntropyGrid& grid,
     const EntropyCells& observation,
     const PlanarMotion& motion,
     const MapEntropySettings& settings)
{
  for (const EntropyCell& cell : observation.cells) {
    const Placed placed(cell, motion, settings.bin_size);
    forEachLayer(
        cell, motion, settings.direction_aware, [&](int layer, double share, double) {
          for (int i = 0; i < 3; ++i) {
            const double part = cell.weight * share * placed.x.shares[i];
            double* bins = &grid.at(layer, placed.x.first + i, placed.z.first);
            for (int j = 0; j < 3; ++j)
              bins[j] += part * placed.z.shares[j];
          }
        });
  }
}

Eigen::Vector3d
gradientOf(EntropyGrid& sensitivities,
           const EntropyCells& observation,
           const PlanarMotion& motion,
           const MapEntropySettings& settings)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const EntropyCell& cell : observation.cells) {
    const Placed placed(cell, motion, settings.bin_size);
    double by_x = 0, by_z = 0, by_angle = 0; // d total / d place in bins, in layers
    forEachLayer(cell,
                 motion,
                 settings.direction_aware,
                 [&](int layer, double share, double slope) {
                   for (int i = 0; i < 3; ++i) {
                     const double* bins =
                         &sensitivities.at(layer, placed.x.first + i, placed.z.first);
                     double level = 0, rise = 0;
                     for (int j = 0; j < 3; ++j) {
                       level += placed.z.shares[j] * bins[j];
                       rise += placed.z.slopes[j] * bins[j];
                     }
                     by_x += share * placed.x.slopes[i] * level;
                     by_z += share * placed.x.shares[i] * rise;
                     by_angle += slope * placed.x.shares[i] * level;
                   }
                 });
    const Eigen::Vector2d force = Eigen::Vector2d(by_x, by_z) / settings.bin_size;
    const double turn = force.dot(motion.turn(cell.x, cell.z)) -
                        by_angle * wall_directions / (2 * M_PI);
    sum += cell.weight * Eigen::Vector3d(force[0], force[1], turn);
  }
  return sum;
}

void
count(const std::vector<EntropyCells>& observations, MapEntropyReport& report)
{
  report.observations += observations.size();
  for (const EntropyCells& observation : observations) {
    report.points += observation.points;
    report.invalid_points += observation.invalid_points;
    report.distant_points += observation.distant_points;
    report.directed_points += observation.directed_points;
    report.cells += observation.cells.size();
  }
}

} // namespace

MapEntropyTerms
mapEntropy(const std::vector<EntropyCells>& observations,
           const std::vector<Eigen::Vector3d>& poses,
           const MapEntropySettings& settings,
           MapEntropyReport& report,
           std::vector<Eigen::Vector3d>* gradient)
{
  requireSmoothing(settings);
  if (poses.size() != observations.size())
    throw BadArgumentException("each observation needs one pose");
  count(observations, report);
  const std::size_t size = observations.size();
  const std::vector<PlanarMotion> motions(poses.begin(), poses.end());
  std::vector<BinRange> ranges(size);
  oneapi::tbb::parallel_for(std::size_t{0}, size, [&](std::size_t i) {
    ranges[i] = rangeOf(observations[i], motions[i], settings.bin_size);
  });
  if (gradient)
    gradient->assign(size, Eigen::Vector3d::Zero());
  if (!canHaveGrid(ranges, settings, report))
    return {};

  BinRange all;
  for (const BinRange& range : ranges)
    all.add(range);
  EntropyGrid grid(all, settings);
  grid.allocate();
  grid.tell(report);
  MapExtent extent;
  double points = 0;
  for (std::size_t i = 0; i < size; ++i) {
    fill(grid, observations[i], motions[i], settings);
    for (const EntropyCell& cell : observations[i].cells) {
      extent.add(motions[i].place(cell.x, cell.z), cell.weight);
      points += cell.weight;
    }
  }
  grid.smooth();
  MapEntropyTerms terms = grid.terms(points);
  terms.dimensions = extent.dimensions(settings.bin_size);
  remarkOnMap(terms, settings, report);
  if (gradient) {
    grid.toSensitivities(points);
    oneapi::tbb::parallel_for(std::size_t{0}, size, [&](std::size_t i) {
      (*gradient)[i] = gradientOf(grid, observations[i], motions[i], settings) / points;
    });
  }
  return terms;
}

} // namespace pcl::acmap
