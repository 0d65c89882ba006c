#include "mesh_steps.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>
#include <array>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

using Incidence = std::pair<std::int32_t, GrownTriangle*>; ///< vertex, triangle

bool
shareEdgeAt(std::int32_t v, const GrownTriangle& s, const GrownTriangle& t)
{
  for (const std::int32_t corner : s.corners)
    if (corner != v &&
        std::find(t.corners.begin(), t.corners.end(), corner) != t.corners.end())
      return true;
  return false;
}

/** \brief Finds the triangles at a vertex that are not in its largest fan. If there are
 * several largest fans, the one of the earliest triangle is kept. */
class SmallerFans {
public:
  const std::vector<GrownTriangle*>&
  find(std::int32_t v, const std::vector<GrownTriangle*>& incident)
  {
    fan_.assign(incident.size(), -1);
    sizes_.clear();
    smaller_.clear();
    for (std::size_t seed = 0; seed < incident.size(); ++seed)
      if (fan_[seed] < 0)
        collect(v, incident, seed);
    if (sizes_.size() < 2)
      return smaller_;
    const auto largest =
        std::max_element(sizes_.begin(), sizes_.end()) - sizes_.begin();
    for (std::size_t i = 0; i < incident.size(); ++i)
      if (fan_[i] != largest)
        smaller_.push_back(incident[i]);
    return smaller_;
  }

private:
  void
  collect(std::int32_t v, const std::vector<GrownTriangle*>& incident, std::size_t seed)
  {
    const auto fan = static_cast<std::ptrdiff_t>(sizes_.size());
    members_.assign(1, seed);
    fan_[seed] = fan;
    for (std::size_t next = 0; next < members_.size(); ++next)
      for (std::size_t i = seed + 1; i < incident.size(); ++i)
        if (fan_[i] < 0 && shareEdgeAt(v, *incident[members_[next]], *incident[i])) {
          fan_[i] = fan;
          members_.push_back(i);
        }
    sizes_.push_back(members_.size());
  }

  std::vector<std::ptrdiff_t> fan_; ///< for each triangle
  std::vector<std::size_t> sizes_, members_;
  std::vector<GrownTriangle*> smaller_;
};

/** \brief Stable radix sort: there are many elements in random order. */
void
sortByVertex(std::vector<Incidence>& incidences)
{
  constexpr int digit_bits = 11, digits = 3; // for 31 bits; the sign is never set
  std::vector<Incidence> sorted(incidences.size());
  for (int digit = 0; digit < digits; ++digit) {
    const auto digitOf = [&](const Incidence& incidence) {
      return static_cast<std::size_t>(incidence.first >> (digit * digit_bits)) &
             ((1u << digit_bits) - 1);
    };
    std::array<std::size_t, (1u << digit_bits) + 1> begin{};
    for (const Incidence& incidence : incidences)
      ++begin[digitOf(incidence) + 1];
    for (std::size_t value = 1; value < begin.size(); ++value)
      begin[value] += begin[value - 1];
    for (const Incidence& incidence : incidences)
      sorted[begin[digitOf(incidence)]++] = incidence;
    incidences.swap(sorted);
  }
}

class FanChoice {
public:
  FanChoice(GrowingMesh& mesh,
            const std::vector<std::vector<GrownTriangle>*>& lists,
            bool are_walls_known)
  : mesh_(mesh)
  , lists_(lists)
  , are_walls_known_(are_walls_known)
  {}

  std::vector<GrownTriangle>
  run()
  {
    while (removeOnce()) {
    }
    if (!removed_.empty())
      mesh_.sweep(lists_);
    return std::move(removed_);
  }

private:
  bool
  isLookedAt(std::int32_t corner) const
  {
    const MeshArrays& arrays = mesh_.arrays();
    return arrays.is(corner, VertexFlag::pinched) &&
           (are_walls_known_ || !arrays.is(corner, VertexFlag::of_wall));
  }

  /** \brief Returns the triangles at pinched vertices, sorted by vertex, then in their
   * current order. */
  std::vector<Incidence>
  findIncidences() const
  {
    std::vector<std::vector<Incidence>> of_list(lists_.size());
    oneapi::tbb::parallel_for(std::size_t{0}, lists_.size(), [&](std::size_t l) {
      for (GrownTriangle& triangle : *lists_[l])
        for (const std::int32_t corner : triangle.corners)
          if (isLookedAt(corner) && !triangle.isTakenOut())
            of_list[l].emplace_back(corner, &triangle);
    });
    std::vector<Incidence> all;
    for (const std::vector<Incidence>& some : of_list)
      all.insert(all.end(), some.begin(), some.end());
    sortByVertex(all);
    return all;
  }

  bool
  removeOnce()
  {
    const std::vector<Incidence> incident = findIncidences();
    for (const Incidence& incidence : incident)
      mesh_.arrays().clear(incidence.first, VertexFlag::pinched);
    const std::size_t before = removed_.size();
    std::vector<GrownTriangle*> around;
    for (auto begin = incident.begin(); begin != incident.end();) {
      const std::int32_t v = begin->first;
      around.clear();
      for (; begin != incident.end() && begin->first == v; ++begin)
        if (!begin->second->isTakenOut())
          around.push_back(begin->second);
      for (GrownTriangle* triangle : fans_.find(v, around)) {
        removed_.push_back(*triangle);
        mesh_.takeOut(*triangle);
      }
    }
    return removed_.size() > before;
  }

  GrowingMesh& mesh_;
  const std::vector<std::vector<GrownTriangle>*>& lists_;
  const bool are_walls_known_;
  std::vector<GrownTriangle> removed_;
  SmallerFans fans_;
};

} // namespace

std::vector<GrownTriangle>
keepLargestFans(GrowingMesh& mesh,
                const std::vector<std::vector<GrownTriangle>*>& lists,
                bool are_walls_known)
{
  return FanChoice(mesh, lists, are_walls_known).run();
}

} // namespace pcl::acmap::ACMAP_DEWALL
