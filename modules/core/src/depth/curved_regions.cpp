#include "depth/tile_regions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::acmap::depth {

namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/** Deviation of the tiles of a region from its plane: a quadratic function of the image
 * position. */
struct Bend {
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX(); ///< of the maximum curvature
  double height = 0; ///< standard deviation of the quadratic part of the residuals, 1/m
  double sign = 0;   ///< of the residuals at both ends
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  Vector6 coefficients = Vector6::Zero();

  Vector6
  termsAt(const Eigen::Vector2d& place) const
  {
    const Eigen::Vector2d p = place - middle;
    Vector6 terms;
    terms << 1, p.x(), p.y(), p.x() * p.x(), p.x() * p.y(), p.y() * p.y();
    return terms;
  }
};

Eigen::Vector2d
placeOf(const TileMoments& tiles, std::uint32_t tile)
{
  return {static_cast<double>(tile % tiles.columns()),
          static_cast<double>(tile / tiles.columns())};
}

/** Fits the mean residuals of the tiles. */
Bend
bendOf(const TileMoments& tiles, const TileRegion& region)
{
  Bend bend;
  const double count = static_cast<double>(region.tiles.size());
  for (const std::uint32_t tile : region.tiles)
    bend.middle += placeOf(tiles, tile) / count;
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Vector6 right = Vector6::Zero();
  for (const std::uint32_t tile : region.tiles) {
    const Vector6 terms = bend.termsAt(placeOf(tiles, tile));
    matrix += terms * terms.transpose();
    right += residualOf(tiles[tile], region.fit.plane).mean * terms;
  }
  matrix.diagonal().array() += 1e-9;
  bend.coefficients = matrix.ldlt().solve(right);
  const Vector6& c = bend.coefficients;
  double sum = 0, squares = 0;
  for (const std::uint32_t tile : region.tiles) {
    const double bent = bend.termsAt(placeOf(tiles, tile)).tail<3>().dot(c.tail<3>());
    sum += bent;
    squares += bent * bent;
  }
  bend.height = std::sqrt(std::max(squares / count - sum * sum / count / count, 0.0));
  Eigen::Matrix2d hessian;
  hessian << 2 * c[3], c[4], c[4], 2 * c[5];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(hessian);
  const Eigen::Array2d bends = axes.eigenvalues().cwiseAbs();
  const int maximum = bends[0] > bends[1] ? 0 : 1;
  bend.direction = axes.eigenvectors().col(maximum);
  bend.sign = axes.eigenvalues()[maximum] < 0 ? -1 : 1;
  return bend;
}

/** Ends of a region in the direction of its curvature. */
struct Ends {
  std::array<std::size_t, 2> ended{}; ///< number of border tiles at either end
  /** \brief Number of those where the surface continues with the same curvature. */
  std::array<std::size_t, 2> went_on{};
  /** \brief Number of those that are beside a curved surface. */
  std::array<std::size_t, 2> curved{};

  bool
  goesOn(std::size_t end) const
  {
    return ended[end] > 0 && 2 * went_on[end] > ended[end];
  }

  bool
  isBesideCurved(std::size_t end) const
  {
    return 2 * curved[end] > ended[end];
  }
};

/** State of a tile with respect to the region that is being tested. */
enum class TileRole : std::uint8_t { Other, Inside, Curved };

/** Examines the tiles beyond the ends. At an edge between planes the surface does not
 * continue with the same curvature. */
Ends
endsOf(const TileMoments& tiles,
       double sigma,
       const TileRegion& region,
       const std::vector<TileRole>& roles,
       const Bend& bend)
{
  // in standard deviations
  constexpr double left_plane = 1.8;
  constexpr double band = 2.5;
  // minimum cosine between a step and the direction of the curvature
  constexpr double along = 0.7;
  constexpr double fewest_pixels = 16;
  Ends ends;
  const auto look =
      [&](std::int64_t dx, std::int64_t dy, bool exists, std::size_t beside) {
        const double cosine = bend.direction.dot(
            Eigen::Vector2d(static_cast<double>(dx), static_cast<double>(dy)));
        if (std::abs(cosine) < along || (exists && roles[beside] == TileRole::Inside))
          return;
        const std::size_t end = cosine > 0 ? 1 : 0;
        ++ends.ended[end];
        if (!exists || tiles[beside].count < fewest_pixels)
          return;
        ends.curved[end] += roles[beside] == TileRole::Curved ? 1 : 0;
        const Vector6 terms =
            bend.termsAt(placeOf(tiles, static_cast<std::uint32_t>(beside)));
        const double off = residualOf(tiles[beside], region.fit.plane).mean;
        if (off * bend.sign > left_plane * sigma &&
            std::abs(off - terms.dot(bend.coefficients)) < band * sigma)
          ++ends.went_on[end];
      };
  for (const std::uint32_t tile : region.tiles) {
    const std::size_t column = tile % tiles.columns(), row = tile / tiles.columns();
    look(-1, 0, column > 0, tile - 1);
    look(1, 0, column + 1 < tiles.columns(), tile + 1);
    look(0, -1, row > 0, tile - tiles.columns());
    look(0, 1, row + 1 < tiles.rows(), tile + tiles.columns());
  }
  return ends;
}

/** Is the region curved, and does its surface continue at both ends, or at one end into
 * a region that is already known to be curved? */
bool
isCurved(const TileMoments& tiles,
         const PixelDeviation& deviation,
         const TileRegion& region,
         std::vector<TileRole>& roles)
{
  constexpr double min_bend = 0.4; // standard deviations; flat regions are below
  constexpr std::size_t fewest_tiles = 9;
  if (region.tiles.size() < fewest_tiles)
    return false;
  const Bend bend = bendOf(tiles, region);
  const double sigma = deviation.on(region);
  if (bend.height < min_bend * sigma)
    return false;
  for (const std::uint32_t tile : region.tiles)
    roles[tile] = TileRole::Inside;
  const Ends ends = endsOf(tiles, sigma, region, roles, bend);
  const bool is_curved = (ends.goesOn(0) && ends.goesOn(1)) ||
                         (ends.goesOn(0) && ends.isBesideCurved(0)) ||
                         (ends.goesOn(1) && ends.isBesideCurved(1));
  for (const std::uint32_t tile : region.tiles)
    roles[tile] = is_curved ? TileRole::Curved : TileRole::Other;
  return is_curved;
}

} // namespace

std::size_t
dropCurvedRegions(const TileMoments& tiles,
                  const PixelDeviation& deviation,
                  std::vector<TileRegion>& regions)
{
  std::vector<TileRole> roles(tiles.size(), TileRole::Other);
  const std::size_t all = regions.size();
  for (std::size_t before = all + 1; regions.size() < before;) {
    before = regions.size();
    regions.erase(std::remove_if(regions.begin(),
                                 regions.end(),
                                 [&](const TileRegion& region) {
                                   return isCurved(tiles, deviation, region, roles);
                                 }),
                  regions.end());
  }
  return all - regions.size();
}

} // namespace pcl::acmap::depth
