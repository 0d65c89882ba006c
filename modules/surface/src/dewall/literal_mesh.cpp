#include "enclosed_volume.h"
#include "literal_builder.h"
#include "mesh_steps.h"

#include <pcl/core/impl/parallel.h>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

/** \brief Points of each cluster of at least three, in ascending order of the first. */
std::vector<std::vector<std::int32_t>>
membersOf(const PointTree& tree, PointSets clusters)
{
  const LargeVector<std::int32_t> sizes = clusterSizes(clusters, tree.size());
  std::vector<std::int32_t> places(sizes.size(), -1);
  std::vector<std::vector<std::int32_t>> members;
  for (std::int32_t i = 0; i < tree.size(); ++i) {
    const auto root = static_cast<std::size_t>(clusters.find(i));
    if (sizes[root] < min_cluster)
      continue;
    if (places[root] < 0) {
      places[root] = static_cast<std::int32_t>(members.size());
      members.emplace_back().reserve(static_cast<std::size_t>(sizes[root]));
    }
    members[static_cast<std::size_t>(places[root])].push_back(i);
  }
  return members;
}

/** \brief Meshes a cluster. Corners are points of the tree, and face the sensor, or outward.
 * \param[in] volume if they face outward */
LiteralMesh
meshCluster(const PointTree& tree,
            const SizeConstraint& size,
            const Facing& facing,
            const Eigen::Vector3d& sensor,
            const std::optional<EnclosedVolume>& volume,
            const std::vector<std::int32_t>& members,
            std::int32_t leaf_size,
            const std::function<void()>& tick)
{
  const LiteralPoints points(tree, size, members);
  LiteralMesh mesh = buildLiterally(points, leaf_size, tick);
  for (LiteralTriangle& triangle : mesh.triangles) {
    auto& corners = triangle.corners;
    for (std::int32_t& corner : corners)
      corner = points.indexInAll(corner);
    const double shown = volume             ? volume->under(corners)
                         : facing.isKnown() ? facing.shownArea(tree, corners)
                                            : areaFacing(tree, corners, sensor);
    if (shown < 0)
      std::swap(corners[1], corners[2]);
  }
  return mesh;
}

/** \brief The higher end of an edge and a triangle at it. */
struct EdgeUse {
  std::int32_t high, triangle;

  bool
  operator<(const EdgeUse& other) const
  {
    return high < other.high;
  }
};

/** \brief Counts edges and components by sorting the edges of all triangles. */
class EdgeCount {
public:
  EdgeCount(std::int32_t points, const std::vector<LiteralMesh>& meshes)
  : first_(static_cast<std::size_t>(points) + 2)
  {
    std::int32_t triangles = 0;
    forEachEdge(meshes, [&](std::int32_t low, std::int32_t, std::int32_t triangle) {
      ++first_[static_cast<std::size_t>(low) + 2];
      triangles = triangle + 1;
    });
    for (std::size_t i = 2; i < first_.size(); ++i)
      first_[i] += first_[i - 1];
    uses_.resize(first_.back());
    forEachEdge(meshes,
                [&](std::int32_t low, std::int32_t high, std::int32_t triangle) {
                  uses_[first_[static_cast<std::size_t>(low) + 1]++] = {high, triangle};
                });
    parallelForChunks(first_.size() - 2, [&](std::size_t begin, std::size_t end) {
      for (std::size_t low = begin; low < end; ++low)
        std::sort(uses_.begin() + static_cast<std::ptrdiff_t>(first_[low]),
                  uses_.begin() + static_cast<std::ptrdiff_t>(first_[low + 1]));
    });
    triangles_ = triangles;
  }

  void
  tell(DeWallReport& report) const
  {
    PointSets components(triangles_);
    for (std::size_t low = 0; low + 2 < first_.size(); ++low)
      for (std::size_t begin = first_[low]; begin < first_[low + 1];) {
        std::size_t end = begin + 1;
        while (end < first_[low + 1] && uses_[end].high == uses_[begin].high)
          components.unite(uses_[begin].triangle, uses_[end++].triangle);
        ++report.edges;
        report.boundary_edges += end - begin == 1;
        report.crowded_edges += end - begin > 2;
        begin = end;
      }
    for (std::int32_t t = 0; t < triangles_; ++t)
      report.components += components.find(t) == t;
  }

private:
  template <typename Function>
  static void
  forEachEdge(const std::vector<LiteralMesh>& meshes, const Function& function)
  {
    std::int32_t number = 0;
    for (const LiteralMesh& mesh : meshes)
      for (const LiteralTriangle& triangle : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
          const auto [low, high] =
              std::minmax(triangle.corners[i], triangle.corners[(i + 1) % 3]);
          function(low, high, number);
        }
        ++number;
      }
  }

  std::vector<std::size_t> first_; ///< of the uses of each lower end
  std::vector<EdgeUse> uses_;
  std::int32_t triangles_ = 0;
};

std::size_t
countUsed(std::int32_t points, const std::vector<LiteralMesh>& meshes)
{
  std::vector<bool> is_used(static_cast<std::size_t>(points));
  for (const LiteralMesh& mesh : meshes)
    for (const LiteralTriangle& triangle : mesh.triangles)
      for (const std::int32_t corner : triangle.corners)
        is_used[static_cast<std::size_t>(corner)] = true;
  return static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), true));
}

} // namespace

TriangleMesh
literalMesh(const PointTree& tree,
            const SizeConstraint& size,
            const Facing& facing,
            const Eigen::Vector3d& sensor_origin,
            const DeWallSettings& settings,
            std::int32_t leaf_size,
            const std::function<void()>& tick,
            StepTimer& timer,
            DeWallReport& report)
{
  const auto clusters =
      membersOf(tree, findClusters(tree, size, PointSets(tree.size())));
  report.clusters = clusters.size();
  timer.finish("clusters");
  std::optional<EnclosedVolume> volume;
  if (settings.outward)
    volume.emplace(tree);
  std::vector<LiteralMesh> meshes(clusters.size());
  oneapi::tbb::parallel_for(std::size_t{0}, clusters.size(), [&](std::size_t c) {
    meshes[c] = meshCluster(
        tree, size, facing, sensor_origin, volume, clusters[c], leaf_size, tick);
  });
  timer.finish("walls and halves");
  EdgeCount(tree.size(), meshes).tell(report);
  report.used_points = countUsed(tree.size(), meshes);
  TriangleMesh result;
  for (LiteralMesh& mesh : meshes) {
    report.walls += mesh.walls;
    for (const LiteralTriangle& triangle : mesh.triangles) {
      TriangleMesh::Triangle corners;
      for (std::size_t i = 0; i < 3; ++i)
        corners[i] = tree.source(triangle.corners[i]);
      result.triangles.push_back(corners);
      if (settings.compute_wall_depth)
        result.wall_depth.push_back(triangle.depth);
    }
    mesh = {};
  }
  report.triangles = result.triangles.size();
  timer.finish("result");
  return result;
}

} // namespace pcl::acmap::ACMAP_DEWALL
