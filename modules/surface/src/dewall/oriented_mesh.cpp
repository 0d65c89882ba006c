#include "enclosed_volume.h"
#include "mesh_steps.h"

#include <cmath>
#include <numeric>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

/** \brief Orients each component so that the larger area faces the sensor, or outward. */
class Turning {
public:
  Turning(GrowingMesh& grown,
          const std::vector<TriangleList>& lists,
          PointSets components,
          const Eigen::Vector3d& sensor,
          DeWallReport& report)
  : grown_(grown)
  , tree_(grown.arrays().tree)
  , components_(std::move(components))
  , shown_(static_cast<std::size_t>(tree_.size()))
  , boundary_edges_(report.boundary_edges)
  {
    const Facing& facing = grown.arrays().facing;
    DeWallSides& sides = report.sides;
    const bool may_be_closed = sides == DeWallSides::Outward ||
                               sides == DeWallSides::FreeSpace ||
                               sides == DeWallSides::Undetermined;
    if (may_be_closed && turnOutward(lists, sides == DeWallSides::Outward)) {
      sides = DeWallSides::Outward;
      return;
    }
    sumShown(lists, [&](const GrownTriangle& triangle) {
      return facing.isKnown() ? facing.shownArea(tree_, triangle.corners)
                              : areaFacing(tree_, triangle.corners, sensor);
    });
  }

  bool
  turns(const GrownTriangle& triangle)
  {
    return isFlipped(triangle) != (shownOf(triangle) < 0);
  }

private:
  /** \param[in] shown of a triangle as it was grown; negative: its back */
  template <typename Shown>
  void
  sumShown(const std::vector<TriangleList>& lists, const Shown& shown)
  {
    std::fill(shown_.begin(), shown_.end(), 0.0);
    PollPace pace;
    for (const TriangleList& list : lists)
      for (const GrownTriangle& triangle : *list.triangles) {
        pace();
        const double value = shown(triangle);
        shownOf(triangle) += isFlipped(triangle) ? -value : value;
      }
  }

  /** \param[in] always also if the mesh is not closed, or too large for an object
   * \return false if the components are not oriented yet */
  bool
  turnOutward(const std::vector<TriangleList>& lists, bool always)
  {
    const EnclosedVolume volume(tree_);
    if (!always && volume.diagonal() > largest_object)
      return false;
    sumShown(lists, [&](const GrownTriangle& triangle) {
      return volume.under(triangle.corners);
    });
    if (always)
      return true;
    const double enclosed = std::accumulate(
        shown_.begin(), shown_.end(), 0.0, [](double sum, double of_component) {
          return sum + std::abs(of_component);
        });
    return isClosed(lists) && enclosed >= closed_share * volume.ofHull();
  }

  /** The area vectors of a closed surface that is turned outward have no sum; those of two
   * sheets have one each. */
  bool
  isClosed(const std::vector<TriangleList>& lists)
  {
    constexpr double open_share = 0.1;       // a box without its bottom has 0.2
    constexpr std::size_t max_boundary = 33; // triangles an edge: 2 % of the edges
    std::vector<Eigen::Vector3d> sums(shown_.size(), Eigen::Vector3d::Zero());
    double all = 0;
    std::size_t triangles = 0;
    PollPace pace;
    for (const TriangleList& list : lists)
      for (const GrownTriangle& triangle : *list.triangles) {
        pace();
        const Eigen::Vector3d a = tree_.position(triangle.corners[0]),
                              b = tree_.position(triangle.corners[1]),
                              c = tree_.position(triangle.corners[2]);
        const Eigen::Vector3d area = (b - a).cross(c - a);
        sums[componentOf(triangle)] += turns(triangle) ? Eigen::Vector3d(-area) : area;
        all += area.norm();
        ++triangles;
      }
    const double open = std::accumulate(
        sums.begin(), sums.end(), 0.0, [](double norms, const Eigen::Vector3d& sum) {
          return norms + sum.norm();
        });
    return max_boundary * boundary_edges_ <= triangles && open <= open_share * all;
  }

  /** No sensor that maps a building stands inside of it. */
  static constexpr double largest_object = 3; // metres
  static constexpr double closed_share = 0.3; // of the convex hull

  bool
  isFlipped(const GrownTriangle& triangle)
  {
    return grown_.parity().find(triangle.component).flipped;
  }

  std::size_t
  componentOf(const GrownTriangle& triangle)
  {
    return static_cast<std::size_t>(components_.find(triangle.corners[0]));
  }

  double&
  shownOf(const GrownTriangle& triangle)
  {
    return shown_[componentOf(triangle)];
  }

  GrowingMesh& grown_;
  const PointTree& tree_;
  PointSets components_;
  LargeVector<double> shown_;
  const std::size_t boundary_edges_;
};

} // namespace

void
countVertices(const MeshArrays& arrays, DeWallReport& report)
{
  std::size_t open_ends = 0;
  PollPace pace;
  for (const Vertex& v : arrays.vertices) {
    pace();
    report.used_points += v.triangles > 0;
    open_ends += v.open_edges;
  }
  report.boundary_edges = open_ends / 2;
}

PointSets
findComponents(const PointTree& tree, const std::vector<TriangleList>& lists)
{
  PointSets components(tree.size());
  PollPace pace;
  for (const TriangleList& list : lists)
    for (const GrownTriangle& triangle : *list.triangles) {
      pace();
      components.unite(triangle.corners[0], triangle.corners[1]);
      components.unite(triangle.corners[0], triangle.corners[2]);
    }
  return components;
}

TriangleMesh
orientedMesh(GrowingMesh& grown,
             const std::vector<TriangleList>& lists,
             PointSets components,
             const Eigen::Vector3d& sensor_origin,
             bool compute_wall_depth,
             DeWallReport& report)
{
  const PointTree& tree = grown.arrays().tree;
  const std::size_t unused = static_cast<std::size_t>(tree.size()) - report.used_points;
  report.components = components.count() - unused; // each of which is a set
  Turning turning(grown, lists, std::move(components), sensor_origin, report);
  for (const TriangleList& list : lists)
    report.triangles += list.triangles->size();
  report.edges = (3 * report.triangles + report.boundary_edges) / 2;
  TriangleMesh mesh;
  mesh.triangles.reserve(report.triangles);
  PollPace pace;
  for (const TriangleList& list : lists) {
    for (const GrownTriangle& triangle : *list.triangles) {
      pace();
      TriangleMesh::Triangle corners;
      for (std::size_t i = 0; i < 3; ++i)
        corners[i] = tree.source(triangle.corners[i]);
      if (turning.turns(triangle))
        std::swap(corners[1], corners[2]);
      mesh.triangles.push_back(corners);
    }
    if (compute_wall_depth)
      mesh.wall_depth.resize(mesh.triangles.size(), list.depth);
    GrownTriangles().swap(*list.triangles);
  }
  return mesh;
}

} // namespace pcl::acmap::ACMAP_DEWALL
