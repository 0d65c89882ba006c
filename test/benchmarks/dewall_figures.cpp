#include "bench.h"
#include "bench_data.h"
#include "coverage.h"
#include "face_edges.h"
#include "mesh_checker.h"
#include "mesh_peers.h"
#include "point_tree.h"

#include <pcl/core/mesh_file.h>
#include <pcl/core/random.h>
#include <pcl/surface/dewall_triangulation.h>

#include <Eigen/Geometry>

#include <functional>
#include <iomanip>
#include <set>

namespace pcl::acmap::bench {
namespace {

using test::Coverage;
using test::Points;
using test::SheetCloud;
using test::Triangle;
using test::Triangles;

std::vector<test::Edge>
boundaryEdges(const Triangles& faces)
{
  std::vector<test::Edge> result;
  for (const auto& [edge, uses] : test::edgesOf(faces))
    if (uses.size() == 1)
      result.push_back(edge);
  return result;
}

/** Boundary loops of a mesh without vertices near a boundary of the model: holes that
 * the model does not have. */
std::size_t
countForeignHoles(const Points& points,
                  const Triangles& mesh,
                  const Triangles& model,
                  double reach)
{
  std::set<std::int32_t> rim;
  for (const auto& [a, b] : boundaryEdges(model))
    rim.insert({a, b});
  test::FaceSets loops(points.size());
  std::set<std::int32_t> corners;
  for (const auto& [a, b] : boundaryEdges(mesh)) {
    loops.unite(a, b);
    corners.insert({a, b});
  }
  std::set<std::size_t> all, own;
  for (const std::int32_t corner : corners) {
    all.insert(loops.find(corner));
    if (std::any_of(rim.begin(), rim.end(), [&](std::int32_t i) {
          return (points[corner] - points[i]).norm() <= reach;
        }))
      own.insert(loops.find(corner));
  }
  return all.size() - own.size();
}

double
distanceToSegment(const Eigen::Vector3d& p,
                  const Eigen::Vector3d& a,
                  const Eigen::Vector3d& b)
{
  const Eigen::Vector3d edge = b - a;
  const double length2 = edge.squaredNorm();
  const double t = length2 > 0 ? std::clamp(edge.dot(p - a) / length2, 0.0, 1.0) : 0;
  return (a + t * edge - p).norm();
}

double
distanceToTriangle(const Eigen::Vector3d& point,
                   const Eigen::Vector3d& a,
                   const Eigen::Vector3d& b,
                   const Eigen::Vector3d& c)
{
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const bool above = normal.cross(b - a).dot(point - a) >= 0 &&
                     normal.cross(c - b).dot(point - b) >= 0 &&
                     normal.cross(a - c).dot(point - c) >= 0;
  if (above && normal.squaredNorm() > 0)
    return std::abs(normal.normalized().dot(point - a));
  return std::min({distanceToSegment(point, a, b),
                   distanceToSegment(point, b, c),
                   distanceToSegment(point, c, a)});
}

/** Finds the nearest triangle with a tree of the triangles' centres. */
class Surface {
public:
  Surface(const Points& points, const Triangles& triangles)
  : points_(points)
  , triangles_(triangles)
  , tree_(centers(points, triangles))
  {
    const Points middles = centers(points, triangles);
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (const std::int32_t corner : triangles[i])
        reach_ = std::max(reach_, (points[corner] - middles[i]).norm());
  }

  double
  distance(const Eigen::Vector3d& p) const
  {
    double minimum = std::numeric_limits<double>::infinity();
    const auto compare = [&](std::int32_t triangle) {
      const Triangle& t = triangles_[triangle];
      minimum = std::min(
          minimum, distanceToTriangle(p, points_[t[0]], points_[t[1]], points_[t[2]]));
    };
    for (const auto& [squared, triangle] : tree_.nearest(p, 8))
      compare(triangle);
    for (const std::int32_t triangle : tree_.within(p, minimum + reach_))
      compare(triangle);
    return minimum;
  }

private:
  static Points
  centers(const Points& points, const Triangles& triangles)
  {
    Points middles;
    for (const Triangle& t : triangles)
      middles.push_back((points[t[0]] + points[t[1]] + points[t[2]]) / 3);
    return middles;
  }

  const Points& points_;
  const Triangles& triangles_;
  test::ReferenceTree tree_;
  double reach_ = 0; ///< maximum radius of a triangle about its centre
};

Points
sampleByArea(const Points& points,
             const Triangles& triangles,
             std::size_t samples,
             std::uint64_t seed)
{
  std::vector<double> areas;
  double sum = 0;
  for (const Triangle& t : triangles) {
    sum += (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).norm();
    areas.push_back(sum);
  }
  Random random(seed);
  Points chosen;
  for (std::size_t i = 0; i < samples; ++i) {
    const double place = (static_cast<double>(i) + random.uniform()) * sum /
                         static_cast<double>(samples);
    const auto found = std::lower_bound(areas.begin(), areas.end(), place);
    const Triangle& t = triangles[std::min<std::size_t>(
        triangles.size() - 1, static_cast<std::size_t>(found - areas.begin()))];
    const double root = std::sqrt(random.uniform()), share = random.uniform();
    chosen.push_back((1 - root) * points[t[0]] + root * (1 - share) * points[t[1]] +
                     root * share * points[t[2]]);
  }
  return chosen;
}

/** Distances of samples of a surface, uniform by area, from another one that has the
 * same points. */
std::vector<double>
distancesBetween(const Points& points,
                 const Triangles& from,
                 const Triangles& to,
                 std::uint64_t seed)
{
  constexpr std::size_t samples = 50000;
  const Surface surface(points, to);
  return valuesOf(sampleByArea(points, from, samples, seed),
                  [&](const Eigen::Vector3d& p) { return surface.distance(p); });
}

Triangles
deWall(const test::Cloud& cloud, DeWallRule rule, double length = 0)
{
  DeWallTriangulation<PointXYZ> dewall;
  dewall.setAcceptanceRule(rule);
  dewall.setMaximumEdgeLength(length);
  dewall.setNumberOfThreads(1);
  dewall.setInputCloud(cloud.makeShared());
  TriangleMesh mesh;
  dewall.reconstruct(mesh);
  return mesh.triangles;
}

/** A meshing method. */
struct Mesher {
  const char* name;
  Triangles (*mesh)(const FigureCloud&);
};

constexpr Mesher meshers[] = {
    {"DeWall paper",
     [](const FigureCloud& c) { return deWall(c.cloud, DeWallRule::Guarded); }},
    {"DeWall dense",
     [](const FigureCloud& c) { return deWall(c.cloud, DeWallRule::Dense); }},
    {"PCL greedy projection",
     [](const FigureCloud& c) { return greedyProjection(c.cloud, c.spacing); }}};

const Section soundness_section("soundness", [] {
  printHead("cloud | mesher | triangles | edges with > 2 faces | vertices without one "
            "fan | duplicates | degenerate | inconsistent edges | occupied spheres | "
            "points used % | boundary edges %");
  for (const FigureCloud& cloud : realClouds()) {
    const Points points = test::toPoints(cloud.cloud);
    std::set<std::array<double, 3>> places;
    for (const Eigen::Vector3d& p : points)
      places.insert({p.x(), p.y(), p.z()});
    for (const Mesher& mesher : meshers) {
      const Triangles mesh = mesher.mesh(cloud);
      test::MeshDemands demands;
      demands.empty_spheres = true;
      const test::MeshFaults faults = test::checkMesh(points, mesh, demands);
      const test::MeshCounts counts = test::countMesh(points, mesh);
      Row() << cloud.name << mesher.name << mesh.size() << faults.crowded_edges
            << faults.torn_vertices << faults.duplicate_faces << faults.degenerate_faces
            << faults.inconsistent_edges << faults.occupied_spheres
            << figure(percent(counts.used_points, places.size()), 1)
            << figure(percent(counts.boundary_edges, counts.edges), 1);
    }
  }
});

void
printCoverage(const std::string& name,
              const std::function<SheetCloud(std::uint64_t)>& makeSheet,
              const std::function<Triangles(const SheetCloud&)>& mesh)
{
  constexpr std::uint64_t seeds = 10;
  std::vector<double> uncovered, overlapped;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const SheetCloud sheet = makeSheet(seed);
    const Coverage coverage = test::measureCoverage(sheet, mesh(sheet));
    uncovered.push_back(coverage.uncovered);
    overlapped.push_back(coverage.overlapped);
  }
  Row() << name << figure(meanOf(uncovered), 3) << figure(largest(uncovered), 3)
        << figure(meanOf(overlapped), 3) << figure(largest(overlapped), 3);
}

const Section coverage_section("coverage", [] {
  printHead("surface, noise / spacing, mesher | uncovered %, mean | most | overlapped "
            "%, mean | most");
  const std::pair<std::string, double> surfaces[] = {{"plane", 0}, {"edge", M_PI / 2}};
  for (const auto& [surface, fold] : surfaces)
    for (const std::string noise : {"0.1", "0.2"}) {
      const auto makeSheet = [&noise, fold = fold](std::uint64_t seed) {
        return test::makeFoldedPlane({45, 45, 1, 0.25, std::stod(noise), seed}, fold);
      };
      const std::string head = surface + ", " + noise + ", ";
      for (const DeWallRule rule : {DeWallRule::Guarded, DeWallRule::Dense})
        for (const double length : {3.0, 0.0})
          printCoverage(
              head + (rule == DeWallRule::Guarded ? "guarded" : "dense") +
                  (length > 0 ? ", L = 3" : ", automatic L"),
              makeSheet,
              [&](const SheetCloud& s) { return deWall(s.cloud, rule, length); });
      printCoverage(head + "greedy projection", makeSheet, [](const SheetCloud& s) {
        return greedyProjection(s.cloud, s.spacing);
      });
    }
});

const Section time_section("time", [] {
  constexpr std::size_t rounds = 5;
  printHead("view | points | mesher | CPU us a point | greedy projection takes");
  for (const FigureCloud& view : singleViews()) {
    std::vector<double> seconds[std::size(meshers)];
    for (std::size_t round = 0; round < rounds; ++round)
      for (std::size_t i = 0; i < std::size(meshers); ++i)
        seconds[i].push_back(measureThread([&] { meshers[i].mesh(view); }));
    for (std::size_t i = 0; i < std::size(meshers); ++i) {
      std::vector<double> ratios;
      for (std::size_t round = 0; round < rounds; ++round)
        ratios.push_back(seconds[std::size(meshers) - 1][round] / seconds[i][round]);
      const double each = median(seconds[i]) / static_cast<double>(view.cloud.size());
      Row() << view.name << view.cloud.size() << meshers[i].name
            << figure(1e6 * each, 2) << timesOf(median(ratios), 1);
    }
  }
});

const Section bunny_section("bunny", [] {
  const auto path = pathOfData("E_meshing/stanford-bunny.obj");
  if (!path)
    return;
  const FigureCloud cloud = loadFigureCloud("stanford-bunny", *path);
  const Points points = test::toPoints(cloud.cloud);
  const Triangles model = loadTriangleMesh(*path).triangles;
  const double unit = cloud.spacing;
  std::cout << "\nMedian spacing " << std::scientific << std::setprecision(3) << unit
            << " m; boundary loops of the model: "
            << test::countMesh(points, model).boundary_loops
            << ". Distances in spacings.\n";
  printHead("mesher | mesh to model, mean | most | model to mesh, mean | most | "
            "Chamfer (mean of both) | boundary loops | holes the model has not");
  for (const Mesher& mesher : meshers) {
    const Triangles mesh = mesher.mesh(cloud);
    const std::vector<double> there = distancesBetween(points, mesh, model, 1),
                              back = distancesBetween(points, model, mesh, 2);
    Row() << mesher.name << figure(meanOf(there) / unit, 3)
          << figure(largest(there) / unit, 3) << figure(meanOf(back) / unit, 3)
          << figure(largest(back) / unit, 3)
          << figure((meanOf(there) + meanOf(back)) / 2 / unit, 3)
          << test::countMesh(points, mesh).boundary_loops
          << countForeignHoles(points, mesh, model, 3 * unit);
  }
});

} // namespace
} // namespace pcl::acmap::bench
