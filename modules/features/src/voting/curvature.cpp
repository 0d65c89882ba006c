#include "voting/curvature.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace pcl::acmap::voting {
namespace {

VotedCurvature
unknown()
{
  constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
  VotedCurvature curvature;
  curvature.direction.setConstant(nothing);
  curvature.first = curvature.second = nothing;
  return curvature;
}

/** 2 sin (phi / 2) for phi = atan2 (s, c). Computed by square roots and divisions only,
 * which are rounded identically on every processor and by every library. */
double
twiceSineOfHalf(double s, double c)
{
  const double r = std::sqrt(s * s + c * c);
  if (!(r > 0))
    return 0;
  return c > 0 ? s * std::sqrt(2 / (r * (r + c)))
               : std::copysign(std::sqrt(2 * (r - c) / r), s);
}

/** Curvature kappa of the arc between two points whose normals, in its plane, differ by
 * phi: the length of the chord is 2 sin (phi / 2) / kappa. */
float
curvatureAlong(const Eigen::Vector3f& tangent,
               const Eigen::Vector3f& normal,
               const Eigen::Vector3f& other_normal,
               float chord)
{
  return static_cast<float>(twiceSineOfHalf(double{other_normal.dot(tangent)},
                                            double{other_normal.dot(normal)}) /
                            double{chord});
}

/** Second fundamental form. The curvature along t = (x, y) of the tangent plane is
 * a x^2 + 2 b x y + c y^2; a, b, c are estimated from the votes by least squares.
 * Page's mean of kappa t t^T is equivalent for uniformly distributed directions, which
 * those of a mesh are not. */
class SecondForm {
public:
  void
  add(const Eigen::Vector2f& t, float kappa, float weight)
  {
    const Eigen::Vector3d square(
        double{t.x()} * t.x(), 2.0 * t.x() * t.y(), double{t.y()} * t.y());
    sum_ += double{weight} * square * square.transpose();
    right_side_ += double{weight} * kappa * square;
    weights_ += weight;
  }

  /** Principal curvatures in a basis of the tangent plane; unknown if there are too few
   * directions. */
  VotedCurvature
  principal(const Eigen::Vector3f& axis_u, const Eigen::Vector3f& axis_v) const
  {
    constexpr double min_spread = 1e-4; // 1 / 16 for uniformly distributed directions
    const Eigen::Matrix3d mean = sum_ / weights_;
    if (!(mean.determinant() > min_spread))
      return unknown();
    const Eigen::Vector3d abc = mean.inverse() * right_side_ / weights_;
    Eigen::Matrix2d form;
    form << abc[0], abc[1], abc[1], abc[2];
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
    solver.computeDirect(form);
    const Eigen::Vector2f kappa = solver.eigenvalues().cast<float>();
    const int larger = std::abs(kappa[0]) > std::abs(kappa[1]) ? 0 : 1;
    const Eigen::Vector2f along = solver.eigenvectors().col(larger).cast<float>();
    return {along[0] * axis_u + along[1] * axis_v, kappa[larger], kappa[1 - larger]};
  }

private:
  Eigen::Matrix3d sum_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_side_ = Eigen::Vector3d::Zero();
  double weights_ = 0;
};

} // namespace

CurvatureVoter::CurvatureVoter(const PointView& points,
                               const VertexRings& rings,
                               const LargeVector<VotedNormal>& normals,
                               double radius)
: points_(points)
, normals_(normals)
, radius_(static_cast<float>(radius))
, disc_(rings, points.size())
{}

VotedCurvature
CurvatureVoter::vote(std::int32_t vertex)
{
  const VotedNormal& own = normals_[static_cast<std::size_t>(vertex)];
  if (own.vertex_class != VertexClass::Surface)
    return unknown();
  disc_.fill(vertex, radius_);
  const Eigen::Vector3f place = points_[static_cast<std::size_t>(vertex)];
  const Eigen::Vector3f axis_u = own.normal.unitOrthogonal();
  const Eigen::Vector3f axis_v = own.normal.cross(axis_u);
  SecondForm form;
  for (const std::int32_t v : disc_.vertices()) {
    const VotedNormal& other = normals_[static_cast<std::size_t>(v)];
    const Eigen::Vector3f way = points_[static_cast<std::size_t>(v)] - place;
    const Eigen::Vector2f flat(way.dot(axis_u), way.dot(axis_v));
    const float length = flat.norm();
    if (other.vertex_class != VertexClass::Surface || !(length > 0))
      continue;
    const Eigen::Vector2f t = flat / length;
    const float kappa = curvatureAlong(
        t[0] * axis_u + t[1] * axis_v, own.normal, other.normal, way.norm());
    form.add(t, kappa, std::exp(-3 * disc_.distance(v) / radius_));
  }
  return form.principal(axis_u, axis_v);
}

} // namespace pcl::acmap::voting
