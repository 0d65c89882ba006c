#include "remaining_error.h"

#include "../entropy/planar_motion.h"
#include "../odometry_sigmas.h"
#include "entropy_search.h"

#include <pcl/core/impl/quantile.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace pcl::acmap {
namespace {

constexpr std::size_t points_of_pair = 300;
constexpr float level = 0.5F; ///< largest |cosine| of a wall's normal to the vertical
constexpr double alike = 0.9; ///< smallest cosine of two normals of a wall
constexpr double min_sigma = 0.01;  ///< metres, of a point across its wall
constexpr double points_alike = 16; ///< neighbouring points err alike: so many are one
constexpr double feigned = 0.01; ///< share of the information that noisy normals feign
constexpr double min_reach = 0.15; ///< metres, of a point from its wall; else 3 bins
constexpr double two_sigmas = 1.96;
constexpr Eigen::Index poses_asked = 16; ///< whose covariances are computed

using Pair = std::pair<std::size_t, std::size_t>;

/** The wall points of an observation in the map, by cells. */
class MappedWalls {
public:
  struct Point {
    Eigen::Vector2d place, normal, turn; ///< in the map; d place / d theta
    double height;
  };

  MappedWalls(const LevelledPoints& seen, const PlanarPose& pose, double cell)
  : cell_(cell)
  {
    const PlanarMotion motion(pose);
    for (std::size_t i = 0; i < seen.normals.size(); ++i) {
      const Eigen::Vector3f &point = seen.points[i], &normal = seen.normals[i];
      if (!point.allFinite() || !(std::abs(normal.y()) < level))
        continue;
      const Eigen::Vector2d flat(normal.x(), normal.z());
      points_.push_back({motion.place(point.x(), point.z()),
                         motion.rotation() * flat.normalized(),
                         motion.turn(point.x(), point.z()),
                         point.y()});
    }
    for (std::size_t i = 0; i < points_.size(); ++i)
      cells_[cellOf(points_[i].place, 0, 0)].push_back(i);
  }

  const std::vector<Point>&
  points() const
  {
    return points_;
  }

  /** The nearest point within a cell's edge whose normal is similar, or null. */
  const Point*
  match(const Point& point) const
  {
    const Point* best = nullptr;
    double nearest = cell_ * cell_;
    for (const int right : {-1, 0, 1})
      for (const int forward : {-1, 0, 1}) {
        const auto found = cells_.find(cellOf(point.place, right, forward));
        if (found == cells_.end())
          continue;
        for (const std::size_t i : found->second) {
          const Point& other = points_[i];
          const double distance = (other.place - point.place).squaredNorm() +
                                  std::pow(other.height - point.height, 2);
          if (distance < nearest && other.normal.dot(point.normal) > alike) {
            nearest = distance;
            best = &other;
          }
        }
      }
    return best;
  }

private:
  std::uint64_t
  cellOf(const Eigen::Vector2d& place, int right, int forward) const
  {
    const auto part = [&](double value, int offset) {
      return static_cast<std::uint64_t>(
                 static_cast<std::int64_t>(std::floor(value / cell_)) + offset) &
             0xffffffffU;
    };
    return part(place.x(), right) << 32 | part(place.y(), forward);
  }

  double cell_; ///< metres, edge length
  std::vector<Point> points_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

using Row = Eigen::Matrix<double, 1, 6>;

/** The information of a pair of poses, x, z and theta of each, and its gradient. */
struct Link {
  Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();

  void
  add(const Row& row, double residual, double weight)
  {
    information += weight * row.transpose() * row;
    gradient += weight * residual * row.transpose();
  }
};

/** Takes the information away that noise of the normals feigns in the direction which the
 * walls show least. */
void
removeFeigned(Link& link)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(
      Eigen::Matrix2d(link.information.topLeftCorner<2, 2>()));
  const double trace = eigen.eigenvalues().sum();
  if (!(trace > 0))
    return;
  Eigen::Matrix2d scale = Eigen::Matrix2d::Zero();
  for (const int i : {0, 1}) {
    const double value = eigen.eigenvalues()[i];
    const double kept =
        value > 0 ? std::sqrt(std::max(0.0, value - feigned * trace) / value) : 0;
    scale +=
        kept * eigen.eigenvectors().col(i) * eigen.eigenvectors().col(i).transpose();
  }
  Eigen::Matrix<double, 6, 6> both = Eigen::Matrix<double, 6, 6>::Identity();
  both.topLeftCorner<2, 2>() = scale;
  both.block<2, 2>(3, 3) = scale;
  link.information = both * link.information * both;
  link.gradient = both * link.gradient;
}

Link
linkOf(const MappedWalls& from, const MappedWalls& to)
{
  std::vector<Row> rows;
  std::vector<double> residuals, sizes;
  const std::size_t step = from.points().size() / points_of_pair + 1;
  for (std::size_t i = 0; i < from.points().size(); i += step) {
    const MappedWalls::Point& point = from.points()[i];
    const MappedWalls::Point* wall = to.match(point);
    if (!wall)
      continue;
    const Eigen::Vector2d& n = wall->normal;
    Row row;
    row << n.x(), n.y(), n.dot(point.turn), -n.x(), -n.y(), -n.dot(wall->turn);
    rows.push_back(row);
    residuals.push_back(n.dot(point.place - wall->place));
    sizes.push_back(std::abs(residuals.back()));
  }
  Link link;
  if (rows.empty())
    return link;
  constexpr double sigmas_of_median = 1.4826;
  const double sigma = std::max(min_sigma, sigmas_of_median * medianOf(sizes));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double outlying = std::pow(residuals[i] / (2 * sigma), 2);
    link.add(rows[i],
             residuals[i],
             1 / (sigma * sigma * points_alike * std::pow(1 + outlying, 2)));
  }
  removeFeigned(link);
  return link;
}

/** The action between two successive poses, as the odometry has it. */
Link
odometryLink(const PlanarPose& from,
             const PlanarPose& to,
             const PlanarAction& given,
             const OdometryNoise& noise)
{
  const PlanarAction action = actionBetween(from, to);
  const Eigen::Matrix<double, 3, 6> rows = partsOfAction(from, action);
  const double length = lengthSigma(noise, std::hypot(given.dx, given.dz));
  const double turn = turnSigma(noise, std::abs(given.dtheta));
  Link link;
  link.add(rows.row(0), action.dx - given.dx, 1 / (length * length));
  link.add(rows.row(1), action.dz - given.dz, 1 / (length * length));
  link.add(rows.row(2),
           std::remainder(action.dtheta - given.dtheta, 2 * M_PI),
           1 / (turn * turn));
  return link;
}

/** Pairs whose walls are compared. */
std::vector<Pair>
pairsOf(std::size_t poses)
{
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < poses; ++i)
    for (const std::size_t ahead : {1, 2, 4, 8})
      if (i + ahead < poses)
        pairs.emplace_back(i, i + ahead);
  return pairs;
}

/** The linear system of all poses but the first, which stays. */
class PoseSystem {
public:
  explicit PoseSystem(std::size_t poses)
  : gradient_(Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(poses - 1)))
  {}

  void
  add(const Pair& pair, const Link& link)
  {
    const Eigen::Index first[] = {3 * (static_cast<Eigen::Index>(pair.first) - 1),
                                  3 * (static_cast<Eigen::Index>(pair.second) - 1)};
    for (const int a : {0, 1})
      for (int i = 0; i < 3 && first[a] >= 0; ++i) {
        gradient_[first[a] + i] += link.gradient[3 * a + i];
        for (const int b : {0, 1})
          for (int j = 0; j < 3 && first[b] >= 0; ++j)
            entries_.emplace_back(
                first[a] + i, first[b] + j, link.information(3 * a + i, 3 * b + j));
      }
  }

  /** 95 % of the position of the pose that is known least, metres. */
  double
  largestError() const
  {
    Eigen::SparseMatrix<double> matrix(gradient_.size(), gradient_.size());
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    const Eigen::VectorXd moved = solver.solve(gradient_);
    const Eigen::Index poses = gradient_.size() / 3;
    const Eigen::Index asked = std::min(poses, poses_asked);
    double largest = 0;
    for (Eigen::Index k = 1; k <= asked; ++k) {
      const Eigen::Index pose = 3 * (k * poses / asked - 1);
      double variance = 0;
      for (const Eigen::Index axis : {0, 1})
        variance += solver.solve(
            Eigen::VectorXd::Unit(gradient_.size(), pose + axis))[pose + axis];
      largest = std::max(
          largest, moved.segment<2>(pose).norm() + two_sigmas * std::sqrt(variance));
    }
    return largest;
  }

private:
  Eigen::VectorXd gradient_;
  std::vector<Eigen::Triplet<double>> entries_;
};

} // namespace

std::optional<double>
remainingError(const std::vector<LevelledPoints>& observations,
               const std::vector<PlanarPose>& poses,
               const std::vector<PlanarPose>& given,
               const OdometryNoise& noise,
               double bin_size)
{
  if (poses.size() < 2 ||
      std::any_of(observations.begin(), observations.end(), [](const auto& seen) {
        return seen.normals.size() != seen.points.size();
      }))
    return std::nullopt;
  std::vector<std::optional<MappedWalls>> walls(poses.size());
  oneapi::tbb::parallel_for(std::size_t{0}, poses.size(), [&](std::size_t i) {
    walls[i].emplace(observations[i], poses[i], std::max(min_reach, 3 * bin_size));
  });
  const std::vector<Pair> pairs = pairsOf(poses.size());
  std::vector<Link> links(pairs.size());
  oneapi::tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t k) {
    links[k] = linkOf(*walls[pairs[k].first], *walls[pairs[k].second]);
  });
  PoseSystem system(poses.size());
  for (std::size_t k = 0; k < pairs.size(); ++k)
    system.add(pairs[k], links[k]);
  for (std::size_t t = 1; t < poses.size(); ++t)
    system.add(
        {t - 1, t},
        odometryLink(
            poses[t - 1], poses[t], actionBetween(given[t - 1], given[t]), noise));
  return system.largestError() + bin_size / 2; // the entropy does not see less
}

} // namespace pcl::acmap
