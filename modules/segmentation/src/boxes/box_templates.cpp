#include "boxes/box_templates.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

namespace pcl::acmap::boxes {

namespace {

using Order = std::array<std::size_t, 3>;

/** The box with its axes in another order, right-handed as before. */
Box
reordered(const Box& box, const Order& order)
{
  Box turned = box;
  Eigen::Matrix<double, 9, 9> change = Eigen::Matrix<double, 9, 9>::Zero();
  Eigen::Matrix3d permutation = Eigen::Matrix3d::Zero();
  for (std::size_t axis = 0; axis < 3; ++axis)
    permutation(static_cast<Eigen::Index>(axis),
                static_cast<Eigen::Index>(order[axis])) = 1;
  const bool turns_last = permutation.determinant() < 0;
  Eigen::Matrix3d directions = permutation;
  if (turns_last)
    directions.row(2) *= -1;
  turned.axes = box.axes * directions.transpose();
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t end = 0; end < 2; ++end) {
      const std::size_t from = turns_last && axis == 2 ? 1 - end : end;
      turned.sides[2 * axis + end] = box.sides[2 * order[axis] + from];
    }
  change.block<3, 3>(0, 0) = directions;
  change.block<3, 3>(3, 3) = directions;
  change.block<3, 3>(6, 6) = permutation;
  turned.covariance = change * box.covariance * change.transpose();
  return turned;
}

Box
withFallingSize(const Box& box)
{
  const Eigen::Vector3d size = box.size();
  Order order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return size[static_cast<Eigen::Index>(a)] > size[static_cast<Eigen::Index>(b)];
  });
  return reordered(box, order);
}

/** Components, along the axes, of the normal of a slanted side; 0 without one. Their
 * signs tell which of two equal boxes was turned. */
Eigen::Vector3d
slopeOf(const Box& box)
{
  return (box.axes.transpose() * box.slant.head<3>()).cwiseAbs();
}

/** A common size, by information. */
struct Template {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
  std::vector<std::size_t> boxes;
  Eigen::Vector3d slope = Eigen::Vector3d::Zero(); ///< of the first box

  Eigen::Vector3d
  size() const
  {
    return information.ldlt().solve(weighted);
  }

  void
  add(const Box& box, std::size_t number)
  {
    const Eigen::Matrix3d inverse = box.covariance.block<3, 3>(6, 6).inverse();
    information += inverse;
    weighted += inverse * box.size();
    if (boxes.empty())
      slope = slopeOf(box);
    boxes.push_back(number);
  }
};

/** The box in that of the equal orders of axes in which its size is nearest to that of a
 * template; none if even that is another size. */
std::optional<Box>
asInstance(const Box& box, const Template& common, SizeOrder which)
{
  constexpr double largest_chi = 11.345;      // 1 % of equal sizes differ more
  constexpr double largest_difference = 0.02; // metres
  constexpr double largest_turn = 0.035;      // 2 degrees
  std::optional<Box> best;
  double least = largest_chi;
  Order order{0, 1, 2};
  do {
    const Box turned = reordered(box, order);
    const Eigen::Vector3d difference = turned.size() - common.size();
    const Eigen::Matrix3d covariance =
        turned.covariance.block<3, 3>(6, 6) + common.information.inverse();
    const double chi = difference.dot(covariance.ldlt().solve(difference));
    if (chi < least && difference.cwiseAbs().maxCoeff() < largest_difference &&
        (slopeOf(turned) - common.slope).norm() < largest_turn) {
      least = chi;
      best = turned;
    }
  } while (which == SizeOrder::Any &&
           std::next_permutation(order.begin(), order.end()));
  return best;
}

/** Moves the sides of a box so that it has a given size, most where they are least
 * known. */
void
setSize(const Eigen::Vector3d& size, const Eigen::Matrix3d& covariance, Box& box)
{
  const Eigen::Matrix<double, 9, 3> with_size = box.covariance.rightCols<3>();
  const Eigen::Matrix<double, 9, 3> gain =
      with_size * Eigen::Matrix3d(box.covariance.block<3, 3>(6, 6)).inverse();
  const Eigen::Matrix<double, 9, 1> shift = gain * (size - box.size());
  const Eigen::Vector3d turn = box.axes * shift.head<3>();
  if (turn.norm() > 0)
    box.axes = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * box.axes;
  box.origin = box.center() + box.axes * shift.segment<3>(3);
  for (std::size_t side = 0; side < box.sides.size(); ++side)
    box.sides[side].position = size[Box::axisOf(side)] / 2;
  box.covariance += gain * covariance * gain.transpose() - gain * with_size.transpose();
}

} // namespace

std::size_t
shareSizes(std::vector<Box>& boxes, SizeOrder order)
{
  std::vector<Template> templates;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    bool is_new = true;
    for (std::size_t t = 0; t < templates.size() && is_new; ++t)
      if (const std::optional<Box> instance =
              asInstance(boxes[i], templates[t], order)) {
        boxes[i] = *instance;
        boxes[i].template_id = static_cast<std::int32_t>(t);
        templates[t].add(boxes[i], i);
        is_new = false;
      }
    if (!is_new)
      continue;
    if (order == SizeOrder::Any)
      boxes[i] = withFallingSize(boxes[i]);
    boxes[i].template_id = static_cast<std::int32_t>(templates.size());
    templates.emplace_back();
    templates.back().add(boxes[i], i);
  }
  for (const Template& common : templates)
    if (common.boxes.size() > 1)
      for (const std::size_t box : common.boxes)
        setSize(common.size(), common.information.inverse(), boxes[box]);
  std::stable_sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) {
    return a.size().prod() > b.size().prod();
  });
  std::vector<std::int32_t> numbers(templates.size(), -1); // in the new order
  std::int32_t next = 0;
  for (Box& box : boxes) {
    std::int32_t& number = numbers[static_cast<std::size_t>(box.template_id)];
    if (number < 0)
      number = next++;
    box.template_id = number;
  }
  return templates.size();
}

} // namespace pcl::acmap::boxes
