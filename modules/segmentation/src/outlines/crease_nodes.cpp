#include "outlines/crease_nodes.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

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
    ends_[static_cast<std::size_t>(point.crease)].push_back(point.along);
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
              {(positions_[node] - crease.point).dot(crease.direction), node, true});
      }
  }
}

/** Ends near a corner are that corner; others within two spacings of each other are one. */
void
CreaseNodes::settleEnds(std::size_t number)
{
  const double reach = same_end * spacing_;
  std::vector<double>& ends = ends_[number];
  std::vector<Place>& places = places_[number];
  const Crease& crease = creases_.creases[number];
  std::sort(ends.begin(), ends.end());
  const std::size_t corners = places.size();
  for (std::size_t i = 0; i < ends.size();) {
    const bool is_corner = std::any_of(
        places.begin(),
        places.begin() + static_cast<std::ptrdiff_t>(corners),
        [&](const Place& place) { return std::abs(place.along - ends[i]) <= reach; });
    if (is_corner) {
      ++i;
      continue;
    }
    double sum = 0;
    std::size_t last = i;
    for (; last < ends.size() && ends[last] - ends[i] <= reach; ++last)
      sum += ends[last];
    const double along = sum / static_cast<double>(last - i);
    places.push_back({along, positions_.size(), false});
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
  const std::vector<Place>& places = places_[static_cast<std::size_t>(point.crease)];
  const double reach = same_end * spacing_;
  const Place* best = nullptr;
  for (const Place& place : places) {
    const auto rank = [&](const Place& one) {
      const double off = std::abs(one.along - point.along);
      return one.is_corner && off <= reach ? off - reach : off; // corners come first
    };
    if (!best || rank(place) < rank(*best))
      best = &place;
  }
  return best->node;
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
