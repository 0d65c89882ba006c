#pragma once

#include "planes/known_planes.h"
#include "planes/plane_region.h"
#include "region_growing.h"

namespace pcl::acmap::planes {

/** A region that became a plane. */
struct GrownPlane {
  std::vector<std::int32_t> members;
  Moments moments; ///< of the members, in the frame of the graph
  Plane plane;
  double area = 0; ///< area of the members, square metres
  PlaneTrust trust = PlaneTrust::Sure;
  double warp = 0; ///< metres, see KnownPlane
};

/** Takes elements into a region that were not taken in very often before: the seeds of a
 * surface on which no plane ends grow to nearly the same region, again and again. */
class SparingRegion {
public:
  SparingRegion(PlaneRegion& region, std::vector<std::uint8_t>& times)
  : region_(region)
  , times_(times)
  {}

  bool
  accepts(std::size_t i) const
  {
    constexpr std::uint8_t most = 32; // times that one pass takes an element in
    return times_[i] < most && region_.accepts(i);
  }

  void
  add(std::size_t i)
  {
    ++times_[i];
    region_.add(i);
  }

private:
  PlaneRegion& region_;
  std::vector<std::uint8_t>& times_;
};

/** Removes members that do not fit the plane of all members and grows again from the
 * others, until nothing changes, in at most five rounds.
 * \param[in,out] times that each element was taken in */
template <typename Neighbours>
void
settleRegion(const Neighbours& neighbours,
             PlaneRegion& region,
             std::vector<std::uint8_t>& times,
             std::vector<std::int32_t>& members,
             std::vector<std::int32_t>& owner,
             std::int32_t id)
{
  constexpr int max_rounds = 5;
  SparingRegion sparing(region, times);
  for (int round = 0; round < max_rounds && !members.empty(); ++round) {
    region.setMembers(members);
    std::vector<std::int32_t> kept;
    for (const std::int32_t member : members)
      if (region.accepts(static_cast<std::size_t>(member)))
        kept.push_back(member);
      else
        owner[static_cast<std::size_t>(member)] = no_region;
    const bool has_dropped = kept.size() < members.size();
    const std::size_t before = kept.size();
    members = std::move(kept);
    growRegion(neighbours, sparing, members, owner, id);
    if (!has_dropped && members.size() == before)
      break;
  }
  if (!members.empty())
    region.setMembers(members);
}

/** Calls accept (members, region) for each grown region, in the order of the seeds. If
 * it returns false, the members are free again, but are no longer used as seeds.
 * \param[in,out] next number of the next region */
template <typename Neighbours, typename Accept>
void
growPlanes(const CellGraph& graph,
           const Neighbours& neighbours,
           const PlaneLimits& limits,
           const std::vector<std::int32_t>& seeds,
           std::int32_t& next,
           std::vector<std::int32_t>& owner,
           const Accept& accept)
{
  std::vector<std::uint8_t> is_tried(graph.size(), 0), times(graph.size(), 0);
  for (const std::int32_t seed : seeds) {
    if (owner[static_cast<std::size_t>(seed)] != no_region ||
        is_tried[static_cast<std::size_t>(seed)])
      continue;
    PlaneRegion region(graph, limits, static_cast<std::size_t>(seed));
    std::vector<std::int32_t> members{seed};
    owner[static_cast<std::size_t>(seed)] = next;
    region.add(static_cast<std::size_t>(seed));
    SparingRegion sparing(region, times);
    growRegion(neighbours, sparing, members, owner, next);
    settleRegion(neighbours, region, times, members, owner, next);
    if (accept(members, region)) {
      ++next;
      continue;
    }
    for (const std::int32_t member : members) {
      owner[static_cast<std::size_t>(member)] = no_region;
      is_tried[static_cast<std::size_t>(member)] = 1;
    }
    is_tried[static_cast<std::size_t>(seed)] = 1;
  }
}

/** Grows regions over the mesh within the noise. First the large planes are grown; then
 * the remaining hypotheses are grown again and kept as small regions and strips, which
 * have to be verified with the points. Curved surfaces are removed and counted. */
std::vector<GrownPlane>
growNoiseDriven(const CellGraph& graph,
                const std::vector<std::int32_t>& seeds,
                const PlaneLimits& limits,
                double min_area,
                PlaneClusteringReport& report);

/** Is a region so narrow that its hypotheses may only be two rounded edges? */
bool
isNarrow(const Moments& moments, double spacing);

/** Guesses the planes of narrow strips between larger ones, such as the reveal of a
 * door: along the strip and perpendicular to its largest neighbour. The hypotheses of a
 * strip determine its direction only; whether the guess is right is verified with the
 * points later. */
void
raiseStrips(const CellGraph& graph, std::vector<GrownPlane>& planes);

/** Assigns points to an adjacent plane in the mesh if they are on it but their normals
 * are mixed or missing: two rings of them.
 * \param[in] distance metres */
void
widenRims(const CellGraph& graph, double distance, std::vector<GrownPlane>& planes);

} // namespace pcl::acmap::planes
