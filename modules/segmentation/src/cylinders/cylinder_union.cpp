#include "cylinders/cylinder_union.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::cylinders {

bool
mayBeOne(const GrownCylinder& a, const GrownCylinder& b, double sigma)
{
  const Cylinder& one = a.fit.cylinder;
  const Cylinder& other = b.fit.cylinder;
  const double smaller = std::min(one.radius, other.radius);
  constexpr double min_cosine = 0.996; // 5 degrees
  constexpr double max_change = 0.05;  // of the radius
  const double slack = 3 * sigma + max_change * smaller;
  return one.is_hollow == other.is_hollow &&
         std::abs(one.axis.dot(other.axis)) > min_cosine &&
         std::abs(one.radius - other.radius) < slack &&
         one.across(other.point).norm() < 2 * slack &&
         other.across(one.point).norm() < 2 * slack;
}

bool
fitsBoth(const CylinderFit& common,
         const GrownCylinder& a,
         const GrownCylinder& b,
         double sigma)
{
  constexpr double min_share = 0.9, max_growth = 1.25;
  const double members = static_cast<double>(a.members.size() + b.members.size());
  return static_cast<double>(common.count) > min_share * members &&
         common.rms < max_growth * std::max(a.fit.rms, b.fit.rms) + 0.3 * sigma;
}

} // namespace pcl::acmap::cylinders
