#include "mesh_steps.h"

#include <pcl/core/progress.h>

#include <cstring>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

std::uint64_t
hash(const std::array<float, 3>& position)
{
  std::uint64_t h = 0x9e3779b97f4a7c15u;
  for (const float value : position) {
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    h = (h ^ bits) * 0xbf58476d1ce4e5b9u;
    h ^= h >> 29;
  }
  return h;
}

/** \brief Removes repeated positions from an array part by part; the first of equal
 * points is kept. */
class PositionSet {
public:
  /** \brief Moves the points of [first, end) that are not repeated to \a kept, which is
   * not behind them.
   * \return the end of what was kept */
  SourcePoint*
  keepFirst(const SourcePoint* first, const SourcePoint* end, SourcePoint* kept)
  {
    std::size_t slots = 16;
    while (slots < 2 * static_cast<std::size_t>(end - first))
      slots *= 2;
    slots_.assign(slots, -1);
    const SourcePoint* const begin = kept;
    for (; first < end; ++first) {
      std::int32_t& place = placeOf(begin, first->position);
      if (place >= 0)
        continue;
      place = static_cast<std::int32_t>(kept - begin);
      *kept++ = *first;
    }
    return kept;
  }

private:
  /** \brief The slot of the point with a position, or the free one for it. */
  std::int32_t&
  placeOf(const SourcePoint* points, const std::array<float, 3>& position)
  {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash(position) & mask;
    while (slots_[slot] >= 0 && points[slots_[slot]].position != position)
      slot = (slot + 1) & mask;
    return slots_[slot];
  }

  LargeVector<std::int32_t> slots_; ///< places of kept points, -1: free
};

/** \brief Calls function (position, index in the view) for the finite points. */
template <typename Function>
void
forEachFinite(const PointView& view, const Function& function)
{
  PollPace pace;
  for (std::size_t i = 0; i < view.size(); ++i) {
    pace();
    const Eigen::Vector3f p = view[i];
    if (p.allFinite()) // adding zero converts -0 to 0
      function(std::array<float, 3>{p.x() + 0.0f, p.y() + 0.0f, p.z() + 0.0f}, i);
  }
}

} // namespace

/** Equal points are in the same of several groups, which are small enough that the search
 * for them stays in the cache, and in few pages where the points are in a file. */
SourcePoints
distinctPoints(const PointView& view, DeWallReport& report)
{
  constexpr std::size_t points_a_group = std::size_t{1} << 18;
  int bits = 0;
  while (view.size() >> bits > points_a_group)
    ++bits;
  // The sets use the lower bits of the hash.
  const auto groupOf = [&](const std::array<float, 3>& position) {
    return static_cast<std::size_t>((hash(position) >> 32) & ((1u << bits) - 1));
  };
  std::vector<std::size_t> ends((std::size_t{1} << bits) + 1);
  forEachFinite(view, [&](const std::array<float, 3>& position, std::size_t) {
    ++ends[groupOf(position) + 1];
  });
  for (std::size_t group = 1; group < ends.size(); ++group)
    ends[group] += ends[group - 1];
  SourcePoints points(ends.back());
  report.points = view.size();
  report.invalid_points = view.size() - points.size();
  forEachFinite(view, [&](const std::array<float, 3>& position, std::size_t i) {
    points[ends[groupOf(position)]++] = {position, view.index(i)};
  });
  PositionSet seen;
  const SourcePoint* begin = points.data();
  SourcePoint* kept = points.data();
  for (std::size_t group = 0; group + 1 < ends.size(); ++group) {
    const SourcePoint* const end = points.data() + ends[group];
    kept = seen.keepFirst(begin, end, kept);
    begin = end;
    pollRun();
  }
  const auto different = static_cast<std::size_t>(kept - points.data());
  report.duplicate_points = points.size() - different;
  points.resize(different);
  return points;
}

} // namespace pcl::acmap::ACMAP_DEWALL
