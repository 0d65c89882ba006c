#include "planes/cell_graph.h"

#include "planes/radius_grid.h"
#include "planes/waves.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/quantile.h>
#include <pcl/core/impl/surface_noise.h>
#include <pcl/core/noise_scale.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::acmap::planes {
namespace {

/** Triangles with finite vertices only: others would spoil the sums. */
TriangleMesh::Triangles
finiteTriangles(const PlaneHypotheses& hypotheses,
                const LargeVector<Eigen::Vector3d>& points)
{
  const auto is_finite = [&](const TriangleMesh::Triangle& triangle) {
    return std::all_of(triangle.begin(), triangle.end(), [&](std::int32_t corner) {
      return points[static_cast<std::size_t>(corner)].allFinite();
    });
  };
  TriangleMesh::Triangles triangles;
  triangles.reserve(hypotheses.triangles.size());
  for (const TriangleMesh::Triangle& triangle : hypotheses.triangles)
    if (is_finite(triangle))
      triangles.push_back(triangle);
  return triangles;
}

/** Median of each coordinate, which is robust against points far away. */
Eigen::Vector3d
middleOf(const LargeVector<Eigen::Vector3d>& points)
{
  Eigen::Vector3d middle;
  oneapi::tbb::parallel_for(0, 3, [&](int axis) {
    LargeVector<double> coordinates;
    coordinates.reserve(points.size());
    for (const Eigen::Vector3d& point : points)
      if (point.allFinite())
        coordinates.push_back(point[axis]);
    middle[axis] = medianOf(coordinates);
  });
  return middle;
}

/** Mean length of the edges. */
double
meanEdge(const CellGraph& graph)
{
  if (graph.neighbours.size() == 0)
    return 0;
  LargeVector<double> lengths(graph.neighbours.size());
  const std::int32_t* const first = graph.neighbours[0].begin();
  parallelForChunks(graph.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (const std::int32_t& j : graph.neighbours[i])
        lengths[static_cast<std::size_t>(&j - first)] =
            (graph.points[static_cast<std::size_t>(j)] - graph.points[i]).norm();
  });
  return std::accumulate(lengths.begin(), lengths.end(), 0.0) /
         static_cast<double>(lengths.size());
}

/** Noise of the points along their normals, from their offsets from the mean of their
 * neighbours. The median is that of flat surfaces, unless most of the surface is
 * strongly curved. */
double
localNoise(const CellGraph& graph)
{
  using Offsets = LargeVector<double>;
  const auto offsetsOf = [&](std::size_t begin, std::size_t end) {
    Offsets offsets;
    for (std::size_t i = begin; i < end; ++i) {
      const VertexNeighbours::Range others = graph.neighbours[i];
      if (others.size() < 5 || !graph.hasNormal(i))
        continue;
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      for (const std::int32_t j : others)
        mean += graph.points[static_cast<std::size_t>(j)];
      const double count = static_cast<double>(others.size());
      mean /= count;
      const double offset =
          (graph.points[i] - mean).dot(graph.normals[i].cast<double>());
      offsets.push_back(std::abs(offset) / std::sqrt(1 + 1 / count));
    }
    return offsets;
  };
  Offsets offsets = parallelReduceChunks(
      graph.size(), Offsets{}, offsetsOf, [](Offsets& all, const Offsets& next) {
        all.insert(all.end(), next.begin(), next.end());
      });
  constexpr double median_of_normal = 0.6745;
  return medianOf(offsets) / median_of_normal;
}

} // namespace

CellGraph::CellGraph(const PlaneHypotheses& hypotheses,
                     bool is_consolidated,
                     unsigned threads)
: normals(hypotheses.normals)
, areas(hypotheses.points.size(), 0.0)
{
  const std::size_t size = hypotheses.points.size();
  points.resize(size);
  parallelForChunks(size, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      points[i] = hypotheses.points[i].cast<double>();
      if (!points[i].allFinite())
        normals[i].setConstant(std::nanf(""));
    }
  });
  origin = middleOf(points);
  const TriangleMesh::Triangles triangles = finiteTriangles(hypotheses, points);
  parallelForChunks(size, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      points[i] -= origin;
  });
  neighbours = VertexNeighbours(size, triangles);
  addAreas(triangles);
  if (triangles.empty())
    connectNear(hypotheses.points, threads);
  else
    spacing = meanEdge(*this);
  sigma = localNoise(*this);
  // more than half of a sparse surface may be at edges: its offsets are no noise
  constexpr double sparse = 0.1, of_sensors = 0.02; // metres
  if (!is_consolidated && spacing > sparse && sigma > of_sensors)
    sigma = std::min(sigma, measureSurfaceNoise(hypotheses.points, threads).sigma);
  if (triangles.empty())
    return;
  averageWaves();
}

/** Neighbouring points of stereo cameras share their errors, which then look like waves of
 * the surface: wider than what the mesh shows as noise, and steeper than planes may be. */
void
CellGraph::averageWaves()
{
  constexpr double min_ratio = 2.8, min_height = 0.08; // of sigma; of the spacing
  constexpr double max_spacing =
      0.1; // metres: windows of sparser clouds hold furniture
  if (spacing > max_spacing)
    return;
  for (const int rings : {5, 10}) {
    const Waves waves = measureWaves(*this, rings);
    if (!(waves.quiet > min_ratio * sigma && waves.quiet > min_height * spacing))
      continue;
    const int averaged = 3 * rings / 5;
    normals = normalsOverWaves(*this, averaged);
    sigma = waves.height;
    least_area = std::pow((2 * averaged + 1) * spacing, 2);
    return;
  }
}

void
CellGraph::addAreas(const TriangleMesh::Triangles& triangles)
{
  LargeVector<double> thirds(triangles.size());
  parallelForChunks(triangles.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const TriangleMesh::Triangle& t = triangles[i];
      const Eigen::Vector3d& a = points[static_cast<std::size_t>(t[0])];
      const Eigen::Vector3d& b = points[static_cast<std::size_t>(t[1])];
      const Eigen::Vector3d& c = points[static_cast<std::size_t>(t[2])];
      thirds[i] = (b - a).cross(c - a).norm() / 6;
    }
  });
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (const std::int32_t corner : triangles[i])
      areas[static_cast<std::size_t>(corner)] += thirds[i];
}

double
CellGraph::areaOf(const std::vector<std::int32_t>& members) const
{
  double area = 0;
  for (const std::int32_t member : members)
    area += areas[static_cast<std::size_t>(member)];
  return area;
}

/** Without a mesh, points within two spacings are neighbours, and each point represents
 * the same area. */
void
CellGraph::connectNear(const PointView& view, unsigned threads)
{
  spacing = measureNoiseScale(view, SensorView(), threads).spacing;
  if (!(spacing > 0))
    return;
  const RadiusGrid grid(points, 2 * spacing);
  LargeVector<std::size_t> first;
  LargeVector<std::int32_t> others;
  for (std::size_t i = 0; i < points.size(); ++i) {
    first.push_back(others.size());
    if (!hasNormal(i))
      continue;
    areas[i] = spacing * spacing;
    grid.visitNear(points[i], [&](std::int32_t other) {
      if (other != static_cast<std::int32_t>(i))
        others.push_back(other);
    });
  }
  first.push_back(others.size());
  neighbours = VertexNeighbours(std::move(first), std::move(others));
}

} // namespace pcl::acmap::planes
