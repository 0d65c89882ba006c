#include "planes/plane_merge.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::acmap::planes {
namespace {

/** The border between two regions. */
struct Border {
  std::size_t pairs = 0; ///< pairs of hypotheses across it
  double step = 0;       ///< metres, sum over the pairs
};

using Borders = std::map<std::pair<std::int32_t, std::int32_t>, Border>;

/** Borders of regions that are within two edges of the mesh: hypotheses between them
 * may belong to neither. */
Borders
bordersOf(const CellGraph& graph, const std::vector<GrownPlane>& planes)
{
  const std::vector<std::int32_t> owner = ownersOf(graph, planes);
  // the largest owner among the neighbours of each hypothesis: most have only their own
  std::vector<std::int32_t> largest(graph.size(), -1);
  for (std::size_t i = 0; i < graph.size(); ++i)
    for (const std::int32_t near : graph.neighbours[i])
      largest[i] = std::max(largest[i], owner[static_cast<std::size_t>(near)]);
  Borders borders;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    if (owner[i] < 0)
      continue;
    for (const std::int32_t near : graph.neighbours[i]) {
      if (largest[static_cast<std::size_t>(near)] <= owner[i])
        continue;
      for (const std::int32_t far : graph.neighbours[static_cast<std::size_t>(near)]) {
        const auto f = static_cast<std::size_t>(far);
        if (owner[f] <= owner[i])
          continue;
        Border& border = borders[{owner[i], owner[f]}];
        ++border.pairs;
        border.step += planes[static_cast<std::size_t>(owner[i])].plane.normal.dot(
            graph.points[f] - graph.points[i]);
      }
    }
  }
  return borders;
}

bool
goesOn(const Border& border, const GrownPlane& a, const GrownPlane& b, double distance)
{
  const std::size_t smaller = std::min(a.members.size(), b.members.size());
  // A square region has about as many pairs along one side as the square root of its
  // size.
  return static_cast<double>(border.pairs) > std::sqrt(static_cast<double>(smaller)) &&
         std::abs(border.step) < distance / 2 * static_cast<double>(border.pairs);
}

/** Merges two regions if one plane fits both. \return whether they were merged */
bool
joinWhereBent(const PlaneLimits& limits, double cosine, GrownPlane& a, GrownPlane& b)
{
  if (a.plane.normal.dot(b.plane.normal) < cosine)
    return false;
  Moments both = a.moments;
  both += b.moments;
  const PlaneFit fit = fitPlane(both);
  const Plane common = planeThrough(fit, a.plane.normal);
  const double extent = std::sqrt(12 * fit.variances[2]);
  const double maximum = std::min(limits.bow * extent, limits.max_warp);
  const double off = std::max(excess(a, common), excess(b, common));
  if (off > maximum)
    return false;
  takeIn(a, b, common);
  a.warp = std::max(a.warp, off);
  return true;
}

} // namespace

std::size_t
joinContinued(const CellGraph& graph,
              const PlaneLimits& limits,
              double cosine,
              std::vector<GrownPlane>& planes)
{
  std::size_t joined = 0;
  for (std::size_t before = joined + 1; before != joined;) {
    before = joined;
    for (const auto& [pair, border] : bordersOf(graph, planes)) {
      GrownPlane& a = planes[static_cast<std::size_t>(pair.first)];
      GrownPlane& b = planes[static_cast<std::size_t>(pair.second)];
      if (a.trust == PlaneTrust::Sure && b.trust == PlaneTrust::Sure &&
          !a.members.empty() && !b.members.empty() &&
          goesOn(border, a, b, limits.distance))
        joined += joinWhereBent(limits, cosine, a, b) ? 1 : 0;
    }
    dropEmpty(planes);
  }
  return joined;
}

} // namespace pcl::acmap::planes
