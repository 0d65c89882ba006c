#include "motion/pose_chain.h"

#include <utility>

namespace pcl::acmap {

void
PoseChain::add(OdometryView now)
{
  for (auto anchor = anchors_.rbegin(); anchor != anchors_.rend(); ++anchor)
    if (const auto T_before_now = estimate_(now, anchor->view)) {
      const Eigen::Isometry3d T_map_now = anchor->T_map_camera * *T_before_now;
      if (!has_begun_)
        beginWith(std::move(*anchor));
      keep_(now, T_map_now);
      hold({std::move(now), T_map_now});
      return;
    }
  if (!has_begun_)
    hold({std::move(now), Eigen::Isometry3d::Identity()});
}

void
PoseChain::beginWith(Anchor first)
{
  has_begun_ = true;
  keep_(first.view, first.T_map_camera);
  anchors_.clear();
  hold(std::move(first));
}

void
PoseChain::hold(Anchor anchor)
{
  constexpr std::size_t max_anchors = 3;
  anchors_.push_back(std::move(anchor));
  if (anchors_.size() > max_anchors)
    anchors_.pop_front();
}

} // namespace pcl::acmap
