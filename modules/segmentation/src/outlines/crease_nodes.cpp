#include "outlines/crease_nodes.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl::acmap::outlines {

namespace {

constexpr double same_end = 2; // spacings within which ends are one

} // namespace

CreaseNodes::CreaseNodes(const Creases& creases,
                         const std::vector<PlaneRaster>& rasters,
                         double spacing)
: creases_(creases)
, rasters_(rasters)
, spacing_(spacing)
, ends_(creases.creases.size())
, places_(creases.creases.size())
{}

CreaseNodes::Corner
CreaseNodes::cornerOf(const CreasePoint& point) const
{
  const Crease& crease = creases_.creases[static_cast<std::size_t>(point.crease)];
  Corner corner{
      crease.planes[0], crease.planes[1], static_cast<std::size_t>(point.third)};
  std::sort(corner.begin(), corner.end());
  return corner;
}

void
CreaseNodes::add(const CreasePoint& point)
{
  if (point.third >= 0)
    corners_.emplace(cornerOf(point), 0);
  else
    ends_[static_cast<std::size_t>(point.crease)].push_back(
        {point.along, point.heading, point.weight});
}

namespace {

/** The point nearest to planes through it; a corner of four is off each by their noise. */
Eigen::Vector3d
intersectionOf(const std::vector<std::size_t>& planes,
               const std::vector<PlaneRaster>& rasters)
{
  Eigen::MatrixXd normals(static_cast<Eigen::Index>(planes.size()), 3);
  Eigen::VectorXd offsets(static_cast<Eigen::Index>(planes.size()));
  const Eigen::Vector3d origin = rasters[planes[0]].origin;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const PlaneRaster& plane = rasters[planes[i]];
    normals.row(static_cast<Eigen::Index>(i)) = plane.normal.transpose();
    offsets[static_cast<Eigen::Index>(i)] = -(plane.normal.dot(origin) + plane.offset);
  }
  return origin + Eigen::Vector3d(normals.colPivHouseholderQr().solve(offsets));
}

bool
shareTwo(const std::array<std::size_t, 3>& a, const std::array<std::size_t, 3>& b)
{
  return std::count_if(a.begin(), a.end(), [&](std::size_t plane) {
           return std::find(b.begin(), b.end(), plane) != b.end();
         }) >= 2;
}

} // namespace

/** Corners of three planes get nodes, those of the same four planes within the noise one,
 * and are entered on their creases. */
void
CreaseNodes::settleCorners()
{
  constexpr double same = 0.5; // spacings
  struct Group {
    Eigen::Vector3d position;
    std::vector<std::size_t> planes;
    std::vector<Corner> corners;
  };
  std::vector<Group> groups;
  std::multimap<double, std::size_t> by_x;
  for (const auto& [corner, node] : corners_) {
    std::vector<std::size_t> planes(corner.begin(), corner.end());
    const Eigen::Vector3d position = intersectionOf(planes, rasters_);
    const double reach = same * spacing_;
    Group* joined = nullptr;
    for (auto it = by_x.lower_bound(position.x() - reach);
         it != by_x.end() && it->first <= position.x() + reach && !joined;
         ++it) {
      Group& group = groups[it->second];
      if ((group.position - position).norm() <= reach &&
          std::any_of(
              group.corners.begin(),
              group.corners.end(),
              [&, c = corner](const Corner& other) { return shareTwo(c, other); }))
        joined = &group;
    }
    if (!joined) {
      by_x.emplace(position.x(), groups.size());
      groups.push_back({position, planes, {corner}});
      continue;
    }
    joined->corners.push_back(corner);
    joined->planes.insert(joined->planes.end(), planes.begin(), planes.end());
  }
  for (Group& group : groups) {
    std::sort(group.planes.begin(), group.planes.end());
    group.planes.erase(std::unique(group.planes.begin(), group.planes.end()),
                       group.planes.end());
    const std::size_t node = positions_.size();
    positions_.push_back(intersectionOf(group.planes, rasters_));
    for (const Corner& corner : group.corners)
      corners_[corner] = node;
    for (const std::size_t plane : group.planes)
      for (const std::size_t number : creases_.of_planes[plane]) {
        const Crease& crease = creases_.creases[number];
        if (crease.planes[0] == plane && std::binary_search(group.planes.begin(),
                                                            group.planes.end(),
                                                            crease.planes[1]))
          places_[number].push_back(
              {(positions_[node] - crease.point).dot(crease.direction), node});
      }
  }
}

bool
CreaseNodes::isBefore(const End& a, const End& b)
{
  return std::tie(a.along, a.heading, a.weight) <
         std::tie(b.along, b.heading, b.weight);
}

/** Are ends one, given that those between them are? Edges that end towards the same side
 * may be farther from each other: an oblique rim meets its crease anywhere in a part of
 * it, and no edge is lost between them. */
bool
CreaseNodes::areSame(const std::vector<End>& ends,
                     std::size_t first,
                     std::size_t last) const
{
  constexpr double deviations = 2, farthest = 6; // spacings
  const double off = (ends[last].along - ends[first].along) / spacing_;
  if (off <= same_end)
    return true;
  const double variance = 1 / ends[first].weight + 1 / ends[last].weight;
  return off <= farthest && off * off <= deviations * deviations * variance &&
         std::all_of(
             ends.begin() + static_cast<std::ptrdiff_t>(first),
             ends.begin() + static_cast<std::ptrdiff_t>(last) + 1,
             [&](const End& end) { return end.heading == ends[first].heading; });
}

/** Ends near a corner are that corner; others within the noise of each other are one, at
 * their weighted mean. */
void
CreaseNodes::settleEnds(std::size_t number)
{
  const double reach = same_end * spacing_;
  std::vector<End>& ends = ends_[number];
  std::vector<Place>& places = places_[number];
  const Crease& crease = creases_.creases[number];
  std::sort(ends.begin(), ends.end(), isBefore);
  const std::size_t corners = places.size();
  const auto cornerOf = [&](const End& end) {
    const Place* best = nullptr;
    for (std::size_t i = 0; i < corners; ++i) {
      const double off = std::abs(places[i].along - end.along);
      if (off <= reach && (!best || off < std::abs(best->along - end.along)))
        best = &places[i];
    }
    return best;
  };
  for (std::size_t i = 0; i < ends.size();) {
    if (const Place* const corner = cornerOf(ends[i])) {
      ends[i++].node = corner->node;
      continue;
    }
    double sum = 0, weights = 0;
    std::size_t last = i;
    for (; last < ends.size() && !cornerOf(ends[last]) && areSame(ends, i, last);
         ++last) {
      sum += ends[last].weight * (ends[last].along - ends[i].along);
      weights += ends[last].weight;
    }
    const double along = ends[i].along + sum / weights;
    for (std::size_t k = i; k < last; ++k)
      ends[k].node = positions_.size();
    places.push_back({along, positions_.size()});
    positions_.push_back(crease.point + along * crease.direction);
    i = last;
  }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return a.along < b.along || (a.along == b.along && a.node < b.node);
  });
}

void
CreaseNodes::settle()
{
  settleCorners();
  for (std::size_t number = 0; number < ends_.size(); ++number)
    settleEnds(number);
}

std::size_t
CreaseNodes::find(const CreasePoint& point) const
{
  if (point.third >= 0)
    return corners_.at(cornerOf(point));
  const std::vector<End>& ends = ends_[static_cast<std::size_t>(point.crease)];
  const End wanted{point.along, point.heading, point.weight};
  return std::lower_bound(ends.begin(), ends.end(), wanted, isBefore)->node;
}

std::vector<std::size_t>
CreaseNodes::between(std::int32_t crease, std::size_t from, std::size_t to) const
{
  const std::vector<Place>& places = places_[static_cast<std::size_t>(crease)];
  const auto placeOf = [&](std::size_t node) {
    return std::find_if(places.begin(),
                        places.end(),
                        [&](const Place& place) { return place.node == node; }) -
           places.begin();
  };
  std::vector<std::size_t> nodes;
  const std::ptrdiff_t begin = placeOf(from), end = placeOf(to);
  const auto size = static_cast<std::ptrdiff_t>(places.size());
  if (begin == size || end == size)
    return nodes;
  const std::ptrdiff_t step = begin < end ? 1 : -1;
  for (std::ptrdiff_t i = begin + step; i != end && begin != end; i += step)
    nodes.push_back(places[static_cast<std::size_t>(i)].node);
  return nodes;
}

} // namespace pcl::acmap::outlines
