#include "size_constraint.h"

#include "spacing.h"

#include <cmath>
#include <limits>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

/** \brief The largest float that is not above a length, so that no edge exceeds the
 * requested limit. */
float
floatBelow(double length)
{
  const float rounded = static_cast<float>(length);
  return static_cast<double>(rounded) > length ? std::nextafter(rounded, 0.0f)
                                               : rounded;
}

} // namespace

SizeConstraint::SizeConstraint(const PointTree& tree, double maximum_edge_length)
: tree_(tree)
, longest_(static_cast<std::size_t>(tree.leafCount()), floatBelow(maximum_edge_length))
, minimum_(maximum_edge_length)
, largest_(maximum_edge_length)
{}

SizeConstraint::SizeConstraint(const PointTree& tree, const Spacing& spacing)
: tree_(tree)
{
  longest_.reserve(spacing.eighth.size());
  for (const double eighth : spacing.eighth)
    longest_.push_back(floatBelow(edge_in_eighths * eighth));
  const auto [minimum, largest] = std::minmax_element(longest_.begin(), longest_.end());
  minimum_ = *minimum;
  largest_ = *largest;
}

} // namespace pcl::acmap::ACMAP_DEWALL
