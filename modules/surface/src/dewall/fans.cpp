#include "lanes.h"
#include "mesh_steps.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>
#include <array>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

using Incidence = std::pair<std::int32_t, GrownTriangle*>; ///< vertex, triangle

/** \brief Finds the triangles at a vertex that are not in its largest fan. If there are
 * several largest fans, the one of the earliest triangle is kept. */
class SmallerFans {
public:
  const std::vector<GrownTriangle*>&
  find(std::int32_t v, const std::vector<GrownTriangle*>& incident)
  {
    smaller_.clear();
    link(v, incident);
    fan_.assign(incident.size(), -1);
    reached_.assign(words_, 0);
    sizes_.clear();
    for (std::size_t seed = 0; seed < incident.size(); ++seed)
      if (fan_[seed] < 0)
        collect(seed);
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
  static constexpr std::size_t word = 64;

  /** \brief Notes for each triangle, as bits, which ones share an edge at the vertex
   * with it: their other two corners are compared eight by eight. */
  void
  link(std::int32_t v, const std::vector<GrownTriangle*>& incident)
  {
    const std::size_t size = incident.size();
    const std::size_t padded = (size + 7) / 8 * 8;
    words_ = (size + word - 1) / word;
    first_.assign(padded, -1);
    second_.assign(padded, -1);
    for (std::size_t i = 0; i < size; ++i) {
      const auto [a, b, c] = incident[i]->corners;
      first_[i] = a == v ? b : a;
      second_[i] = c == v ? b : c;
    }
    links_.assign(size * words_, 0);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < padded; j += 8) {
        const LaneMask one = loadIntegers(&first_[j]),
                       other = loadIntegers(&second_[j]);
        const LaneMask p = allIntegers(first_[i]), q = allIntegers(second_[i]);
        const std::uint64_t bits =
            bitsOf((one == p) | (one == q) | (other == p) | (other == q));
        links_[i * words_ + j / word] |= bits << (j % word);
      }
  }

  void
  collect(std::size_t seed)
  {
    const auto fan = static_cast<std::ptrdiff_t>(sizes_.size());
    members_.assign(1, seed);
    fan_[seed] = fan;
    reached_[seed / word] |= std::uint64_t{1} << (seed % word);
    for (std::size_t next = 0; next < members_.size(); ++next)
      for (std::size_t w = 0; w < words_; ++w) {
        std::uint64_t more = links_[members_[next] * words_ + w] & ~reached_[w];
        reached_[w] |= more;
        for (; more; more &= more - 1) {
          const std::size_t i =
              w * word + static_cast<std::size_t>(__builtin_ctzll(more));
          fan_[i] = fan;
          members_.push_back(i);
        }
      }
    sizes_.push_back(members_.size());
  }

  std::size_t words_ = 0;                    ///< for a bit per triangle
  std::vector<std::int32_t> first_, second_; ///< other corners of each triangle
  std::vector<std::uint64_t> links_;         ///< bits of each triangle
  std::vector<std::uint64_t> reached_;       ///< triangles in some fan
  std::vector<std::ptrdiff_t> fan_;          ///< for each triangle
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
            const std::vector<GrownTriangles*>& lists,
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
      PollPace pace;
      for (GrownTriangle& triangle : *lists_[l]) {
        pace();
        for (const std::int32_t corner : triangle.corners)
          if (isLookedAt(corner) && !triangle.isTakenOut())
            of_list[l].emplace_back(corner, &triangle);
      }
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
  const std::vector<GrownTriangles*>& lists_;
  const bool are_walls_known_;
  std::vector<GrownTriangle> removed_;
  SmallerFans fans_;
};

} // namespace

std::vector<GrownTriangle>
keepLargestFans(GrowingMesh& mesh,
                const std::vector<GrownTriangles*>& lists,
                bool are_walls_known)
{
  return FanChoice(mesh, lists, are_walls_known).run();
}

} // namespace pcl::acmap::ACMAP_DEWALL
