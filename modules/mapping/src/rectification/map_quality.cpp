#include "rectification_steps.h"

#include "../entropy/planar_motion.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <tuple>

namespace pcl::acmap {
namespace {

constexpr double size = 0.4;        ///< metres, edge length of a neighbourhood
constexpr std::size_t fewest = 10;  ///< minimum number of points of a neighbourhood
constexpr double long_enough = 3;   ///< minimum variance of a wall, along / across
constexpr double resolution = 1e-3; ///< metres; finer structures are not resolved
constexpr std::size_t max_points = 1000000;

struct BinnedPoint {
  std::int64_t column, row;
  Eigen::Vector2d at;
};

/** Points of the map, grouped by neighbourhoods. */
std::vector<BinnedPoint>
sortedPlaces(const std::vector<LevelledPoints>& observations,
             const std::vector<PlanarPose>& poses)
{
  std::size_t points = 0;
  for (const LevelledPoints& seen : observations)
    points += seen.points.size();
  const std::size_t every = points / max_points + 1;
  std::vector<BinnedPoint> places;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const PlanarMotion motion(poses[i]);
    const std::vector<Eigen::Vector3f>& seen = observations[i].points;
    for (std::size_t p = 0; p < seen.size(); p += every) {
      if (!seen[p].allFinite() || seen[p].cwiseAbs().maxCoeff() > 1e9F)
        continue;
      const Eigen::Vector2d at = motion.place(seen[p][0], seen[p][2]);
      places.push_back({static_cast<std::int64_t>(std::floor(at[0] / size)),
                        static_cast<std::int64_t>(std::floor(at[1] / size)),
                        at});
    }
  }
  std::stable_sort(
      places.begin(), places.end(), [](const BinnedPoint& a, const BinnedPoint& b) {
        return std::tie(a.column, a.row) < std::tie(b.column, b.row);
      });
  return places;
}

/** A neighbourhood with the decomposed covariance of its points. */
struct Neighbourhood {
  double points, across, along; ///< variances, m^2
  std::complex<double> turn; ///< of its direction: equal for all axes of the building
};

Neighbourhood
neighbourhoodOf(const BinnedPoint* first, const BinnedPoint* last)
{
  const auto points = static_cast<double>(last - first);
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const BinnedPoint* place = first; place != last; ++place)
    mean += (place->at - first->at) / points;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const BinnedPoint* place = first; place != last; ++place) {
    const Eigen::Vector2d way = place->at - first->at - mean;
    covariance += way * way.transpose() / points;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(covariance);
  const Eigen::Vector2d axis = solver.eigenvectors().col(1);
  return {points,
          std::max(0.0, solver.eigenvalues()[0]),
          std::max(0.0, solver.eigenvalues()[1]),
          std::polar(1.0, 4 * std::atan2(axis[1], axis[0]))};
}

std::vector<Neighbourhood>
neighbourhoodsOf(const std::vector<BinnedPoint>& places)
{
  std::vector<Neighbourhood> all;
  const BinnedPoint* const end = places.data() + places.size();
  for (const BinnedPoint* first = places.data(); first != end;) {
    const BinnedPoint* last = first;
    while (last != end && last->column == first->column && last->row == first->row)
      ++last;
    if (static_cast<std::size_t>(last - first) >= fewest)
      all.push_back(neighbourhoodOf(first, last));
    first = last;
  }
  return all;
}

} // namespace

void
measureQuality(const std::vector<LevelledPoints>& observations,
               const std::vector<PlanarPose>& poses,
               MapEvidence& evidence)
{
  const auto all = neighbourhoodsOf(sortedPlaces(observations, poses));
  double points = 0, entropies = 0;
  std::complex<double> main_turn = 0;
  for (const Neighbourhood& one : all) {
    const double sharp = resolution * resolution;
    entropies +=
        one.points * (std::log(2 * M_PI * M_E) +
                      0.5 * std::log((one.across + sharp) * (one.along + sharp)));
    points += one.points;
    if (one.along > long_enough * one.across)
      main_turn += one.points * one.turn;
  }
  double wall_points = 0, variances = 0;
  const double cosine = std::cos(4 * 10 * M_PI / 180); // within 10 degrees of an axis
  for (const Neighbourhood& one : all)
    if (one.along > long_enough * one.across &&
        std::real(one.turn * std::conj(main_turn)) > cosine * std::abs(main_turn)) {
      wall_points += one.points;
      variances += one.points * one.across;
    }
  evidence.mean_map_entropy = points > 0 ? entropies / points : 0;
  evidence.orthogonal_variance = wall_points > 0 ? variances / wall_points : 0;
}

} // namespace pcl::acmap
