#include "point_tree.h"

#include <algorithm>

namespace pcl::acmap::test {

ReferenceTree::ReferenceTree(Points points)
: points_(std::move(points))
{
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (points_[i].allFinite())
      order_.push_back(static_cast<std::int32_t>(i));
  axis_.resize(order_.size());
  build(0, order_.size());
}

void
ReferenceTree::build(std::size_t begin, std::size_t end)
{
  if (end - begin <= leaf_size)
    return;
  Eigen::Vector3d minimum = points_[order_[begin]];
  Eigen::Vector3d maximum = minimum;
  for (std::size_t i = begin; i < end; ++i) {
    minimum = minimum.cwiseMin(points_[order_[i]]);
    maximum = maximum.cwiseMax(points_[order_[i]]);
  }
  int axis = 0;
  (maximum - minimum).maxCoeff(&axis);
  const std::size_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin,
                   order_.begin() + middle,
                   order_.begin() + end,
                   [&](std::int32_t a, std::int32_t b) {
                     return points_[a][axis] < points_[b][axis];
                   });
  axis_[middle] = static_cast<std::uint8_t>(axis);
  build(begin, middle);
  build(middle + 1, end);
}

std::int32_t
ReferenceTree::findWithin(const Eigen::Vector3d& center, double radius) const
{
  return radius > 0 ? findWithin(0, order_.size(), center, radius * radius) : -1;
}

std::int32_t
ReferenceTree::findWithin(std::size_t begin,
                          std::size_t end,
                          const Eigen::Vector3d& center,
                          double squared) const
{
  if (end - begin <= leaf_size) {
    for (std::size_t i = begin; i < end; ++i)
      if ((points_[order_[i]] - center).squaredNorm() < squared)
        return order_[i];
    return -1;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  const Eigen::Vector3d& pivot = points_[order_[middle]];
  if ((pivot - center).squaredNorm() < squared)
    return order_[middle];
  const double offset = center[axis_[middle]] - pivot[axis_[middle]];
  const bool below = offset < 0;
  const std::int32_t near = below ? findWithin(begin, middle, center, squared)
                                  : findWithin(middle + 1, end, center, squared);
  if (near >= 0 || offset * offset > squared)
    return near;
  return below ? findWithin(middle + 1, end, center, squared)
               : findWithin(begin, middle, center, squared);
}

std::vector<std::int32_t>
ReferenceTree::within(const Eigen::Vector3d& center, double radius) const
{
  std::vector<std::int32_t> found;
  within(0, order_.size(), center, radius * radius, found);
  return found;
}

void
ReferenceTree::within(std::size_t begin,
                      std::size_t end,
                      const Eigen::Vector3d& center,
                      double squared,
                      std::vector<std::int32_t>& found) const
{
  const auto offer = [&](std::int32_t index) {
    if ((points_[index] - center).squaredNorm() <= squared)
      found.push_back(index);
  };
  if (end - begin <= leaf_size) {
    std::for_each(order_.begin() + begin, order_.begin() + end, offer);
    return;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  offer(order_[middle]);
  const int axis = axis_[middle];
  const double offset = center[axis] - points_[order_[middle]][axis];
  if (offset <= 0 || offset * offset <= squared)
    within(begin, middle, center, squared, found);
  if (offset >= 0 || offset * offset <= squared)
    within(middle + 1, end, center, squared, found);
}

std::vector<std::pair<double, std::int32_t>>
ReferenceTree::nearest(const Eigen::Vector3d& query, std::size_t count) const
{
  Heap heap;
  if (count > 0)
    nearest(0, order_.size(), query, count, heap);
  std::sort_heap(heap.begin(), heap.end());
  return heap;
}

void
ReferenceTree::nearest(std::size_t begin,
                       std::size_t end,
                       const Eigen::Vector3d& query,
                       std::size_t count,
                       Heap& heap) const
{
  const auto offer = [&](std::int32_t index) {
    heap.emplace_back((points_[index] - query).squaredNorm(), index);
    std::push_heap(heap.begin(), heap.end());
    if (heap.size() > count) {
      std::pop_heap(heap.begin(), heap.end());
      heap.pop_back();
    }
  };
  if (end - begin <= leaf_size) {
    for (std::size_t i = begin; i < end; ++i)
      offer(order_[i]);
    return;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  offer(order_[middle]);
  const int axis = axis_[middle];
  const double offset = query[axis] - points_[order_[middle]][axis];
  const bool below = offset < 0;
  nearest(below ? begin : middle + 1, below ? middle : end, query, count, heap);
  if (heap.size() < count || offset * offset <= heap.front().first)
    nearest(below ? middle + 1 : begin, below ? end : middle, query, count, heap);
}

double
medianSpacing(const Points& points)
{
  const ReferenceTree tree(points);
  std::vector<double> spacings;
  for (const Eigen::Vector3d& point : points) {
    if (!point.allFinite())
      continue;
    for (std::size_t count = 2; count <= 32; count *= 2) {
      const auto found = tree.nearest(point, count);
      if (!found.empty() && found.back().first > 0) {
        const auto other = std::find_if(
            found.begin(), found.end(), [](const auto& f) { return f.first > 0; });
        spacings.push_back(std::sqrt(other->first));
        break;
      }
    }
  }
  if (spacings.empty())
    return 0;
  const auto middle =
      spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  return *middle;
}

} // namespace pcl::acmap::test
