#include "planes/cell_graph.h"

#include "median.h"
#include "planes/radius_grid.h"

#include <pcl/core/noise_scale.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::planes {
namespace {

/** Triangles with finite vertices only: others would spoil the sums. */
std::vector<TriangleMesh::Triangle>
finiteTriangles(const PlaneHypotheses& hypotheses)
{
  std::vector<TriangleMesh::Triangle> triangles;
  for (const TriangleMesh::Triangle& triangle : hypotheses.triangles) {
    const auto is_finite = [&](std::int32_t corner) {
      return hypotheses.points[static_cast<std::size_t>(corner)].allFinite();
    };
    if (std::all_of(triangle.begin(), triangle.end(), is_finite))
      triangles.push_back(triangle);
  }
  return triangles;
}

/** Median of each coordinate, which is robust against points far away. */
Eigen::Vector3d
middleOf(const std::vector<Eigen::Vector3d>& points)
{
  Eigen::Vector3d middle;
  std::vector<double> coordinates;
  for (int axis = 0; axis < 3; ++axis) {
    coordinates.clear();
    for (const Eigen::Vector3d& point : points)
      if (point.allFinite())
        coordinates.push_back(point[axis]);
    middle[axis] = medianOf(coordinates);
  }
  return middle;
}

/** Mean length of the edges. */
double
meanEdge(const CellGraph& graph)
{
  double sum = 0;
  for (std::size_t i = 0; i < graph.size(); ++i)
    for (const std::int32_t j : graph.neighbours[i])
      sum += (graph.points[static_cast<std::size_t>(j)] - graph.points[i]).norm();
  return graph.neighbours.size() == 0
             ? 0
             : sum / static_cast<double>(graph.neighbours.size());
}

/** Noise of the points along their normals, from their offsets from the mean of their
 * neighbours. The median is that of flat surfaces, unless most of the surface is
 * strongly curved. */
double
localNoise(const CellGraph& graph)
{
  std::vector<double> offsets;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const VertexNeighbours::Range others = graph.neighbours[i];
    if (others.size() < 5 || !graph.hasNormal(i))
      continue;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const std::int32_t j : others)
      mean += graph.points[static_cast<std::size_t>(j)];
    const double count = static_cast<double>(others.size());
    mean /= count;
    const double offset = (graph.points[i] - mean).dot(graph.normals[i].cast<double>());
    offsets.push_back(std::abs(offset) / std::sqrt(1 + 1 / count));
  }
  constexpr double median_of_normal = 0.6745;
  return medianOf(offsets) / median_of_normal;
}

} // namespace

CellGraph::CellGraph(const PlaneHypotheses& hypotheses, unsigned threads)
: normals(hypotheses.normals)
, areas(hypotheses.points.size(), 0.0)
{
  const std::size_t size = hypotheses.points.size();
  points.reserve(size);
  for (std::size_t i = 0; i < size; ++i) {
    points.push_back(hypotheses.points[i].cast<double>());
    if (!points.back().allFinite())
      normals[i].setConstant(std::nanf(""));
  }
  origin = middleOf(points);
  for (Eigen::Vector3d& point : points)
    point -= origin;

  const std::vector<TriangleMesh::Triangle> triangles = finiteTriangles(hypotheses);
  neighbours = VertexNeighbours(size, triangles);
  for (const TriangleMesh::Triangle& t : triangles) {
    const Eigen::Vector3d& a = points[static_cast<std::size_t>(t[0])];
    const Eigen::Vector3d& b = points[static_cast<std::size_t>(t[1])];
    const Eigen::Vector3d& c = points[static_cast<std::size_t>(t[2])];
    const double third = (b - a).cross(c - a).norm() / 6;
    for (const std::int32_t corner : t)
      areas[static_cast<std::size_t>(corner)] += third;
  }
  if (triangles.empty())
    connectNear(hypotheses.points, threads);
  else
    spacing = meanEdge(*this);
  sigma = localNoise(*this);
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
  std::vector<std::size_t> first;
  std::vector<std::int32_t> others;
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
