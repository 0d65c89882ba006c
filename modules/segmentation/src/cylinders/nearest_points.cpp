#include "cylinders/nearest_points.h"

#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>

namespace pcl::acmap::cylinders {
namespace {

constexpr std::size_t leaf_size = 12;

} // namespace

NearestPoints::NearestPoints(const LargeVector<Eigen::Vector3d>& points)
{
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite())
      order_.push_back(static_cast<std::int32_t>(i));
  axes_.resize(order_.size(), 0);
  arrange(points, 0, order_.size());
  places_.reserve(order_.size());
  for (const std::int32_t point : order_)
    places_.push_back(points[static_cast<std::size_t>(point)]);
}

void
NearestPoints::arrange(const LargeVector<Eigen::Vector3d>& points,
                       std::size_t begin,
                       std::size_t end)
{
  if (end - begin <= leaf_size)
    return;
  const auto placeOf = [&](std::int32_t i) -> const Eigen::Vector3d& {
    return points[static_cast<std::size_t>(i)];
  };
  Eigen::Vector3d low = placeOf(order_[begin]), high = low;
  for (std::size_t i = begin; i < end; ++i) {
    low = low.cwiseMin(placeOf(order_[i]));
    high = high.cwiseMax(placeOf(order_[i]));
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const std::size_t middle = (begin + end) / 2;
  const auto at = [&](std::size_t i) {
    return order_.begin() + static_cast<std::ptrdiff_t>(i);
  };
  std::nth_element(at(begin), at(middle), at(end), [&](std::int32_t a, std::int32_t b) {
    const double x = placeOf(a)[axis], y = placeOf(b)[axis];
    return x != y ? x < y : a < b;
  });
  axes_[middle] = static_cast<std::int8_t>(axis);
  const auto arrangeLower = [&] { arrange(points, begin, middle); };
  const auto arrangeUpper = [&] { arrange(points, middle + 1, end); };
  constexpr std::size_t worth_a_task = 8192;
  if (end - begin > worth_a_task)
    oneapi::tbb::parallel_invoke(arrangeLower, arrangeUpper);
  else {
    arrangeLower();
    arrangeUpper();
  }
}

void
NearestPoints::Search::consider(const Candidate& candidate)
{
  if (!isFull())
    nearest.push_back(candidate);
  else if (!(candidate < nearest.back()))
    return;
  std::size_t at = nearest.size() - 1;
  for (; at > 0 && candidate < nearest[at - 1]; --at)
    nearest[at] = nearest[at - 1];
  nearest[at] = candidate;
}

void
NearestPoints::visit(std::size_t begin, std::size_t end, Search& search) const
{
  if (end - begin <= leaf_size) {
    for (std::size_t i = begin; i < end; ++i)
      consider(i, search);
    return;
  }
  const std::size_t middle = (begin + end) / 2;
  const auto axis = static_cast<Eigen::Index>(axes_[middle]);
  const double off = search.place[axis] - places_[middle][axis];
  const bool is_below = off < 0;
  visit(is_below ? begin : middle + 1, is_below ? middle : end, search);
  if (search.isFull() && search.nearest.back().squared_distance < off * off)
    return;
  consider(middle, search);
  visit(is_below ? middle + 1 : begin, is_below ? end : middle, search);
}

void
NearestPoints::find(const Eigen::Vector3d& place,
                    std::size_t count,
                    std::vector<std::int32_t>& found) const
{
  found.clear();
  if (count == 0 || !place.allFinite())
    return;
  Search search{place, count, {}};
  search.nearest.reserve(count);
  visit(0, order_.size(), search);
  for (const Candidate& candidate : search.nearest)
    found.push_back(candidate.point);
}

} // namespace pcl::acmap::cylinders
