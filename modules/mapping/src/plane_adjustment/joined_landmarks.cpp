#include "joined_landmarks.h"

#include "map_cells.h"
#include "plane_frame.h"

#include <algorithm>
#include <numeric>

namespace pcl::acmap {
namespace {

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

  Eigen::Matrix4d
  sumsOf(const Landmark& landmark, const PlaneFrame& frame) const
  {
    Eigen::Matrix4d sums = Eigen::Matrix4d::Zero();
    for (const LandmarkView& view : landmark.views)
      sums += frame.sumsOf(view.cluster, poses_[view.view]);
    return sums;
  }

  Landmark
  grow(std::size_t seed)
  {
    constexpr double reach = 20;          // metres
    constexpr double min_cosine = 0.9986; // 3 degrees
    constexpr double max_increase = 16;   // of chi^2, by 3 degrees of freedom: .1 %
    const Landmark& first = landmarks_[seed];
    const PlaneFrame frame(first.normal, first.center);
    Eigen::Matrix4d all = sumsOf(first, frame);
    double cost = HeightPlane(all).cost;
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
        const Eigen::Matrix4d own = sumsOf(other, frame), with = own + all;
        const double together = HeightPlane(with).cost;
        if (together > cost + HeightPlane(own).cost + max_increase)
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
