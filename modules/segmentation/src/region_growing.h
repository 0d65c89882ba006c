#pragma once

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** Owner of elements that are in no region. */
inline constexpr std::int32_t no_region = -1;

/** Grows a region breadth first from its members over all neighbours that fit.
 *
 * The engine is independent of planes. Three policies define which elements are
 * neighbours, which regions are valid, and in which order seeds are tried, so that
 * other shapes can be added.
 * \param[in] neighbours visit (element, f) calls f (other) for each neighbour of the
 * element
 * \param[in,out] region accepts (element) returns true if the element fits, add
 * (element) adds it
 * \param[in,out] members the initial members; new ones are appended
 * \param[in,out] owner of each element; only elements of \ref no_region are added
 * \param[in] id of the region */
template <typename Neighbours, typename Region>
void
growRegion(const Neighbours& neighbours,
           Region& region,
           std::vector<std::int32_t>& members,
           std::vector<std::int32_t>& owner,
           std::int32_t id)
{
  for (std::size_t next = 0; next < members.size(); ++next)
    neighbours.visit(members[next], [&](std::int32_t other) {
      std::int32_t& its_owner = owner[static_cast<std::size_t>(other)];
      if (its_owner != no_region || !region.accepts(static_cast<std::size_t>(other)))
        return;
      its_owner = id;
      members.push_back(other);
      region.add(static_cast<std::size_t>(other));
    });
}

} // namespace pcl::acmap
