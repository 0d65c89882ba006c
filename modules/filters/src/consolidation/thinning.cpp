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

/** The conflicts of each candidate with earlier ones, in the lists of the chunks in which
 * they were found: joining these would take as long as the search. */
class Conflicts {
public:
  explicit Conflicts(std::size_t candidates)
  : chunks_((candidates + parallel_chunk - 1) / parallel_chunk)
  , ends_(candidates)
  {}

  /** Sets those of a chunk of candidates: find (candidate, list) appends to the list. */
  template <typename Find>
  void
  setChunk(std::size_t begin, std::size_t end, const Find& find)
  {
    std::vector<Conflict>& found = chunks_[begin / parallel_chunk];
    for (std::size_t c = begin; c < end; ++c) {
      find(static_cast<std::uint32_t>(c), found);
      ends_[c] = static_cast<std::uint32_t>(found.size());
    }
  }

  const Conflict*
  begin(std::uint32_t candidate) const
  {
    const std::size_t first =
        candidate % parallel_chunk == 0 ? 0 : ends_[candidate - 1];
    return chunks_[candidate / parallel_chunk].data() + first;
  }

  const Conflict*
  end(std::uint32_t candidate) const
  {
    return chunks_[candidate / parallel_chunk].data() + ends_[candidate];
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

  Conflicts
  run() const
  {
    Conflicts conflicts(candidates_.size());
    parallelForChunks(candidates_.size(), [&](std::size_t begin, std::size_t end) {
      conflicts.setChunk(
          begin, end, [&](std::uint32_t later, auto& found) { find(later, found); });
    });
    return conflicts;
  }

private:
  static std::vector<PointHash::Entry>
  entriesOf(const LargeVector<Candidate>& candidates)
  {
    std::vector<PointHash::Entry> entries(candidates.size());
    parallelForChunks(candidates.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
        entries[c] = {candidates[c].representative.point,
                      static_cast<std::uint32_t>(c)};
    });
    return entries;
  }

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

  bool
  comesBefore(std::uint32_t a, std::uint32_t b) const
  {
    return std::pair(candidates_[a].strayed, a) < std::pair(candidates_[b].strayed, b);
  }

  const LargeVector<Candidate>& candidates_;
  double edge_; // metres
  PointHash hash_;
};

/** The candidates inside of their voxels, then the others by their displacement. */
std::vector<std::uint32_t>
orderOf(const LargeVector<Candidate>& candidates)
{
  std::vector<std::uint32_t> order;
  order.reserve(candidates.size());
  std::vector<std::pair<float, std::uint32_t>> strays;
  for (std::uint32_t c = 0; c < candidates.size(); ++c)
    if (candidates[c].strayed == 0)
      order.push_back(c);
    else
      strays.emplace_back(candidates[c].strayed, c);
  std::sort(strays.begin(), strays.end());
  for (const auto& [strayed, candidate] : strays)
    order.push_back(candidate);
  return order;
}

/** Decides one candidate after the other which of them are kept.
 * \return for each candidate the closest kept one that displaces it, -1 if it is kept */
std::vector<std::int32_t>
displacements(const LargeVector<Candidate>& candidates, const Conflicts& conflicts)
{
  std::vector<std::int32_t> displaced_by(candidates.size(), -1);
  for (const std::uint32_t candidate : orderOf(candidates)) {
    const Conflict* closest = nullptr;
    const Conflict* const end = conflicts.end(candidate);
    for (const Conflict* k = conflicts.begin(candidate); k != end; ++k)
      if (displaced_by[k->earlier] < 0 && (!closest || isCloser(*k, *closest)))
        closest = k;
    if (closest)
      displaced_by[candidate] = static_cast<std::int32_t>(closest->earlier);
  }
  return displaced_by;
}

} // namespace

Thinning
thinOut(const LargeVector<Candidate>& candidates, double edge)
{
  const std::vector<std::int32_t> displaced_by =
      displacements(candidates, ConflictSearch(candidates, edge).run());
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
