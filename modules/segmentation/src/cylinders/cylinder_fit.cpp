#include "cylinders/cylinder_fit.h"

#include <pcl/core/impl/parallel.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace pcl::acmap::cylinders {
namespace {

constexpr double gate_sigmas = 4;

/** Tukey's biweight; 0 beyond its gate. */
double
tukeyWeight(double residual, double gate)
{
  const double rest = 1 - std::pow(residual / gate, 2);
  return rest > 0 ? rest * rest : 0;
}

/** The function whose minimum is sought, in units of its maximum. */
double
tukeyCost(double residual, double gate)
{
  const double rest = 1 - std::pow(residual / gate, 2);
  return rest > 0 ? 1 - rest * rest * rest : 1;
}

/** Derivative of the offset by shifts, tilts and radius. */
Vector5
slopeOf(const Offset& offset, const Cylinder& cylinder, const CylinderFit& frame)
{
  const double nu = offset.normal.dot(frame.u), nv = offset.normal.dot(frame.v);
  const double z = cylinder.along(offset.foot);
  Vector5 slope;
  slope << nu, nv, z * nu, z * nv, 1;
  return -slope / offset.slant;
}

void
setFrame(CylinderFit& fit)
{
  fit.u = fit.cylinder.axis.unitOrthogonal();
  fit.v = fit.cylinder.axis.cross(fit.u);
}

Cylinder
retracted(const CylinderFit& fit, const Vector5& step)
{
  Cylinder moved = fit.cylinder;
  moved.point += step[0] * fit.u + step[1] * fit.v;
  moved.axis = (moved.axis + step[2] * fit.u + step[3] * fit.v).normalized();
  moved.radius += step[4];
  return moved;
}

/** Normal equations at a cylinder, and its cost. */
struct Equations {
  Matrix5 matrix = Matrix5::Zero();
  Vector5 right = Vector5::Zero();
  double cost = 0;
};

Equations
equationsAt(const std::vector<Sample>& samples, const CylinderFit& fit, double gate)
{
  const auto sumOf = [&](std::size_t begin, std::size_t end) {
    Equations sums;
    for (std::size_t i = begin; i < end; ++i) {
      const Offset offset(fit.cylinder, samples[i]);
      sums.cost += offset.exists ? tukeyCost(offset.value, gate) : 1;
      if (!offset.exists || std::abs(offset.slant) < min_slant / 2)
        continue;
      const double weight = tukeyWeight(offset.value, gate);
      if (weight == 0)
        continue;
      const Vector5 slope = slopeOf(offset, fit.cylinder, fit);
      sums.matrix.noalias() += (weight * slope) * slope.transpose();
      sums.right -= weight * offset.value * slope;
    }
    return sums;
  };
  return parallelReduceChunks(
      samples.size(), Equations(), sumOf, [](Equations& all, const Equations& more) {
        all.matrix += more.matrix;
        all.right += more.right;
        all.cost += more.cost;
      });
}

/** The samples whose rays do not graze the cylinder: a selection by the rays, unlike
 * one by the measured points, does not depend on the noise and does not shift the
 * fit. */
std::vector<Sample>
steepSamples(const std::vector<Sample>& samples, const Cylinder& cylinder)
{
  std::vector<Sample> steep;
  for (const Sample& sample : samples) {
    const Offset offset(cylinder, sample);
    if (offset.exists && std::abs(offset.slant) >= min_slant)
      steep.push_back(sample);
  }
  return steep;
}

/** Moves the point of the axis to the middle of the samples. */
void
setMiddle(const std::vector<Sample>& samples, Cylinder& cylinder)
{
  double sum = 0;
  for (const Sample& sample : samples)
    sum += cylinder.along(sample.point);
  cylinder.point += sum / static_cast<double>(samples.size()) * cylinder.axis;
}

/** Descends from a cylinder over fixed samples.
 * \return false if a step is not finite */
bool
descend(const std::vector<Sample>& samples,
        double gate,
        int max_steps,
        CylinderFit& fit)
{
  constexpr double settled = 1e-6, max_damping = 1e6; // the first in units of the gate
  const double count = static_cast<double>(samples.size());
  double damping = 1e-4;
  Equations sums = equationsAt(samples, fit, gate);
  for (int i = 0; i < max_steps && damping <= max_damping; ++i) {
    Matrix5 damped = sums.matrix;
    damped.diagonal() *= 1 + damping;
    const Vector5 step = damped.ldlt().solve(sums.right);
    if (!step.allFinite())
      return false;
    CylinderFit moved = fit;
    moved.cylinder = retracted(fit, step);
    setFrame(moved);
    damping *= 10;
    if (!(moved.cylinder.radius > 0))
      continue;
    const Equations next = equationsAt(samples, moved, gate);
    if (next.cost > sums.cost)
      continue;
    const double change = std::sqrt(step.dot(sums.matrix * step) / count);
    fit = moved;
    sums = next;
    damping = std::max(damping / 100, 1e-9);
    if (change < settled * gate)
      break;
  }
  return true;
}

constexpr std::size_t min_samples = 8;

/** Descends over the samples whose rays do not graze the cylinder.
 * \return false if the samples do not determine one */
bool
approach(const std::vector<Sample>& samples,
         double gate,
         int max_steps,
         CylinderFit& fit)
{
  const std::vector<Sample> steep = steepSamples(samples, fit.cylinder);
  if (steep.size() < min_samples)
    return false;
  setMiddle(steep, fit.cylinder);
  setFrame(fit);
  return descend(steep, gate, max_steps, fit);
}

using PatchKey = std::pair<std::int64_t, std::int64_t>;

} // namespace

std::optional<Cylinder>
cylinderOfNormals(const std::vector<Eigen::Vector3d>& points,
                  const std::vector<Eigen::Vector3d>& normals,
                  const Eigen::Vector3d& axis,
                  double& residual)
{
  const double count = static_cast<double>(points.size());
  const auto flat = [&](const Eigen::Vector3d& vector) {
    return Eigen::Vector3d(vector - vector.dot(axis) * axis);
  };
  Eigen::Vector3d mean_point = Eigen::Vector3d::Zero();
  Eigen::Vector3d mean_normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    mean_point += flat(points[i]) / count;
    mean_normal += flat(normals[i]) / count;
  }
  double products = 0, squares = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d normal = flat(normals[i]) - mean_normal;
    products += normal.dot(flat(points[i]) - mean_point);
    squares += normal.squaredNorm();
  }
  Cylinder cylinder;
  cylinder.axis = axis;
  cylinder.radius = products / squares;
  if (!std::isfinite(cylinder.radius) || cylinder.radius == 0)
    return {};
  cylinder.point = mean_point - cylinder.radius * mean_normal;
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    sum += (flat(points[i]) - cylinder.point - cylinder.radius * flat(normals[i]))
               .squaredNorm();
  residual = std::sqrt(sum / count);
  return cylinder;
}

// G. Taubin, "Estimation of planar curves, surfaces and nonplanar space curves defined
// by implicit equations", PAMI 13, 1991: minimises the algebraic distance over the
// squared gradient. The smallest root of the characteristic polynomial is found by
// Newton's method from 0, which converges from below.
std::optional<Cylinder>
cylinderOfCircle(const std::vector<Sample>& samples, const Eigen::Vector3d& axis)
{
  const double count = static_cast<double>(samples.size());
  const Eigen::Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Sample& sample : samples)
    middle += Eigen::Vector2d(sample.point.dot(u), sample.point.dot(v)) / count;
  double xx = 0, yy = 0, xy = 0, xz = 0, yz = 0, zz = 0;
  for (const Sample& sample : samples) {
    const double x = sample.point.dot(u) - middle.x();
    const double y = sample.point.dot(v) - middle.y();
    const double z = x * x + y * y;
    xx += x * x / count;
    yy += y * y / count;
    xy += x * y / count;
    xz += x * z / count;
    yz += y * z / count;
    zz += z * z / count;
  }
  const double z_mean = xx + yy, determinant = xx * yy - xy * xy;
  const double z_variance = zz - z_mean * z_mean;
  const double a3 = 4 * z_mean, a2 = -3 * z_mean * z_mean - zz;
  const double a1 = z_variance * z_mean + 4 * determinant * z_mean - xz * xz - yz * yz;
  const double a0 =
      xz * (xz * yy - yz * xy) + yz * (yz * xx - xz * xy) - determinant * z_variance;
  double root = 0;
  constexpr int max_steps = 30;
  for (int i = 0; i < max_steps; ++i) {
    const double value = a0 + root * (a1 + root * (a2 + root * a3));
    const double slope = a1 + root * (2 * a2 + root * 3 * a3);
    const double next = root - value / slope;
    if (!std::isfinite(next) || std::abs(next - root) <= 1e-14 * std::abs(next))
      break;
    root = next;
  }
  const double scale = root * root - root * z_mean + determinant;
  const Eigen::Vector2d center((xz * (yy - root) - yz * xy) / scale / 2,
                               (yz * (xx - root) - xz * xy) / scale / 2);
  Cylinder cylinder;
  cylinder.axis = axis;
  cylinder.radius = std::sqrt(center.squaredNorm() + z_mean);
  const Eigen::Vector2d place = middle + center;
  cylinder.point = place.x() * u + place.y() * v;
  if (!std::isfinite(cylinder.radius) || !(cylinder.radius > 0))
    return {};
  return cylinder;
}

std::optional<CylinderFit>
roughFit(const std::vector<Sample>& samples, const Cylinder& start, double sigma)
{
  constexpr std::size_t enough = 500;
  constexpr int few_steps = 5;
  CylinderFit fit;
  fit.cylinder = start;
  if (!approach(thinned(samples, enough), gate_sigmas * sigma, few_steps, fit))
    return {};
  return fit;
}

std::optional<CylinderFit>
fitCylinder(const std::vector<Sample>& samples, const Cylinder& start, double sigma)
{
  constexpr std::size_t enough_to_approach = 2000;
  constexpr int max_steps = 20;
  const double gate = gate_sigmas * sigma;
  const std::vector<Sample> some = thinned(samples, enough_to_approach);
  CylinderFit fit;
  fit.cylinder = start;
  for (const auto* const pool :
       {&some, &some, &samples}) // steep samples change with it
    if (!approach(*pool, gate, max_steps, fit))
      return {};
  double squares = 0;
  for (const Sample& sample : steepSamples(samples, fit.cylinder)) {
    const Offset offset(fit.cylinder, sample);
    if (std::abs(offset.value) >= gate)
      continue;
    squares += offset.value * offset.value;
    ++fit.count;
  }
  if (fit.count < min_samples)
    return {};
  fit.rms = std::sqrt(squares / static_cast<double>(fit.count));
  return fit;
}

void
setCovariance(const std::vector<Sample>& samples,
              double sigma,
              double patch,
              CylinderFit& fit)
{
  constexpr std::size_t min_patches = 12;
  const double gate = gate_sigmas * sigma;
  const Development development(fit.cylinder);
  Matrix5 matrix = Matrix5::Zero();
  std::map<PatchKey, Vector5> scores; // of the patches
  double slopes = 0, count = 0;
  for (const Sample& sample : steepSamples(samples, fit.cylinder)) {
    const Offset offset(fit.cylinder, sample);
    const double rest = 1 - std::pow(offset.value / gate, 2);
    if (rest <= 0)
      continue;
    const Vector5 slope = slopeOf(offset, fit.cylinder, fit);
    matrix += slope * slope.transpose();
    slopes += rest * (5 * rest - 4); // derivative of the weighted residual
    count += 1;
    const double angle = development.angle(offset.normal) * fit.cylinder.radius;
    const PatchKey key(std::llround(angle / patch),
                       std::llround(fit.cylinder.along(offset.foot) / patch));
    const auto [score, is_new] = scores.try_emplace(key, Vector5::Zero());
    score->second += rest * rest * offset.value * slope;
  }
  fit.covariance.setConstant(std::nan(""));
  if (scores.size() < min_patches)
    return;
  const Eigen::LDLT<Matrix5> solver(matrix * (slopes / count));
  Matrix5 covariance = Matrix5::Zero();
  for (const auto& [key, score] : scores) {
    const Vector5 shift = solver.solve(score);
    covariance += shift * shift.transpose();
  }
  const double patches = static_cast<double>(scores.size());
  covariance *= patches / (patches - 5); // five fitted parameters
  if (covariance.allFinite())
    fit.covariance = covariance;
}

double
misfit(const std::vector<Sample>& samples, const CylinderFit& fit, double noise)
{
  constexpr int terms = 14; // five of the cylinder, nine beyond
  using Terms = Eigen::Matrix<double, terms, 1>;
  using Matrix = Eigen::Matrix<double, terms, terms>;
  const Development development(fit.cylinder);
  double half = 0;
  for (const Sample& sample : samples)
    half = std::max(half, std::abs(fit.cylinder.along(sample.point)));
  Matrix matrix = Matrix::Zero();
  Terms right = Terms::Zero();
  double squares = 0, count = 0;
  for (const Sample& sample : samples) {
    const Offset offset(fit.cylinder, sample);
    if (!offset.exists || std::abs(offset.slant) < min_slant)
      continue;
    const double a = development.angle(offset.normal);
    const double z = fit.cylinder.along(offset.foot) / half;
    const double cos1 = std::cos(a), sin1 = std::sin(a);
    const double cos2 = std::cos(2 * a), sin2 = std::sin(2 * a);
    Terms slope;
    slope << 1, cos1, sin1, z * cos1, z * sin1, z, z * z, cos2, sin2, z * cos2,
        z * sin2, z * z * cos1, z * z * sin1, z * z * z;
    slope /= offset.slant;
    matrix += slope * slope.transpose();
    right += offset.value * slope;
    squares += offset.value * offset.value;
    count += 1;
  }
  matrix.diagonal().array() += 1e-9 * count; // narrow arcs have fewer terms
  const double explained = right.dot(matrix.ldlt().solve(right));
  return explained / std::max(squares, count * noise * noise);
}

} // namespace pcl::acmap::cylinders
