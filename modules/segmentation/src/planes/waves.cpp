#include "planes/waves.h"

#include <pcl/core/impl/moments.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/quantile.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::acmap::planes {
namespace {

/** Hypotheses within some edges of the mesh, on the same side of a crease. */
class Rings {
public:
  explicit Rings(const CellGraph& graph)
  : graph_(graph)
  , visited_(graph.size(), 0)
  {}

  const std::vector<std::int32_t>&
  around(std::size_t start, int rings)
  {
    constexpr float min_cosine = 0.5F;
    ++round_;
    found_.assign(1, static_cast<std::int32_t>(start));
    visited_[start] = round_;
    std::size_t next = 0;
    for (int ring = 0; ring < rings; ++ring)
      for (const std::size_t end = found_.size(); next < end; ++next)
        for (const std::int32_t other :
             graph_.neighbours[static_cast<std::size_t>(found_[next])]) {
          const auto o = static_cast<std::size_t>(other);
          if (visited_[o] == round_ || !graph_.hasNormal(o) ||
              graph_.normals[o].dot(graph_.normals[start]) < min_cosine)
            continue;
          visited_[o] = round_;
          found_.push_back(other);
        }
    return found_;
  }

private:
  const CellGraph& graph_;
  std::vector<std::uint32_t> visited_; ///< round of the last visit
  std::vector<std::int32_t> found_;
  std::uint32_t round_ = 0;
};

PlaneFit
planeOver(const CellGraph& graph, const std::vector<std::int32_t>& window)
{
  const Eigen::Vector3d& middle = graph.points[static_cast<std::size_t>(window[0])];
  Moments moments;
  for (const std::int32_t member : window)
    moments += momentsOf(graph.points[static_cast<std::size_t>(member)] - middle);
  return fitPlane(moments);
}

/** Root mean square distance from a quadric, so that curvature is no wave. */
double
residualOver(const CellGraph& graph, const std::vector<std::int32_t>& window)
{
  using Terms = Eigen::Matrix<double, 6, 1>;
  using Matrix = Eigen::Matrix<double, 6, 6>;
  const Eigen::Vector3d& middle = graph.points[static_cast<std::size_t>(window[0])];
  const Eigen::Vector3d normal = planeOver(graph, window).normal;
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  Matrix matrix = Matrix::Zero();
  Terms right = Terms::Zero();
  double squares = 0;
  for (const std::int32_t member : window) {
    const Eigen::Vector3d from =
        (graph.points[static_cast<std::size_t>(member)] - middle) / graph.spacing;
    const double a = from.dot(u), b = from.dot(v), height = from.dot(normal);
    Terms terms;
    terms << 1, a, b, a * a, a * b, b * b;
    matrix += terms * terms.transpose();
    right += height * terms;
    squares += height * height;
  }
  const double rest = std::max(squares - matrix.ldlt().solve(right).dot(right), 0.0);
  return graph.spacing * std::sqrt(rest / (static_cast<double>(window.size()) -
                                           Terms::RowsAtCompileTime));
}

} // namespace

Waves
measureWaves(const CellGraph& graph, int rings)
{
  constexpr std::size_t min_window = 40, samples = 2000, min_heights = 20;
  Rings window(graph);
  std::vector<double> heights;
  for (std::size_t i = 0; i < graph.size(); i += 1 + graph.size() / samples)
    if (graph.hasNormal(i)) {
      const std::vector<std::int32_t>& around = window.around(i, rings);
      if (around.size() >= min_window)
        heights.push_back(residualOver(graph, around));
    }
  if (heights.size() < min_heights)
    return {};
  return {quantileOf(heights, 0.25), medianOf(heights)};
}

LargeVector<Eigen::Vector3f>
normalsOverWaves(const CellGraph& graph, int rings)
{
  LargeVector<Eigen::Vector3f> normals = graph.normals;
  Rings window(graph);
  for (std::size_t i = 0; i < graph.size(); ++i) {
    if (!graph.hasNormal(i))
      continue;
    const PlaneFit plane = planeOver(graph, window.around(i, rings));
    if (!plane.isPlanar())
      continue;
    const Eigen::Vector3f normal = plane.normal.cast<float>();
    normals[i] = normal.dot(normals[i]) < 0 ? Eigen::Vector3f(-normal) : normal;
  }
  return normals;
}

} // namespace pcl::acmap::planes
