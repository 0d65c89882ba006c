#include "unused_points.h"

#include "ball_visit.h"

namespace pcl::acmap::ACMAP_DEWALL {

bool
UnusedPoints::find(const UnusedQuery& query, std::vector<std::int32_t>& found)
{
  const std::int32_t leaf = tree_.leafOf(query.at);
  if (!isOwn(leaf))
    return walk(query, found);
  List& list = lists_[static_cast<std::size_t>(leaf - range_.first_leaf)];
  if (list.state == List::State::Unmade)
    makeList(leaf, list);
  if (list.state == List::State::Refused)
    return walk(query, found);
  found.clear();
  for (std::uint32_t m = list.begin; m < list.begin + list.size; ++m)
    if (!arrays_.isUsed(members_[m]))
      found.push_back(members_[m]);
  return true;
}

void
UnusedPoints::makeList(std::int32_t leaf, List& list)
{
  const Eigen::AlignedBox3d box = tree_.boxOfLeaf(leaf).cast<double>();
  const double radius = box.diagonal().norm() / 2 + size_.longestInLeaf(leaf);
  const bool is_all_in_range = walk({tree_.firstOfLeaf(leaf),
                                     box.center(),
                                     radius * (1 + 1e-6),
                                     Eigen::Vector3f::Zero()},
                                    near_);
  if (!is_all_in_range || near_.size() > List::max_size) {
    list.state = List::State::Refused;
    return;
  }
  list.state = List::State::Made;
  list.begin = static_cast<std::uint32_t>(members_.size());
  list.size = static_cast<std::uint8_t>(near_.size());
  members_.insert(members_.end(), near_.begin(), near_.end());
}

unsigned
UnusedPoints::membersWithUnused(int level, std::int32_t group) const
{
  const std::int32_t first = 8 * group;
  if (level > 2 || !isOwn(first << (3 * level - 3)) ||
      !isOwn(((first + 8) << (3 * level - 3)) - 1))
    return 0xff;
  unsigned bits = 0;
  for (unsigned lane = 0; lane < 8; ++lane) {
    const auto member = static_cast<std::size_t>(first) + lane;
    if (level == 1 ? arrays_.unused[member] != 0 : arrays_.unused_in_group[member] != 0)
      bits |= 1u << lane;
  }
  return bits;
}

bool
UnusedPoints::walk(const UnusedQuery& query, std::vector<std::int32_t>& found) const
{
  found.clear();
  bool is_all_in_range = true;
  const Eigen::Vector3f origin = tree_.position(query.at).cast<float>();
  const auto keep = [&](int level, std::int32_t group) {
    return membersBeyond(
               tree_.cells().boxes[level][group], origin.data(), query.inward.data()) &
           membersWithUnused(level, group);
  };
  const auto visit = [&](std::int32_t leaf, std::int32_t first, std::int32_t end) {
    unsigned unused = (1u << (end - first)) - 1;
    if (isOwn(leaf))
      unused = arrays_.unused[static_cast<std::size_t>(leaf)];
    else
      is_all_in_range = false;
    for (std::int32_t i = first; unused; ++i, unused >>= 1)
      if (unused & 1)
        found.push_back(i);
  };
  visitBall(tree_, query.at, query.centre, query.radius, keep, visit);
  return is_all_in_range;
}

} // namespace pcl::acmap::ACMAP_DEWALL
