#include "cylinders/points_beside.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::cylinders {
namespace {

/** The part of space beside a cylinder. */
class BesideRegion {
public:
  BesideRegion(const RawCloud& source,
               const Cylinder& cylinder,
               const CylinderReach& reach)
  : cylinder_(cylinder)
  {
    const double band = 8 * source.sigma + 2 * source.spacing;
    low_ = reach.low - band;
    high_ = reach.high + band;
    off_ = band + max_radius_change * cylinder.radius;
  }

  /** \return false for NaN */
  bool
  contains(double along, double off) const
  {
    return along > low_ && along < high_ && std::abs(off) < off_;
  }

  /** Is a ball outside for certain? */
  bool
  isBeyond(const Eigen::Vector3d& center, double radius) const
  {
    constexpr double rounding = 1e-6;
    const double slack =
        radius + rounding * (radius + (center - cylinder_.point).norm());
    const double along = cylinder_.along(center);
    return along + slack < low_ || along - slack > high_ ||
           std::abs(cylinder_.distance(center)) - slack > off_;
  }

private:
  const Cylinder& cylinder_;
  double low_, high_, off_;
};

void
join(const PointsBeside& more, PointsBeside& all)
{
  all.free.insert(all.free.end(), more.free.begin(), more.free.end());
  all.on += more.on;
  all.free_on += more.free_on;
  all.planes.insert(more.planes.begin(), more.planes.end());
}

} // namespace

SourceBlocks::SourceBlocks(const RawCloud& source)
: source_(source)
, blocks_((source.points.size() + Block::length - 1) / Block::length)
{
  oneapi::tbb::parallel_for(std::size_t{0}, blocks_.size(), [&](std::size_t b) {
    const std::size_t end = std::min((b + 1) * Block::length, source.points.size());
    Eigen::AlignedBox3f box;
    for (std::size_t i = b * Block::length; i < end; ++i)
      if (source.points[i].allFinite())
        box.extend(source.points[i]);
    blocks_[b].radius = -1;
    if (box.isEmpty())
      return;
    const Eigen::Vector3d low = box.min().cast<double>(),
                          high = box.max().cast<double>();
    blocks_[b] = {(low + high) / 2, (high - low).norm() / 2};
  });
}

PointsBeside
SourceBlocks::beside(const PointLabels& owners,
                     const std::vector<std::int32_t>& replaced,
                     const Cylinder& cylinder,
                     const CylinderReach& reach) const
{
  constexpr double gate = 2; // sigmas
  const BesideRegion region(source_, cylinder, reach);
  const Development development(cylinder);
  std::vector<std::size_t> near;
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    if (blocks_[b].radius >= 0 &&
        !region.isBeyond(blocks_[b].center, blocks_[b].radius))
      near.push_back(b);
  const auto addPoint = [&](std::size_t i, PointsBeside& beside) {
    const Eigen::Vector3d point = source_.points[i].cast<double>();
    const double off = cylinder.distance(point);
    if (!region.contains(cylinder.along(point), off))
      return;
    const std::int32_t label = source_.labels[i];
    const bool is_free =
        owners[i] < 0 &&
        (label < 0 ||
         std::find(replaced.begin(), replaced.end(), label) != replaced.end());
    if (is_free)
      beside.free.push_back(static_cast<std::int32_t>(i));
    else if (label >= 0)
      beside.planes.insert(label);
    if (std::abs(off) > gate * source_.sigma)
      return;
    const double turn = development.angle(cylinder.across(point)) - reach.arc_begin;
    if (turn - 2 * M_PI * std::floor(turn / (2 * M_PI)) > reach.arc_length)
      return;
    ++beside.on;
    beside.free_on += is_free ? 1 : 0;
  };
  constexpr std::size_t of_a_part = 64; // blocks
  std::vector<PointsBeside> parts((near.size() + of_a_part - 1) / of_a_part);
  oneapi::tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t p) {
    const std::size_t end = std::min((p + 1) * of_a_part, near.size());
    for (std::size_t k = p * of_a_part; k < end; ++k) {
      const std::size_t first = near[k] * Block::length;
      const std::size_t last = std::min(first + Block::length, source_.points.size());
      for (std::size_t i = first; i < last; ++i)
        addPoint(i, parts[p]);
    }
  });
  PointsBeside all;
  for (const PointsBeside& part : parts)
    join(part, all);
  return all;
}

} // namespace pcl::acmap::cylinders
