#include "noise/noise_window.h"

#include "noise/best_split.h"

#include <pcl/core/impl/moments.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::acmap {

namespace {

constexpr std::size_t quadric_terms = 6, plane_terms = 3;
constexpr std::size_t quadric_points = 24;

/** Residuals of heights over a plane from the quadric that fits them. */
double
roughnessOf(const std::vector<Eigen::Vector3d>& local, double radius)
{
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
  const auto termsOf = [&](const Eigen::Vector3d& p) {
    const double x = p.x() / radius, y = p.y() / radius;
    Eigen::Matrix<double, 6, 1> terms;
    terms << 1, x, y, x * x, x * y, y * y;
    return terms;
  };
  for (const Eigen::Vector3d& p : local) {
    const auto terms = termsOf(p);
    normal += terms * terms.transpose();
    right += p.z() * terms;
  }
  const Eigen::Matrix<double, 6, 1> fit = normal.ldlt().solve(right);
  double squares = 0;
  for (const Eigen::Vector3d& p : local)
    squares += std::pow(p.z() - fit.dot(termsOf(p)), 2);
  return std::sqrt(squares / static_cast<double>(local.size() - quadric_terms));
}

} // namespace

WindowTree::WindowTree(std::vector<Eigen::Vector3f> points)
: points_(std::move(points))
, tree_(points_)
{}

std::vector<Eigen::Vector3f>
WindowTree::nearest(const Eigen::Vector3f& place, std::size_t points) const
{
  Indices indices;
  tree_.find(place, points, indices);
  std::vector<Eigen::Vector3f> found;
  for (const index_t i : indices)
    found.push_back(points_[static_cast<std::size_t>(i)]);
  return found;
}

double
WindowTree::radius(const Eigen::Vector3f& place, std::size_t points) const
{
  double largest = 0;
  for (const Eigen::Vector3f& point : nearest(place, points))
    largest = std::max(largest, static_cast<double>((point - place).norm()));
  return largest;
}

NoiseWindow
windowOf(const WindowTree& tree, const Eigen::Vector3f& place, std::size_t points)
{
  NoiseWindow window;
  const std::vector<Eigen::Vector3f> found = tree.nearest(place, points);
  if (found.size() < points)
    return window;
  const Eigen::Vector3d origin = place.cast<double>();
  Moments moments;
  for (const Eigen::Vector3f& point : found) {
    const Eigen::Vector3d way = point.cast<double>() - origin;
    moments += momentsOf(way);
    window.radius = std::max(window.radius, way.norm());
  }
  const PlaneFit plane = fitPlane(moments);
  const auto n = static_cast<double>(points);
  window.points = points;
  window.mean = origin + plane.mean;
  window.normal = plane.normal;
  window.variances = plane.variances;
  window.thickness =
      std::sqrt(std::max(0.0, plane.variances[0]) * n / (n - plane_terms));
  const Eigen::Vector3d across = plane.normal.cross(plane.long_axis);
  std::vector<Eigen::Vector3d> local;
  std::vector<double> heights;
  for (const Eigen::Vector3f& point : found) {
    const Eigen::Vector3d way = point.cast<double>() - window.mean;
    local.emplace_back(
        way.dot(plane.long_axis), way.dot(across), way.dot(plane.normal));
    heights.push_back(local.back().z());
  }
  std::sort(heights.begin(), heights.end());
  window.split = bestSplit(heights).left;
  window.rough = points < quadric_points || !(window.radius > 0)
                     ? window.thickness
                     : roughnessOf(local, window.radius);
  return window;
}

} // namespace pcl::acmap
