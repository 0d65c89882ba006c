#include "ray_contradictions.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace pcl::acmap {
namespace {

constexpr double cell_edge = 0.5;      // metres
constexpr std::size_t near_views = 16; // as for the rays of the entropy
constexpr double min_cosine = 0.6;     // of 53 degrees
/** Standard deviations of a piece's points; a rectangle ends at the square root of 3. */
constexpr double disc_reach = 1.5;

/** A piece in the map, as an ellipse of the size of its points' spread: a disc would
 * reach over the rims of narrow pieces, into the openings beside them. */
struct Disc {
  Disc(const PlanePiece& piece, const Eigen::Isometry3d& pose, std::size_t seen_by)
  : center(pose * piece.center)
  , normal(pose.linear() * piece.normal)
  , radius(piece.radius)
  , sigma(1 / std::sqrt(piece.weight()))
  , view(seen_by)
  {
    const Eigen::Matrix3d spread =
        piece.cluster.topLeftCorner<3, 3>() / piece.weight() -
        piece.center * piece.center.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
    for (int k = 0; k < 2; ++k)
      extents.row(k) = (pose.linear() * axes.eigenvectors().col(k + 1)).transpose() /
                       std::sqrt(std::max(axes.eigenvalues()[k + 1], 1e-12));
  }

  bool
  contains(const Eigen::Vector3d& place) const
  {
    return (extents * (place - center)).squaredNorm() < disc_reach * disc_reach;
  }

  Eigen::Vector3d center, normal;
  double radius, sigma; ///< metres
  std::size_t view;

private:
  Eigen::Matrix<double, 2, 3> extents; ///< axes divided by standard deviations, 1/m
};

using Cell = std::array<int, 3>;

Cell
cellOf(const Eigen::Vector3d& place)
{
  Cell cell;
  for (int axis = 0; axis < 3; ++axis)
    cell[static_cast<std::size_t>(axis)] =
        static_cast<int>(std::floor(std::clamp(place[axis] / cell_edge, -1e6, 1e6)));
  return cell;
}

std::uint64_t
keyOf(const Cell& cell)
{
  std::uint64_t key = 0;
  for (const int part : cell)
    key = key << 21 | (static_cast<std::uint64_t>(part + (1 << 20)) & 0x1fffff);
  return key;
}

/** Discs in all cells that they may reach. */
class DiscTable {
public:
  DiscTable(const PiecesOfViews& pieces, const Poses& poses)
  {
    for (std::size_t view = 0; view < pieces.size(); ++view)
      for (const PlanePiece& piece : pieces[view])
        discs_.emplace_back(piece, poses[view], view);
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      const Eigen::Vector3d reach =
          Eigen::Vector3d::Constant(disc_reach * discs_[i].radius);
      const Cell low = cellOf(discs_[i].center - reach),
                 high = cellOf(discs_[i].center + reach);
      for (int x = low[0]; x <= high[0]; ++x)
        for (int y = low[1]; y <= high[1]; ++y)
          for (int z = low[2]; z <= high[2]; ++z)
            cells_[keyOf({x, y, z})].push_back(i);
    }
  }

  template <typename Visit>
  void
  visit(const Cell& cell, const Visit& visit) const
  {
    const auto found = cells_.find(keyOf(cell));
    if (found != cells_.end())
      for (const std::size_t i : found->second)
        visit(discs_[i]);
  }

private:
  std::vector<Disc> discs_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

/** What the pieces of near and far views say about a ray. */
struct Verdict {
  bool contradicted[2] = {}, confirmed[2] = {};
};

Verdict
judgeRay(const DiscTable& table,
         std::size_t view,
         const Eigen::Vector3d& begin,
         const Eigen::Vector3d& end,
         double sigma)
{
  Verdict verdict;
  const double length = (end - begin).norm();
  const Eigen::Vector3d ray = (end - begin) / length;
  Cell last = cellOf(begin);
  bool is_first = true;
  constexpr double step = cell_edge / 4, beyond = 0.3;
  for (double at = 0; at < length + beyond; at += step) {
    const Cell cell = cellOf(begin + at * ray);
    if (!is_first && cell == last)
      continue;
    is_first = false;
    last = cell;
    table.visit(cell, [&](const Disc& disc) {
      if (disc.view == view)
        return;
      const double cosine = -ray.dot(disc.normal);
      if (cosine < min_cosine)
        return;
      const double crossing = (begin - disc.center).dot(disc.normal) / cosine;
      const Eigen::Vector3d place = begin + crossing * ray;
      if (!(crossing > 0) || !disc.contains(place))
        return;
      const double spare = 0.1 + 3 * std::hypot(sigma, disc.sigma);
      const std::size_t far =
          (view > disc.view ? view - disc.view : disc.view - view) > near_views;
      if (crossing < length - spare)
        verdict.contradicted[far] = true;
      else if (crossing < length + spare)
        verdict.confirmed[far] = true;
    });
  }
  return verdict;
}

} // namespace

RayContradictions
contradictionsOf(const PiecesOfViews& pieces, const Poses& poses)
{
  constexpr std::size_t max_rays = 192;
  const DiscTable table(pieces, poses);
  std::size_t contradicted[2] = {}, confirmed[2] = {};
  for (std::size_t view = 0; view < pieces.size(); ++view) {
    const std::size_t step = 1 + pieces[view].size() / max_rays;
    for (std::size_t i = 0; i < pieces[view].size(); i += step) {
      const PlanePiece& piece = pieces[view][i];
      const Verdict verdict = judgeRay(table,
                                       view,
                                       poses[view].translation(),
                                       poses[view] * piece.center,
                                       1 / std::sqrt(piece.weight()));
      for (int far = 0; far < 2; ++far) {
        contradicted[far] += verdict.contradicted[far];
        confirmed[far] += !verdict.contradicted[far] && verdict.confirmed[far];
      }
    }
  }
  const auto share = [&](int far) {
    const std::size_t sum = contradicted[far] + confirmed[far];
    return sum > 0 ? static_cast<double>(contradicted[far]) / static_cast<double>(sum)
                   : 0.0;
  };
  return {contradicted[0] + confirmed[0],
          contradicted[1] + confirmed[1],
          share(0),
          share(1)};
}

} // namespace pcl::acmap
