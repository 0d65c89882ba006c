#include "cylinders/nearest_points.h"

#include <algorithm>

namespace pcl::acmap::cylinders {
namespace {

constexpr std::size_t leaf_size = 12;

} // namespace

NearestPoints::NearestPoints(const std::vector<Eigen::Vector3d>& points)
: points_(points)
{
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite())
      order_.push_back(static_cast<std::int32_t>(i));
  axes_.resize(order_.size(), 0);
  arrange(0, order_.size());
}

void
NearestPoints::arrange(std::size_t begin, std::size_t end)
{
  if (end - begin <= leaf_size)
    return;
  const auto placeOf = [&](std::int32_t i) -> const Eigen::Vector3d& {
    return points_[static_cast<std::size_t>(i)];
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
  arrange(begin, middle);
  arrange(middle + 1, end);
}

void
NearestPoints::visit(std::size_t begin,
                     std::size_t end,
                     const Eigen::Vector3d& place,
                     std::size_t count,
                     std::vector<Candidate>& heap) const
{
  const auto consider = [&](std::size_t i) {
    const std::int32_t point = order_[i];
    const Candidate candidate{
        (points_[static_cast<std::size_t>(point)] - place).squaredNorm(), point};
    if (heap.size() == count && !(candidate < heap.front()))
      return;
    if (heap.size() == count) {
      std::pop_heap(heap.begin(), heap.end());
      heap.pop_back();
    }
    heap.push_back(candidate);
    std::push_heap(heap.begin(), heap.end());
  };
  if (end - begin <= leaf_size) {
    for (std::size_t i = begin; i < end; ++i)
      consider(i);
    return;
  }
  const std::size_t middle = (begin + end) / 2;
  const auto axis = static_cast<Eigen::Index>(axes_[middle]);
  const double off =
      place[axis] - points_[static_cast<std::size_t>(order_[middle])][axis];
  const bool is_below = off < 0;
  visit(is_below ? begin : middle + 1, is_below ? middle : end, place, count, heap);
  if (heap.size() == count && heap.front().squared_distance < off * off)
    return;
  consider(middle);
  visit(is_below ? middle + 1 : begin, is_below ? end : middle, place, count, heap);
}

void
NearestPoints::find(const Eigen::Vector3d& place,
                    std::size_t count,
                    std::vector<std::int32_t>& found) const
{
  std::vector<Candidate> heap;
  heap.reserve(count);
  if (count > 0 && place.allFinite())
    visit(0, order_.size(), place, count, heap);
  std::sort_heap(heap.begin(), heap.end());
  found.clear();
  for (const Candidate& candidate : heap)
    found.push_back(candidate.point);
}

} // namespace pcl::acmap::cylinders
