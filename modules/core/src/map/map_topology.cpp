#include <pcl/core/map_topology.h>

#include <algorithm>
#include <map>

namespace pcl {

namespace {

/** \brief Numbers points by their coordinates. */
class Numbering {
public:
  explicit Numbering(std::vector<Eigen::Vector3f>& vertices)
  : vertices_(vertices)
  {}

  std::vector<std::int32_t>
  operator()(const std::vector<Eigen::Vector3f>& loop)
  {
    std::vector<std::int32_t> numbers;
    numbers.reserve(loop.size());
    for (const Eigen::Vector3f& point : loop) {
      const auto next = static_cast<std::int32_t>(vertices_.size());
      const auto [known, is_new] =
          numbers_.emplace(std::array{point.x(), point.y(), point.z()}, next);
      if (is_new)
        vertices_.push_back(point);
      numbers.push_back(known->second);
    }
    return numbers;
  }

private:
  std::vector<Eigen::Vector3f>& vertices_;
  std::map<std::array<float, 3>, std::int32_t> numbers_;
};

/** Appends the edges of a loop, as those of its plane alone.
 * \param[in] told kinds of the edges of the polygon; empty if there are none
 * \param[in,out] next the number of the loop's first edge in the polygon */
void
appendEdges(const std::vector<std::int32_t>& loop,
            std::int32_t plane,
            const std::vector<PolygonEdge>& told,
            std::size_t& next,
            std::vector<MapEdge>& edges)
{
  for (std::size_t i = 0; i < loop.size(); ++i, ++next) {
    const auto [low, high] = std::minmax(loop[i], loop[(i + 1) % loop.size()]);
    MapEdge edge;
    edge.vertices = {low, high};
    edge.planes[0] = plane;
    if (next < told.size()) {
      edge.kind = told[next].kind;
      (edge.kind == EdgeKind::Arc ? edge.cylinder : edge.planes[1]) =
          told[next].neighbour;
    }
    edges.push_back(edge);
  }
}

/** Joins equal edges: those of two planes are creases. A crease whose other plane is not
 * there any more is open. */
std::vector<MapEdge>
joined(std::vector<MapEdge> edges, std::size_t planes)
{
  const auto isBefore = [](const MapEdge& a, const MapEdge& b) {
    return a.vertices < b.vertices ||
           (a.vertices == b.vertices && a.planes[0] < b.planes[0]);
  };
  std::stable_sort(edges.begin(), edges.end(), isBefore);
  std::vector<MapEdge> result;
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    MapEdge edge = edges[i];
    const auto isOther = [&](std::size_t k) {
      return edges[k].planes[0] != edge.planes[0];
    };
    for (end = i + 1; end < edges.size() && edges[end].vertices == edge.vertices;)
      ++end;
    std::size_t other = i;
    while (other < end && !isOther(other))
      ++other;
    const std::int32_t told = edge.planes[1];
    if (other < end) {
      edge.kind = EdgeKind::Crease;
      edge.cylinder = -1;
      edge.planes[1] = edges[other].planes[0];
    }
    else if (edge.kind == EdgeKind::Crease ||
             told >= static_cast<std::int32_t>(planes)) {
      edge.kind = EdgeKind::Open;
      edge.planes[1] = -1;
    }
    result.push_back(edge);
  }
  return result;
}

} // namespace

MapTopology
topologyOf(const std::vector<PlanePatch>& planes)
{
  MapTopology topology;
  Numbering numbersOf(topology.vertices);
  std::vector<MapEdge> edges;
  for (std::size_t p = 0; p < planes.size(); ++p)
    for (std::size_t k = 0; k < planes[p].polygons.size(); ++k) {
      const PlanePolygon& polygon = planes[p].polygons[k];
      MapFace face;
      face.plane = static_cast<std::int32_t>(p);
      face.polygon = static_cast<std::int32_t>(k);
      std::size_t next = 0;
      face.outer = numbersOf(polygon.outer);
      appendEdges(face.outer, face.plane, polygon.edges, next, edges);
      for (const std::vector<Eigen::Vector3f>& hole : polygon.holes) {
        face.holes.push_back(numbersOf(hole));
        appendEdges(face.holes.back(), face.plane, polygon.edges, next, edges);
      }
      topology.faces.push_back(std::move(face));
    }
  topology.edges = joined(std::move(edges), planes.size());
  return topology;
}

} // namespace pcl
