#include "consolidation/thinning.h"

#include "consolidation/point_hash.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>
#include <numeric>
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

/** Two candidates so close that the earlier one displaces the later one if it is kept. */
struct Conflict {
  std::uint32_t later;
  std::uint32_t earlier;
  float squared_distance; // square metres
};

bool
isCloser(const Conflict& a, const Conflict& b)
{
  return std::pair(a.squared_distance, a.earlier) <
         std::pair(b.squared_distance, b.earlier);
}

class ConflictSearch {
public:
  ConflictSearch(const std::vector<Candidate>& candidates, double edge)
  : candidates_(candidates)
  , edge_(edge)
  , hash_(entriesOf(candidates), static_cast<float>(min_distance_of_strays * edge))
  {}

  /** \return in the order of the later candidates */
  std::vector<Conflict>
  run() const
  {
    using Conflicts = std::vector<Conflict>;
    return parallelReduceChunks(
        candidates_.size(),
        Conflicts{},
        [&](std::size_t begin, std::size_t end) {
          Conflicts found;
          for (std::size_t c = begin; c < end; ++c)
            find(static_cast<std::uint32_t>(c), found);
          return found;
        },
        [](Conflicts& all, const Conflicts& next) {
          all.insert(all.end(), next.begin(), next.end());
        });
  }

private:
  static std::vector<PointHash::Entry>
  entriesOf(const std::vector<Candidate>& candidates)
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
        found.push_back({later, entry.name, distance});
    });
  }

  bool
  comesBefore(std::uint32_t a, std::uint32_t b) const
  {
    return std::pair(candidates_[a].strayed, a) < std::pair(candidates_[b].strayed, b);
  }

  const std::vector<Candidate>& candidates_;
  double edge_; // metres
  PointHash hash_;
};

std::vector<std::uint32_t>
orderOf(const std::vector<Candidate>& candidates)
{
  std::vector<std::uint32_t> order(candidates.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto strays =
      std::stable_partition(order.begin(), order.end(), [&](std::uint32_t c) {
        return candidates[c].strayed == 0;
      });
  std::stable_sort(strays, order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return candidates[a].strayed < candidates[b].strayed;
  });
  return order;
}

/** Decides one candidate after the other which of them are kept.
 * \return for each candidate the closest kept one that displaces it, -1 if it is kept */
std::vector<std::int32_t>
displacements(const std::vector<Candidate>& candidates,
              const std::vector<Conflict>& conflicts)
{
  std::vector<std::size_t> begins(candidates.size() + 1, 0);
  for (const Conflict& conflict : conflicts)
    ++begins[conflict.later + 1];
  for (std::size_t c = 0; c < candidates.size(); ++c)
    begins[c + 1] += begins[c];
  std::vector<std::int32_t> displaced_by(candidates.size(), -1);
  for (const std::uint32_t candidate : orderOf(candidates)) {
    const Conflict* closest = nullptr;
    for (std::size_t k = begins[candidate]; k < begins[candidate + 1]; ++k)
      if (displaced_by[conflicts[k].earlier] < 0 &&
          (!closest || isCloser(conflicts[k], *closest)))
        closest = &conflicts[k];
    if (closest)
      displaced_by[candidate] = static_cast<std::int32_t>(closest->earlier);
  }
  return displaced_by;
}

} // namespace

Thinning
thinOut(const std::vector<Candidate>& candidates, double edge)
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
