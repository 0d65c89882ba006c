#include "consolidation/thinning.h"

#include "consolidation/point_hash.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>
#include <utility>

namespace pcl::acmap {

namespace {

constexpr double min_distance = 0.7; // edges
constexpr double min_distance_of_strays = 0.85;

/** Were they seen from opposite sides of a thin wall? */
bool
areOpposite(const Candidate& a, const Candidate& b)
{
  return (a.octants & b.octants) == 0;
}

/** An earlier candidate so close to a later one that it displaces the later one if it is
 * kept. */
struct Conflict {
  std::uint32_t earlier;
  float squared_distance; // square metres
};

bool
isCloser(const Conflict& a, const Conflict& b)
{
  return std::pair(a.squared_distance, a.earlier) <
         std::pair(b.squared_distance, b.earlier);
}

/** The conflicts of some candidates with earlier ones, in the lists of the chunks in which
 * they were found: joining these would take as long as the search. */
class Conflicts {
public:
  /** Finds those of candidates: find (candidate, list) appends to the list. */
  template <typename Find>
  void
  set(const std::uint32_t* candidates, std::size_t size, const Find& find)
  {
    chunks_.resize((size + parallel_chunk - 1) / parallel_chunk);
    ends_.resize(size);
    parallelForChunks(size, [&](std::size_t begin, std::size_t end) {
      std::vector<Conflict>& found = chunks_[begin / parallel_chunk];
      found.clear();
      for (std::size_t i = begin; i < end; ++i) {
        find(candidates[i], found);
        ends_[i] = static_cast<std::uint32_t>(found.size());
      }
    });
  }

  /** \param[in] place of the candidate among those that were given */
  const Conflict*
  begin(std::size_t place) const
  {
    const std::size_t first = place % parallel_chunk == 0 ? 0 : ends_[place - 1];
    return chunks_[place / parallel_chunk].data() + first;
  }

  const Conflict*
  end(std::size_t place) const
  {
    return chunks_[place / parallel_chunk].data() + ends_[place];
  }

private:
  std::vector<std::vector<Conflict>> chunks_;
  std::vector<std::uint32_t> ends_; // in the list of the chunk
};

class ConflictSearch {
public:
  ConflictSearch(const LargeVector<Candidate>& candidates, double edge)
  : candidates_(candidates)
  , edge_(edge)
  , hash_(entriesOf(candidates), static_cast<float>(min_distance_of_strays * edge))
  {}

  void
  find(std::uint32_t later, std::vector<Conflict>& found) const
  {
    const Candidate& candidate = candidates_[later];
    // a point that left its voxel is only needed if there would be a hole without it
    const double radius =
        edge_ * (candidate.strayed > 0 ? min_distance_of_strays : min_distance);
    const Eigen::Vector3f& point = candidate.representative.point;
    hash_.visitNear(point, [&](const PointHash::Entry& entry) {
      const float distance = (entry.point - point).squaredNorm();
      if (static_cast<double>(distance) < radius * radius &&
          comesBefore(entry.name, later) &&
          !areOpposite(candidates_[entry.name], candidate))
        found.push_back({entry.name, distance});
    });
  }

private:
  static LargeVector<PointHash::Entry>
  entriesOf(const LargeVector<Candidate>& candidates)
  {
    LargeVector<PointHash::Entry> entries(candidates.size());
    parallelForChunks(candidates.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
        entries[c] = {candidates[c].representative.point,
                      static_cast<std::uint32_t>(c)};
    });
    return entries;
  }

  bool
  comesBefore(std::uint32_t a, std::uint32_t b) const
  {
    return std::pair(candidates_[a].strayed, a) < std::pair(candidates_[b].strayed, b);
  }

  const LargeVector<Candidate>& candidates_;
  double edge_; // metres
  PointHash hash_;
};

/** Decides one candidate after the other which of them are kept. */
class Decisions {
public:
  explicit Decisions(std::size_t candidates)
  : displaced_by(candidates, -1)
  {}

  /** \param[in] begin, end its conflicts with earlier candidates */
  void
  decide(std::uint32_t candidate, const Conflict* begin, const Conflict* end)
  {
    const Conflict* closest = nullptr;
    for (const Conflict* k = begin; k != end; ++k)
      if (displaced_by[k->earlier] < 0 && (!closest || isCloser(*k, *closest)))
        closest = k;
    if (closest)
      displaced_by[candidate] = static_cast<std::int32_t>(closest->earlier);
  }

  /** For each candidate the closest kept one that displaces it, -1 if it is kept. */
  PointLabels displaced_by;
};

/** Finds the conflicts of candidates in their order in space, some at a time: those of
 * all of them would not fit into the memory.
 * \param[in] use called with (place among them, begin, end of its conflicts) */
template <typename Use>
void
findConflicts(const ConflictSearch& search,
              const LargeVector<std::uint32_t>& candidates,
              const Use& use)
{
  constexpr std::size_t at_a_time = 64 * parallel_chunk;
  Conflicts conflicts;
  for (std::size_t first = 0; first < candidates.size(); first += at_a_time) {
    const std::size_t size = std::min(at_a_time, candidates.size() - first);
    conflicts.set(&candidates[first], size, [&](std::uint32_t later, auto& found) {
      search.find(later, found);
    });
    for (std::size_t i = 0; i < size; ++i)
      use(first + i, conflicts.begin(i), conflicts.end(i));
  }
}

/** The candidates inside of their voxels come first, then the others by their
 * displacement. */
PointLabels
displacements(const LargeVector<Candidate>& candidates, double edge)
{
  LargeVector<std::uint32_t> inside, strays;
  for (std::uint32_t c = 0; c < candidates.size(); ++c)
    (candidates[c].strayed == 0 ? inside : strays).push_back(c);
  const ConflictSearch search(candidates, edge);
  Decisions decisions(candidates.size());
  findConflicts(search, inside, [&](std::size_t place, const auto* begin, auto* end) {
    decisions.decide(inside[place], begin, end);
  });

  LargeVector<Conflict> found;
  LargeVector<std::size_t> ends;
  LargeVector<std::pair<float, std::uint32_t>> order; // displacements and places
  findConflicts(search, strays, [&](std::size_t place, const auto* begin, auto* end) {
    found.insert(found.end(), begin, end);
    ends.push_back(found.size());
    order.emplace_back(candidates[strays[place]].strayed,
                       static_cast<std::uint32_t>(place));
  });
  std::sort(order.begin(), order.end());
  for (const auto& [strayed, place] : order)
    decisions.decide(strays[place],
                     found.data() + (place > 0 ? ends[place - 1] : 0),
                     found.data() + ends[place]);
  return std::move(decisions.displaced_by);
}

} // namespace

Thinning
thinOut(const LargeVector<Candidate>& candidates, double edge)
{
  const PointLabels displaced_by = displacements(candidates, edge);
  Thinning thinning;
  thinning.stand_in.assign(candidates.size(), -1);
  for (std::uint32_t c = 0; c < candidates.size(); ++c)
    if (displaced_by[c] < 0) {
      thinning.stand_in[c] = static_cast<std::int32_t>(thinning.kept.size());
      thinning.kept.push_back(c);
    }
  for (std::size_t c = 0; c < candidates.size(); ++c)
    if (displaced_by[c] >= 0)
      thinning.stand_in[c] =
          thinning.stand_in[static_cast<std::size_t>(displaced_by[c])];
  return thinning;
}

} // namespace pcl::acmap
