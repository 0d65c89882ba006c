#include "plane_scores.h"

#include "plane_matches.h"
#include "statistics.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace pcl::acmap::bench {
namespace {

/** Statistics of a subset of the true planes. */
class Selection {
public:
  Selection(const PlaneCase& plane_case,
            const PlaneOverlaps& overlaps,
            const PlaneMatches& matches,
            const std::function<bool(std::size_t)>& is_selected)
  {
    for (std::size_t t = 0; t < plane_case.truth.planes.size(); ++t)
      if (overlaps.truthSize(t) > 0 && is_selected(t))
        add(t, overlaps, matches);
  }

  FoundShare share;

  PlaneErrors
  errors() const
  {
    const auto count = static_cast<double>(share.found);
    if (share.found == 0)
      return {none, none, none, none};
    return {largest_.angle, sum_.angle / count, largest_.offset, sum_.offset / count};
  }

  double
  labels() const
  {
    return percent(right_, points_);
  }

private:
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  void
  add(std::size_t t, const PlaneOverlaps& overlaps, const PlaneMatches& matches)
  {
    points_ += overlaps.truthSize(t);
    for (std::size_t f = 0; f < overlaps.founds(); ++f)
      if (overlaps.majority(f) == static_cast<std::int32_t>(t))
        right_ += overlaps.common(f, t);
    ++share.there;
    if (matches.finder[t] < 0)
      return;
    ++share.found;
    const MatchDeviation& deviation = matches.deviation[t];
    largest_.angle = std::max(largest_.angle, deviation.angle);
    largest_.offset = std::max(largest_.offset, deviation.offset);
    sum_.angle += deviation.angle;
    sum_.offset += deviation.offset;
  }

  MatchDeviation largest_, sum_;
  std::size_t points_ = 0;
  std::size_t right_ = 0;
};

double
precisionOf(const PlaneOverlaps& overlaps)
{
  std::size_t right = 0, given = 0;
  for (std::size_t f = 0; f < overlaps.founds(); ++f) {
    const std::int32_t truth = overlaps.majority(f);
    right += truth >= 0 ? overlaps.common(f, static_cast<std::size_t>(truth)) : 0;
    given += overlaps.foundSize(f);
  }
  return percent(right, given);
}

} // namespace

PlaneScores
scorePlanes(const PlaneCase& plane_case, const FoundPlanes& found)
{
  const std::vector<TruthPlane>& planes = plane_case.truth.planes;
  const PlaneOverlaps overlaps(
      plane_case.truth.labels, planes.size(), found.labels, found.planes.size());
  const PlaneMatches matches = matchPlanes(plane_case, found, overlaps);
  const std::size_t large_count = largeCount(plane_case.truth.labels.size());
  const auto is_main = [&](std::size_t t) { return isMainPlane(planes[t]); };
  const auto is_door = [&](std::size_t t) { return isDoorPlane(planes[t]); };
  const auto is_large = [&](std::size_t t) {
    return overlaps.truthSize(t) >= large_count;
  };
  const auto select = [&](const std::function<bool(std::size_t)>& is_selected) {
    return Selection(plane_case, overlaps, matches, is_selected);
  };
  const Selection main = select(is_main);
  const Selection all = select([](std::size_t) { return true; });
  const Selection named =
      select([&](std::size_t t) { return is_main(t) || is_door(t) || is_large(t); });
  return {main.share,
          select(is_door).share,
          select(is_large).share,
          all.share,
          found.planes.size(),
          matches.spurious,
          matches.duplicates,
          main.errors(),
          all.errors(),
          named.labels(),
          all.labels(),
          precisionOf(overlaps),
          found.seconds};
}

} // namespace pcl::acmap::bench
