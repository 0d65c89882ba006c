#include "flat_patches.h"

#include "ball_visit.h"
#include "free_space.h"

#include <pcl/core/impl/parallel.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

class FlatPatches {
public:
  FlatPatches(const PointTree& tree, const Spacing& spacing, const PointView& given)
  : tree_(tree)
  , spacing_(spacing)
  , normals_(static_cast<std::size_t>(tree.size()))
  , is_done_(static_cast<std::size_t>(tree.size()))
  {
    parallelForChunks(normals_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        normals_[i] = chooseNormal(static_cast<std::int32_t>(i), given);
    });
    members_.reserve(normals_.size());
    for (std::int32_t seed = 0; seed < tree.size(); ++seed)
      if (isFlat(seed) && !is_done_[static_cast<std::size_t>(seed)]) {
        firsts_.push_back(members_.size());
        growFrom(seed);
      }
    firsts_.push_back(members_.size());
  }

  LargeVector<Eigen::Vector3f>
  turned(const Eigen::Vector3d& up) &&
  {
    const FreeSpace space(tree_, normals_, up);
    const std::size_t patches = firsts_.size() - 1;
    std::vector<float> sides(patches);
    oneapi::tbb::parallel_for(std::size_t{0}, patches, [&](std::size_t patch) {
      sides[patch] = sideOf(patch, space);
      pollRun();
    });
    std::fill(is_done_.begin(), is_done_.end(), 0);
    LargeVector<std::int32_t> turned;
    turned.reserve(normals_.size());
    for (std::size_t patch = 0; patch < patches; ++patch)
      for (std::size_t k = firsts_[patch]; sides[patch] != 0 && k < firsts_[patch + 1];
           ++k) {
        normalOf(members_[k]) *= sides[patch];
        is_done_[static_cast<std::size_t>(members_[k])] = true;
        turned.push_back(members_[k]);
      }
    turnNeighbours(turned);
    return std::move(normals_);
  }

private:
  double
  eighthNeighbour(std::int32_t i) const
  {
    return spacing_.eighth[static_cast<std::size_t>(tree_.leafOf(i))];
  }

  Eigen::Vector3f&
  normalOf(std::int32_t i)
  {
    return normals_[static_cast<std::size_t>(i)];
  }

  bool
  isFlat(std::int32_t i)
  {
    return !normalOf(i).isZero(0);
  }

  /** Calls visit (j) for the neighbours of a point, which are about 14 on a surface. */
  template <typename Visit>
  void
  visitNeighbours(std::int32_t i, const Visit& visit) const
  {
    constexpr double neighbourhood = 1.5; // distances to the eighth neighbour
    const Eigen::Vector3d centre = tree_.position(i);
    const double radius = neighbourhood * eighthNeighbour(i);
    visitBall(tree_,
              i,
              centre,
              radius,
              [&](std::int32_t, std::int32_t first, std::int32_t end) {
                for (std::int32_t j = first; j < end; ++j)
                  if ((tree_.position(j) - centre).squaredNorm() <= radius * radius)
                    visit(j);
              });
  }

  /** That of a point, or a fitted one if it has none. */
  Eigen::Vector3f
  chooseNormal(std::int32_t i, const PointView& given) const
  {
    const Eigen::Vector3f normal =
        given.size() > 0
            ? usableNormal(given[static_cast<std::size_t>(tree_.source(i))])
            : Eigen::Vector3f::Zero();
    return normal.isZero(0) ? fitNormal(i) : normal;
  }

  /** \return zero where the neighbours are not in a plane, or on a line */
  Eigen::Vector3f
  fitNormal(std::int32_t i) const
  {
    constexpr int min_neighbours = 5;
    constexpr double flat = 0.04, wide = 0.1; // squared, of the next extent
    int count = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    const Eigen::Vector3d centre = tree_.position(i);
    visitNeighbours(i, [&](std::int32_t j) {
      const Eigen::Vector3d way = tree_.position(j) - centre;
      sum += way;
      squares += way * way.transpose();
      ++count;
    });
    if (count < min_neighbours)
      return Eigen::Vector3f::Zero();
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(squares - sum * sum.transpose() / count);
    const Eigen::Vector3d& extents = solver.eigenvalues();
    if (!(extents[0] <= flat * extents[1]) || !(extents[1] >= wide * extents[2]))
      return Eigen::Vector3f::Zero();
    return solver.eigenvectors().col(0).normalized().cast<float>();
  }

  /** Adds the points of the patch of a point to the members, with the same side. */
  void
  growFrom(std::int32_t seed)
  {
    constexpr float similar = 0.95F, level = 0.3F; // cosine, sine
    is_done_[static_cast<std::size_t>(seed)] = true;
    members_.push_back(seed);
    for (std::size_t next = members_.size() - 1; next < members_.size(); ++next) {
      const std::int32_t i = members_[next];
      const Eigen::Vector3f normal = normalOf(i);
      const Eigen::Vector3d place = tree_.position(i);
      if (next % parallel_chunk == 0)
        pollRun();
      visitNeighbours(i, [&](std::int32_t j) {
        if (is_done_[static_cast<std::size_t>(j)] || !isFlat(j))
          return;
        const float cosine = normal.dot(normalOf(j));
        const Eigen::Vector3f way = (tree_.position(j) - place).cast<float>();
        if (std::abs(cosine) < similar ||
            std::abs(way.dot(normal)) > level * way.norm())
          return;
        if (cosine < 0)
          normalOf(j) *= -1;
        is_done_[static_cast<std::size_t>(j)] = true;
        members_.push_back(j);
      });
    }
  }

  /** \return 1 if the free space of a patch is in front of it, -1 if it is behind; 0 for a
   * small patch, or if that is unknown */
  float
  sideOf(std::size_t patch, const FreeSpace& space)
  {
    constexpr std::size_t min_size = 8, max_samples = 64;
    const std::size_t begin = firsts_[patch], size = firsts_[patch + 1] - begin;
    const std::size_t stride = (size + max_samples - 1) / max_samples;
    if (size < min_size)
      return 0;
    int side = 0;
    for (std::size_t k = 0; k < size; k += stride) {
      const std::int32_t i = members_[begin + k];
      side += space.sideOf(i, normalOf(i).cast<double>(), eighthNeighbour(i));
    }
    return static_cast<float>((side > 0) - (side < 0));
  }

  /** Turns the other points by their neighbours; those that have none become zero.
   * \param[in] turned the points that are done */
  void
  turnNeighbours(LargeVector<std::int32_t>& turned)
  {
    for (std::size_t next = 0; next < turned.size(); ++next) {
      const Eigen::Vector3f normal = normalOf(turned[next]);
      if (next % parallel_chunk == 0)
        pollRun();
      visitNeighbours(turned[next], [&](std::int32_t j) {
        if (is_done_[static_cast<std::size_t>(j)])
          return;
        is_done_[static_cast<std::size_t>(j)] = true;
        if (!isFlat(j))
          normalOf(j) = normal;
        else if (normal.dot(normalOf(j)) < 0)
          normalOf(j) *= -1;
        turned.push_back(j);
      });
    }
    for (std::size_t i = 0; i < normals_.size(); ++i)
      if (!is_done_[i])
        normals_[i].setZero();
  }

  const PointTree& tree_;
  const Spacing& spacing_;
  LargeVector<Eigen::Vector3f> normals_;
  LargeVector<std::uint8_t> is_done_;
  LargeVector<std::int32_t> members_; ///< of the patches, one after the other
  std::vector<std::size_t> firsts_;   ///< where the members of a patch begin
};

} // namespace

LargeVector<Eigen::Vector3f>
freeSpaceNormals(const PointTree& tree,
                 const Spacing& spacing,
                 const PointView& normals,
                 const Eigen::Vector3d& up)
{
  return FlatPatches(tree, spacing, normals).turned(up);
}

} // namespace pcl::acmap::ACMAP_DEWALL
