#include "bag/frame_tree.h"

#include <algorithm>

namespace pcl::acmap {

namespace {

constexpr std::size_t max_depth = 100; // of the tree: a loop is none

/** \brief Names of frames began with a slash once. */
std::string
plainFrame(const std::string& frame)
{
  return frame.substr(std::min(frame.find_first_not_of('/'), frame.size()));
}

} // namespace

void
FrameTree::add(const RosTransform& transform, bool is_fixed)
{
  Edge& edge = edges_[plainFrame(transform.child)];
  const std::string parent = plainFrame(transform.header.frame);
  if (edge.poses.poses.empty()) {
    edge.parent = parent;
    edge.is_fixed = is_fixed;
  }
  if (edge.parent != parent || edge.is_fixed != is_fixed)
    return;
  if (is_fixed)
    edge.poses = {};
  edge.poses.stamps.push_back(transform.header.stamp);
  edge.poses.poses.push_back(transform.T_parent_child);
  edge.path.reset();
}

bool
FrameTree::hasParent(const std::string& frame) const
{
  return edges_.count(plainFrame(frame)) > 0;
}

std::string
FrameTree::rootOf(const std::string& frame) const
{
  std::string root = plainFrame(frame);
  for (std::size_t depth = 0; depth < max_depth; ++depth) {
    const auto edge = edges_.find(root);
    if (edge == edges_.end())
      break;
    root = edge->second.parent;
  }
  return root;
}

bool
FrameTree::moves(const std::string& frame) const
{
  std::string at = plainFrame(frame);
  for (std::size_t depth = 0; depth < max_depth; ++depth) {
    const auto edge = edges_.find(at);
    if (edge == edges_.end())
      return false;
    if (!edge->second.is_fixed)
      return true;
    at = edge->second.parent;
  }
  return false;
}

std::vector<FrameTree::Ancestor>
FrameTree::ancestorsOf(const std::string& frame, double stamp, bool& is_whole) const
{
  constexpr double max_gap = 0.2; // seconds between poses that are interpolated
  std::vector<Ancestor> ancestors = {
      {plainFrame(frame), Eigen::Isometry3d::Identity()}};
  is_whole = false;
  while (ancestors.size() < max_depth) {
    const auto found = edges_.find(ancestors.back().frame);
    if (found == edges_.end()) {
      is_whole = true;
      break;
    }
    const Edge& edge = found->second;
    if (!edge.path)
      edge.path.emplace(edge.poses, max_gap);
    const std::optional<Eigen::Isometry3d> T_parent_child =
        edge.is_fixed ? edge.poses.poses.front() : edge.path->at(stamp);
    if (!T_parent_child)
      break;
    ancestors.push_back(
        {edge.parent, *T_parent_child * ancestors.back().T_ancestor_frame});
  }
  return ancestors;
}

std::optional<Eigen::Isometry3d>
FrameTree::poseInRoot(const std::string& frame, double stamp) const
{
  bool is_whole = false;
  const Ancestor root = ancestorsOf(frame, stamp, is_whole).back();
  return is_whole ? std::optional(root.T_ancestor_frame) : std::nullopt;
}

std::optional<Eigen::Isometry3d>
FrameTree::relativePose(const std::string& a, const std::string& b, double stamp) const
{
  bool is_whole = false;
  const std::vector<Ancestor> above_a = ancestorsOf(a, stamp, is_whole);
  for (const Ancestor& above_b : ancestorsOf(b, stamp, is_whole)) {
    const auto common =
        std::find_if(above_a.begin(), above_a.end(), [&](const Ancestor& ancestor) {
          return ancestor.frame == above_b.frame;
        });
    if (common != above_a.end())
      return common->T_ancestor_frame.inverse() * above_b.T_ancestor_frame;
  }
  return {};
}

} // namespace pcl::acmap
