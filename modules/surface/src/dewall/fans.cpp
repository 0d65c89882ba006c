#include "growing_mesh.h"

#include <algorithm>

namespace pcl::acmap::dewall {

namespace {

bool
shareEdgeAt(std::int32_t v, const GrownTriangle& s, const GrownTriangle& t)
{
  for (const std::int32_t corner : s.corners)
    if (corner != v &&
        std::find(t.corners.begin(), t.corners.end(), corner) != t.corners.end())
      return true;
  return false;
}

/** \brief The triangles round a vertex that are not in its largest fan (of equal ones
 * the fan of the earliest triangle stays). */
std::vector<std::size_t>
smallerFans(std::int32_t v,
            const std::vector<std::size_t>& incident,
            const std::vector<GrownTriangle>& triangles)
{
  std::vector<std::vector<std::size_t>> fans;
  std::vector<bool> taken(incident.size());
  for (std::size_t seed = 0; seed < incident.size(); ++seed) {
    if (taken[seed])
      continue;
    taken[seed] = true;
    std::vector<std::size_t> fan{incident[seed]};
    for (std::size_t next = 0; next < fan.size(); ++next)
      for (std::size_t i = 0; i < incident.size(); ++i)
        if (!taken[i] && shareEdgeAt(v, triangles[fan[next]], triangles[incident[i]])) {
          taken[i] = true;
          fan.push_back(incident[i]);
        }
    fans.push_back(std::move(fan));
  }
  const auto largest =
      std::max_element(fans.begin(), fans.end(), [](const auto& f, const auto& g) {
        return f.size() < g.size();
      });
  std::vector<std::size_t> smaller;
  for (auto fan = fans.begin(); fan != fans.end(); ++fan)
    if (fan != largest)
      smaller.insert(smaller.end(), fan->begin(), fan->end());
  return smaller;
}

} // namespace

bool
GrowingMesh::removeSmallerFans(std::vector<bool>& removed)
{
  std::vector<std::pair<std::int32_t, std::size_t>>
      incident; // pinched vertex, triangle
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (const std::int32_t corner : triangles_[t].corners)
      if (vertex(corner).was_pinched && !removed[t])
        incident.emplace_back(corner, t);
  std::sort(incident.begin(), incident.end());
  for (Vertex& v : vertices_)
    v.was_pinched = false;
  bool any = false;
  for (auto begin = incident.begin(); begin != incident.end();) {
    const std::int32_t v = begin->first;
    std::vector<std::size_t> around;
    for (; begin != incident.end() && begin->first == v; ++begin)
      if (!removed[begin->second])
        around.push_back(begin->second);
    for (const std::size_t t : smallerFans(v, around, triangles_)) {
      removed[t] = any = true;
      // Without it the fans of its other corners may fall apart.
      for (const std::int32_t corner : triangles_[t].corners)
        vertex(corner).was_pinched = true;
    }
  }
  return any;
}

std::size_t
GrowingMesh::keepLargestFans()
{
  std::vector<bool> removed(triangles_.size());
  while (removeSmallerFans(removed)) {
  }
  const auto count =
      static_cast<std::size_t>(std::count(removed.begin(), removed.end(), true));
  if (count > 0)
    forget(removed);
  return count;
}

void
GrowingMesh::forget(const std::vector<bool>& removed)
{
  std::vector<bool> touched(vertices_.size());
  const auto isTouched = [&](std::int32_t v) {
    return touched[static_cast<std::size_t>(v)];
  };
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    if (removed[t])
      for (const std::int32_t corner : triangles_[t].corners)
        touched[static_cast<std::size_t>(corner)] = true;

  for (std::int32_t low = 0; low < tree_.size(); ++low) {
    if (!isTouched(low))
      continue;
    vertex(low).used = false;
    edges_.forEachAt(low, [&](Edge& edge) {
      if (!isTouched(edge.high))
        return;
      if (edge.isOpen()) {
        --vertex(low).open_edges;
        --vertex(edge.high).open_edges;
      }
      edge.triangles = 0;
    });
  }
  std::size_t kept = 0;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    if (removed[t])
      continue;
    const GrownTriangle triangle = triangles_[kept++] = triangles_[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t from = triangle.corners[i], to = triangle.corners[(i + 1) % 3];
      if (isTouched(from))
        vertex(from).used = true;
      if (isTouched(from) && isTouched(to))
        attach(from, to, triangle.corners[(i + 2) % 3], triangle.component);
    }
  }
  triangles_.resize(kept);
}

} // namespace pcl::acmap::dewall
