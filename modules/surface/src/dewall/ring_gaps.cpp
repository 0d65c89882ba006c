#include "ring_gaps.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace pcl::acmap::ACMAP_DEWALL {

RingGaps::RingGaps(const PointView& scan, const Eigen::Vector3d& sensor)
: sensor_(sensor)
{
  for (axis_ = 2; axis_ >= 0 && rings_.empty(); --axis_)
    findRings(scan);
  ++axis_;
}

RingGaps::Sight
RingGaps::sightOf(const Eigen::Vector3d& ray) const
{
  return {std::asin(std::clamp(ray[axis_] / ray.norm(), -1.0, 1.0)),
          std::atan2(ray[(axis_ + 2) % 3], ray[(axis_ + 1) % 3]),
          ray};
}

void
RingGaps::findRings(const PointView& scan)
{
  constexpr std::size_t fewest_rings = 4, most_rings = 512;
  constexpr double share_of_extent = 1.0 / 2048;
  std::vector<Sight> sights;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const Eigen::Vector3d ray = scan[i].cast<double>() - sensor_;
    if (ray.allFinite() && !ray.isZero(0))
      sights.push_back(sightOf(ray));
  }
  if (sights.empty())
    return;
  std::stable_sort(sights.begin(), sights.end(), [](const Sight& a, const Sight& b) {
    return a.elevation < b.elevation;
  });
  const double gap =
      share_of_extent * (sights.back().elevation - sights.front().elevation);
  std::size_t largest = 0;
  for (auto begin = sights.begin(), end = begin; begin != sights.end(); begin = end) {
    Ring ring;
    do
      ring.elevation += end->elevation;
    while (++end != sights.end() && end->elevation - std::prev(end)->elevation <= gap);
    ring.sights.assign(begin, end);
    ring.elevation /= static_cast<double>(ring.sights.size());
    std::stable_sort(ring.sights.begin(),
                     ring.sights.end(),
                     [](const Sight& a, const Sight& b) { return a.turn < b.turn; });
    largest = std::max(largest, ring.sights.size());
    rings_.push_back(std::move(ring));
  }
  if (rings_.size() < fewest_rings || rings_.size() > most_rings ||
      2 * largest > sights.size())
    rings_.clear();
}

const RingGaps::Sight&
RingGaps::nearestOf(const Ring& ring, double turn)
{
  auto next = std::lower_bound(
      ring.sights.begin(), ring.sights.end(), turn, [](const Sight& sight, double at) {
        return sight.turn < at;
      });
  if (next == ring.sights.end() ||
      (next != ring.sights.begin() && turn - std::prev(next)->turn < next->turn - turn))
    --next;
  return *next;
}

double
RingGaps::distanceTo(const Ring& ring, const Sight& sight, double step) const
{
  constexpr double most_slanted = 5; // a surface that is seen from 11 degrees off
  const Sight& other = nearestOf(ring, sight.turn);
  const double distance = (other.ray - sight.ray).norm();
  return std::abs(other.turn - sight.turn) <= step &&
                 distance <= most_slanted * step * sight.ray.norm()
             ? distance
             : 0;
}

double
RingGaps::at(const Eigen::Vector3d& place) const
{
  if (rings_.empty())
    return 0;
  const Sight sight = sightOf(place - sensor_);
  auto own = std::lower_bound(
      rings_.begin(),
      rings_.end(),
      sight.elevation,
      [](const Ring& ring, double elevation) { return ring.elevation < elevation; });
  if (own == rings_.end() ||
      (own != rings_.begin() &&
       sight.elevation - std::prev(own)->elevation < own->elevation - sight.elevation))
    --own;
  const Sight& anchor = nearestOf(*own, sight.turn);
  double nearest = 0;
  const auto look = [&](const Ring& ring) {
    const double step = std::abs(ring.elevation - own->elevation);
    if ((anchor.ray - sight.ray).norm() > step * anchor.ray.norm())
      return;
    if (const double distance = distanceTo(ring, anchor, step); distance > 0)
      nearest = nearest == 0 ? distance : std::min(nearest, distance);
  };
  if (own != rings_.begin())
    look(*std::prev(own));
  if (std::next(own) != rings_.end())
    look(*std::next(own));
  return nearest;
}

} // namespace pcl::acmap::ACMAP_DEWALL
