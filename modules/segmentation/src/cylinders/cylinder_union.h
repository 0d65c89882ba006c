#pragma once

#include "cylinders/cylinder_growth.h"

#include <optional>
#include <vector>

namespace pcl::acmap::cylinders {

/** Are two cylinders roughly on one axis, with one radius? */
bool
mayBeOne(const GrownCylinder& a, const GrownCylinder& b, double sigma);

/** Does a common fit describe both nearly as well as their own ones? */
bool
fitsBoth(const CylinderFit& common,
         const GrownCylinder& a,
         const GrownCylinder& b,
         double sigma);

/** Replaces pairs by what tryBoth (a, b) returns, until it returns nothing for any
 * pair. */
template <typename TryBoth>
void
unite(std::vector<GrownCylinder>& cylinders, const TryBoth& tryBoth)
{
  for (std::size_t i = 0; i < cylinders.size(); ++i)
    for (std::size_t j = i + 1; j < cylinders.size();) {
      std::optional<GrownCylinder> both = tryBoth(cylinders[i], cylinders[j]);
      if (!both) {
        ++j;
        continue;
      }
      cylinders[i] = std::move(*both);
      cylinders.erase(cylinders.begin() + static_cast<std::ptrdiff_t>(j));
      j = i + 1;
    }
}

} // namespace pcl::acmap::cylinders
