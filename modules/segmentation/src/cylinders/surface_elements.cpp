#include "cylinders/surface_elements.h"

#include <pcl/core/impl/moments.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/quantile.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>

namespace pcl::acmap::cylinders {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/** A quadric over the tangent plane of some points. */
struct Quadric {
  Eigen::Vector3d normal = Eigen::Vector3d::Constant(nan); ///< at the first point
  double rms = nan;  ///< metres, corrected for the degrees of freedom
  double window = 0; ///< metres, to the farthest point
};

/** \param[in] chosen the first one is where the normal is wanted */
Quadric
quadricOf(const LargeVector<Eigen::Vector3d>& points,
          const std::vector<std::int32_t>& chosen,
          std::size_t size)
{
  using Terms = Eigen::Matrix<double, 6, 1>;
  using Matrix = Eigen::Matrix<double, 6, 6>;
  Quadric quadric;
  const Eigen::Vector3d& middle = points[static_cast<std::size_t>(chosen[0])];
  Moments moments;
  for (std::size_t i = 0; i < size; ++i) {
    const Eigen::Vector3d from = points[static_cast<std::size_t>(chosen[i])] - middle;
    moments += momentsOf(from);
    quadric.window = std::max(quadric.window, from.norm());
  }
  const PlaneFit plane = fitPlane(moments);
  constexpr double min_width = 1e-2; // squared, relative to the length
  if (!(quadric.window > 0) || !(plane.variances[1] > min_width * plane.variances[2]))
    return quadric;
  const Eigen::Vector3d u = plane.normal.unitOrthogonal(), v = plane.normal.cross(u);
  Matrix matrix = Matrix::Zero();
  Terms right = Terms::Zero();
  double squares = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const Eigen::Vector3d from =
        (points[static_cast<std::size_t>(chosen[i])] - middle) / quadric.window;
    const double x = from.dot(u), y = from.dot(v), z = from.dot(plane.normal);
    Terms terms;
    terms << 1, x, y, x * x, x * y, y * y;
    matrix += terms * terms.transpose();
    right += z * terms;
    squares += z * z;
  }
  matrix.diagonal().array() += 1e-9; // points on two lines do not determine all terms
  const Terms fit = matrix.ldlt().solve(right);
  const double rest = std::max(squares - fit.dot(right), 0.0);
  quadric.rms =
      quadric.window *
      std::sqrt(rest / static_cast<double>(std::max<std::size_t>(size, 7) - 6));
  quadric.normal = (plane.normal - fit[1] * u - fit[2] * v).normalized();
  return quadric;
}

constexpr double quartile_of_seven = 0.78; // rms of seven normal values

} // namespace

SurfaceElements::SurfaceElements(const PlaneHypotheses& hypotheses, double told_sigma)
: normals(hypotheses.points.size(), Eigen::Vector3d::Constant(nan))
, is_smooth(hypotheses.points.size(), 0)
, is_oriented(!hypotheses.normals.empty())
, is_mesh(!hypotheses.triangles.empty())
{
  setPoints(hypotheses.points);
  for (std::size_t i = 0; i < hypotheses.normals.size(); ++i)
    if (points[i].allFinite() && hypotheses.normals[i].allFinite()) {
      normals[i] = hypotheses.normals[i].cast<double>();
      is_smooth[i] = 1;
    }
  // for the noise of given normals only, which may be told
  const bool needs_quadrics = !is_oriented || !(told_sigma > 0);
  std::optional<NearestPoints> tree;
  if (!is_mesh || needs_quadrics)
    tree.emplace(points);
  if (is_mesh)
    neighbours = VertexNeighbours(size(), hypotheses.triangles);
  else
    connectNearest(*tree);
  setSpacing();
  constexpr double rounding = 5e-5; // of coordinates in files, relative to the extent
  // Consolidated points are more precise than the shape of their mesh: near edges they
  // are means over both surfaces.
  constexpr double mesh_error = 0.05; // relative to the spacing
  const double least = std::max(rounding * extent, is_mesh ? mesh_error * spacing : 0);
  if (needs_quadrics)
    fitQuadrics(*tree, least);
  if (told_sigma > 0)
    sigma = told_sigma;
  sigma = std::max(sigma, least);
}

/** Sets the spacing to the median distance between neighbours. */
void
SurfaceElements::setSpacing()
{
  std::vector<double> squares;
  for (std::size_t i = 0; i < size(); ++i)
    for (const std::int32_t j : neighbours[i]) {
      if (is_mesh && j < static_cast<std::int32_t>(i))
        continue; // an edge of a mesh is found at both ends
      const double square =
          (points[static_cast<std::size_t>(j)] - points[i]).squaredNorm();
      if (square > 0)
        squares.push_back(square);
    }
  spacing = std::sqrt(medianOf(squares));
}

void
SurfaceElements::setPoints(const PointView& view)
{
  LargeVector<double> coordinates;
  points.reserve(view.size());
  for (std::size_t i = 0; i < view.size(); ++i)
    points.push_back(view[i].cast<double>());
  for (int axis = 0; axis < 3; ++axis) {
    coordinates.clear();
    for (const Eigen::Vector3d& point : points)
      if (point.allFinite())
        coordinates.push_back(point[axis]);
    origin[axis] = medianOf(coordinates);
  }
  // A few points far away do not make a scene large.
  Eigen::Vector3d half = Eigen::Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    coordinates.clear();
    for (const Eigen::Vector3d& point : points)
      if (point.allFinite())
        coordinates.push_back(std::abs(point[axis] - origin[axis]));
    if (coordinates.empty())
      continue;
    half[axis] = valueOfRank(coordinates, (coordinates.size() - 1) * 99 / 100);
  }
  extent = 2 * half.norm();
  for (Eigen::Vector3d& point : points)
    point -= origin;
}

void
SurfaceElements::connectNearest(const NearestPoints& tree)
{
  constexpr std::size_t nearest = 16;
  std::vector<Indices> found(size());
  parallelForChunks(size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      tree.find(points[i].cast<float>(), nearest + 1, found[i]);
  });
  LargeVector<std::size_t> first{0};
  LargeVector<std::int32_t> others;
  for (std::size_t i = 0; i < size(); ++i) {
    for (const std::int32_t other : found[i])
      if (other != static_cast<std::int32_t>(i))
        others.push_back(other);
    first.push_back(others.size());
  }
  neighbours = VertexNeighbours(std::move(first), std::move(others));
}

/** Fits quadrics over the nearest points; without given normals, to all of them. The
 * noise is that of the best quarter: edges are no noise. Noise below the least one does
 * not matter, and is not measured further than it takes to know. */
void
SurfaceElements::fitQuadrics(const NearestPoints& tree, double least)
{
  constexpr std::size_t sizes[] = {13, 9, 25, 41};
  constexpr double max_rms = 0.06; // of the window
  const std::size_t quarter = size() / 4 + 1;
  std::atomic<std::size_t> quiet{0}; // points whose noise is below the least one
  LargeVector<double> rms(size(), nan);
  parallelForChunks(size(), [&](std::size_t begin, std::size_t end) {
    if (is_oriented && quiet >= quarter)
      return;
    Indices found;
    for (std::size_t i = begin; i < end; ++i) {
      if (!points[i].allFinite())
        continue;
      for (const std::size_t wanted : sizes) {
        if (found.empty() || wanted > found.size())
          tree.find(points[i].cast<float>(), wanted, found);
        if (found.size() < 9)
          break;
        const Quadric quadric =
            quadricOf(points, found, std::min(wanted, found.size()));
        if (!(quadric.rms < max_rms * quadric.window))
          continue;
        rms[i] = quadric.rms;
        if (!is_oriented) {
          normals[i] = quadric.normal;
          is_smooth[i] = 1;
        }
        break;
      }
      found.clear();
    }
    quiet += static_cast<std::size_t>(
        std::count_if(rms.begin() + static_cast<std::ptrdiff_t>(begin),
                      rms.begin() + static_cast<std::ptrdiff_t>(end),
                      [&](double r) { return r / quartile_of_seven <= least; }));
  });
  if (quiet >= quarter)
    return;
  rms.erase(std::remove_if(rms.begin(), rms.end(), [](double r) { return !(r >= 0); }),
            rms.end());
  if (rms.empty())
    return;
  sigma = quantileOf(rms, 0.25) / quartile_of_seven;
}

LocalNoise
measureLocalNoise(const PointView& view)
{
  constexpr std::size_t max_samples = 1500, nearest = 13;
  LargeVector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < view.size(); ++i)
    if (view[i].allFinite())
      points.push_back(view[i].cast<double>());
  const NearestPoints tree(points);
  std::vector<double> rms, distances;
  Indices found;
  for (std::size_t i = 0; i < points.size(); i += points.size() / max_samples + 1) {
    tree.find(points[i].cast<float>(), nearest, found);
    if (found.size() < nearest)
      continue;
    const Quadric quadric = quadricOf(points, found, nearest);
    if (!(quadric.rms >= 0))
      continue;
    rms.push_back(quadric.rms);
    distances.push_back(quadric.window * 0.7); // half of the disc is nearer
  }
  if (rms.empty())
    return {};
  return {quantileOf(rms, 0.25) / quartile_of_seven, medianOf(distances)};
}

} // namespace pcl::acmap::cylinders
