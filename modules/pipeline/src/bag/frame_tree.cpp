#include "bag/frame_tree.h"

#include <algorithm>

namespace pcl::acmap {

namespace {

constexpr std::size_t max_depth = 100; // of the tree: a loop is none
constexpr double max_gap_alone = 0.2;  // seconds to a pose that is not interpolated

/** \brief Names of frames began with a slash once. */
std::string
plainFrame(const std::string& frame)
{
  return frame.substr(std::min(frame.find_first_not_of('/'), frame.size()));
}

/** \brief Maximum time between poses that are interpolated, seconds: longer for poses that
 * come at a slow pace. */
double
maxGapOf(const std::vector<double>& stamps)
{
  constexpr double min_gap = max_gap_alone, max_gap = 2, in_paces = 1.5;
  std::vector<double> sorted = stamps, paces;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
    paces.push_back(sorted[i] - sorted[i - 1]);
  if (paces.empty())
    return min_gap;
  const auto middle = paces.begin() + static_cast<std::ptrdiff_t>(paces.size() / 2);
  std::nth_element(paces.begin(), middle, paces.end());
  return std::clamp(in_paces * *middle, min_gap, max_gap);
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
  edge.places.extend(transform.T_parent_child.translation());
  constexpr double same = 1e-9; // metres, and entries of the rotation
  edge.is_constant &= transform.T_parent_child.isApprox(edge.poses.poses.front(), same);
  edge.path.reset();
}

void
FrameTree::setTracked(const std::string& frame)
{
  if (const auto edge = edges_.find(plainFrame(frame)); edge != edges_.end())
    edge->second.is_tracked = true;
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
    if (edge->second.moves())
      return true;
    at = edge->second.parent;
  }
  return false;
}

std::string
FrameTree::trackedFrame(const std::string& root) const
{
  std::string tracked;
  double most = 1e-3; // metres
  for (const auto& [frame, edge] : edges_) {
    const double extent = edge.places.diagonal().norm();
    if (edge.moves() && (extent > most || (edge.is_tracked && tracked.empty())) &&
        rootOf(frame) != root) {
      most = std::max(extent, most);
      tracked = frame;
    }
  }
  return tracked;
}

std::size_t
FrameTree::posesOf(const std::string& frame) const
{
  const auto edge = edges_.find(plainFrame(frame));
  return edge == edges_.end() ? 0 : edge->second.poses.poses.size();
}

std::string
FrameTree::list() const
{
  constexpr std::size_t max_named = 20;
  std::string list;
  std::size_t named = 0;
  for (const auto& [frame, edge] : edges_) {
    if (named++ == max_named)
      return list + ", ...";
    list += (list.empty() ? "" : ", ") + frame +
            (edge.moves() ? " moves" : " is fixed") + " in " + edge.parent;
  }
  return list.empty() ? "none" : list;
}

std::optional<Eigen::Isometry3d>
FrameTree::poseAt(const Edge& edge, double stamp)
{
  if (edge.is_fixed || edge.is_constant)
    return edge.poses.poses.front();
  if (!edge.path)
    edge.path.emplace(edge.poses, maxGapOf(edge.poses.stamps), max_gap_alone);
  return edge.path->at(stamp);
}

std::vector<FrameTree::Ancestor>
FrameTree::ancestorsOf(const std::string& frame, double stamp, bool& is_whole) const
{
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
    const std::optional<Eigen::Isometry3d> T_parent_child = poseAt(edge, stamp);
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
