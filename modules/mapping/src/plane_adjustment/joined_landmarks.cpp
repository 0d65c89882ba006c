#include "joined_landmarks.h"

#include "map_cells.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::acmap {
namespace {

/** Sums of a landmark or of several ones, relative to a place, along two axes of a plane
 * and its normal. */
struct PlaneSums {
  Eigen::Matrix4d sums = Eigen::Matrix4d::Zero();

  /** chi^2 of the best plane. */
  double
  cost() const
  {
    const int use[3] = {0, 1, 3};
    Eigen::Matrix3d products;
    Eigen::Vector3d right;
    for (int a = 0; a < 3; ++a) {
      right[a] = sums(use[a], 2);
      for (int b = 0; b < 3; ++b)
        products(a, b) = sums(use[a], use[b]);
    }
    const Eigen::Vector3d plane = products.ldlt().solve(right);
    const double square = 1 + plane.head<2>().squaredNorm();
    return std::max(0.0, sums(2, 2) - plane.dot(right)) / square;
  }
};

class Joining {
public:
  Joining(const std::vector<Landmark>& landmarks, const Poses& poses)
  : landmarks_(landmarks)
  , poses_(poses)
  , cells_(cell_edge)
  , is_taken_(landmarks.size(), 0)
  {
    for (std::size_t i = 0; i < landmarks.size(); ++i)
      cells_.add(landmarks[i].center, i);
  }

  std::vector<Landmark>
  run()
  {
    std::vector<double> weights;
    for (const Landmark& landmark : landmarks_) {
      double weight = 0;
      for (const LandmarkView& view : landmark.views)
        weight += view.cluster(3, 3);
      weights.push_back(weight);
    }
    std::vector<std::size_t> order(landmarks_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return weights[a] > weights[b];
    });
    std::vector<Landmark> joined;
    for (const std::size_t seed : order)
      if (!is_taken_[seed])
        joined.push_back(grow(seed));
    return joined;
  }

private:
  static constexpr double cell_edge = 1.2; ///< metres, to what continues a landmark

  PlaneSums
  sumsOf(const Landmark& landmark,
         const Eigen::Matrix3d& axes,
         const Eigen::Vector3d& origin) const
  {
    PlaneSums result;
    for (const LandmarkView& view : landmark.views) {
      const Eigen::Isometry3d& pose = poses_[view.view];
      Eigen::Matrix4d local = Eigen::Matrix4d::Identity();
      local.topLeftCorner<3, 3>() = axes * pose.linear();
      local.topRightCorner<3, 1>() = axes * (pose.translation() - origin);
      result.sums.noalias() += local * view.cluster * local.transpose();
    }
    return result;
  }

  Landmark
  grow(std::size_t seed)
  {
    constexpr double reach = 20;          // metres
    constexpr double min_cosine = 0.9986; // 3 degrees
    constexpr double max_increase = 16;   // of chi^2, by 3 degrees of freedom: .1 %
    const Landmark& first = landmarks_[seed];
    Eigen::Matrix3d axes; // rows: two along the plane, its normal
    axes.row(0) = first.normal.unitOrthogonal();
    axes.row(1) = first.normal.cross(Eigen::Vector3d(axes.row(0)));
    axes.row(2) = first.normal;
    PlaneSums all = sumsOf(first, axes, first.center);
    double cost = all.cost();
    std::vector<std::size_t> members{seed};
    is_taken_[seed] = 1;
    std::vector<std::size_t> near;
    for (std::size_t next = 0; next < members.size(); ++next) {
      const Eigen::Vector3d center = landmarks_[members[next]].center;
      cells_.collect(center, near);
      for (const std::size_t i : near) {
        const Landmark& other = landmarks_[i];
        if (is_taken_[i] || (other.center - center).norm() > cell_edge ||
            (other.center - first.center).norm() > reach ||
            other.normal.dot(first.normal) < min_cosine)
          continue;
        PlaneSums with = sumsOf(other, axes, first.center);
        const double own = with.cost();
        with.sums += all.sums;
        const double together = with.cost();
        if (together > cost + own + max_increase)
          continue;
        all = with;
        cost = together;
        is_taken_[i] = 1;
        members.push_back(i);
      }
    }
    return join(members);
  }

  Landmark
  join(const std::vector<std::size_t>& members) const
  {
    Landmark joined = landmarks_[members.front()];
    for (std::size_t k = 1; k < members.size(); ++k) {
      const Landmark& other = landmarks_[members[k]];
      joined.pieces += other.pieces;
      joined.views.insert(joined.views.end(), other.views.begin(), other.views.end());
    }
    std::stable_sort(
        joined.views.begin(),
        joined.views.end(),
        [](const LandmarkView& a, const LandmarkView& b) { return a.view < b.view; });
    std::vector<LandmarkView> views;
    for (const LandmarkView& view : joined.views)
      if (views.empty() || views.back().view != view.view)
        views.push_back(view);
      else
        views.back().cluster += view.cluster;
    joined.views = std::move(views);
    return joined;
  }

  const std::vector<Landmark>& landmarks_;
  const Poses& poses_;
  MapCells cells_;
  std::vector<char> is_taken_;
};

} // namespace

std::vector<Landmark>
joinLandmarks(const std::vector<Landmark>& landmarks, const Poses& poses)
{
  return Joining(landmarks, poses).run();
}

} // namespace pcl::acmap
