#pragma once

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** Of elements in no region. */
inline constexpr std::int32_t no_region = -1;

/** Grows a region from its members over whoever is near and fits, breadth first.
 *
 * The engine knows nothing of planes. Who is a neighbour, what is a valid region and in
 * which order seeds are tried are three policies; so other shapes can join.
 * \param[in] neighbours visit (element, f) calls f (other) for each of its neighbours
 * \param[in,out] region accepts (element) tells who fits, add (element) takes it in
 * \param[in,out] members where it begins; those found are appended
 * \param[in,out] owner of each element; only elements of \ref no_region are taken
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
