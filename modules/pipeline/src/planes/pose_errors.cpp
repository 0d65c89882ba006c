#include <pcl/core/impl/cloud_fields.h>
#include <pcl/pipeline/pose_errors.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Sparse>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

namespace pcl {

namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;

using Row6 = Eigen::Matrix<double, 1, 6>;

constexpr std::size_t max_planes = 300, max_views = 2000, min_points = 200;

/** \brief Points of a plane that an observation saw: places u, v on the plane, from its centre,
 * and distances d from it; metres. */
struct Glimpse {
  std::size_t count = 0;
  Vector2d sum = Vector2d::Zero(),
           d_sums = Vector2d::Zero(); ///< of (u, v) and of d (u, v)
  Matrix2d squares = Matrix2d::Zero();
  double d_sum = 0;

  void
  add(const Vector2d& place, double d)
  {
    ++count;
    sum += place;
    squares += place * place.transpose();
    d_sum += d;
    d_sums += d * place;
  }

  double
  number() const
  {
    return static_cast<double>(count);
  }

  Vector2d
  center() const
  {
    return sum / number();
  }

  double
  offset() const
  {
    return d_sum / number();
  }

  Matrix2d
  scatter() const
  {
    return squares / number() - center() * center().transpose();
  }

  /** \brief Covariance between the places and the distances. */
  Vector2d
  bend() const
  {
    return d_sums / number() - offset() * center();
  }
};

/** \brief The glimpses of each plane by observation, those with enough points. */
using Glimpses = std::vector<std::map<std::int32_t, Glimpse>>;

Glimpses
glimpsesOf(const CloudRows& cloud,
           const PointLabels& labels,
           const std::vector<PlanePatch>& planes,
           std::size_t views)
{
  Glimpses glimpses(std::min(planes.size(), max_planes));
  const PCLPointField* const field =
      acmap::findField(cloud.layout(), "view", PCLPointField::INT32);
  if (!field || labels.size() != cloud.size())
    return glimpses;
  const acmap::PointView points = acmap::requirePoints(cloud);
  const std::size_t step = cloud.layout().point_step;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const auto number = static_cast<std::size_t>(labels[i]);
    std::int32_t view = 0;
    std::memcpy(&view, cloud.data() + i * step + field->offset, sizeof view);
    if (labels[i] < 0 || number >= glimpses.size() || view < 0 ||
        static_cast<std::size_t>(view) >= views)
      continue;
    const PlanePatch& plane = planes[number];
    const Vector3d place = points[i].cast<double>();
    const Vector3d arm = place - plane.center;
    glimpses[number][view].add({arm.dot(plane.axis_u), arm.dot(plane.axis_v)},
                               plane.coefficients.dot(place.homogeneous()));
  }
  for (auto& of_plane : glimpses)
    for (auto one = of_plane.begin(); one != of_plane.end();)
      one = one->second.count < min_points ? of_plane.erase(one) : std::next(one);
  return glimpses;
}

/** \brief Sums of residuals of consecutive observations. */
class ResidualSeries {
public:
  /** \brief Begins a new series, as of another plane. */
  void
  begin()
  {
    last_ = none;
  }

  void
  add(double residual)
  {
    squares_ += residual * residual;
    ++number_;
    if (!std::isnan(last_)) {
      products_ += residual * last_;
      both_ += (residual * residual + last_ * last_) / 2;
    }
    last_ = residual;
  }

  /** \brief Standard deviation of independent residuals that would tell as little: those of
   * neighbouring observations are alike, since their poses are wrong together.
   * \param[in] used degrees of freedom that are taken by means */
  double
  deviation(double used) const
  {
    constexpr double least = 1e-4, max_correlation = 0.9; // metres
    const double freedom = number_ - used;
    if (!(freedom > 0))
      return least;
    const double correlation =
        both_ > 0 ? std::clamp(products_ / both_, 0.0, max_correlation) : 0;
    return std::max(
        least, std::sqrt(squares_ / freedom * (1 + correlation) / (1 - correlation)));
  }

private:
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  double squares_ = 0, products_ = 0, both_ = 0, number_ = 0;
  double last_ = none;
};

/** \brief By how much what observations see of a plane differs from it: standard deviations of its
 * offset, and of its slope times the extent that was seen; metres. */
struct Disagreement {
  double offset, bend;
};

Disagreement
disagreementOf(const Glimpses& glimpses)
{
  ResidualSeries offsets;
  std::array<ResidualSeries, 2> bends; // along u and along v
  double means = 0;
  for (const auto& of_plane : glimpses) {
    if (of_plane.size() < 2)
      continue;
    ++means;
    double mean = 0;
    for (const auto& [view, glimpse] : of_plane)
      mean += glimpse.offset() / static_cast<double>(of_plane.size());
    offsets.begin();
    for (ResidualSeries& series : bends)
      series.begin();
    for (const auto& [view, glimpse] : of_plane) {
      offsets.add(glimpse.offset() - mean);
      const Matrix2d scatter = glimpse.scatter();
      for (int k = 0; k < 2; ++k)
        if (scatter(k, k) > 0)
          bends[static_cast<std::size_t>(k)].add(glimpse.bend()[k] /
                                                 std::sqrt(scatter(k, k)));
    }
  }
  return {offsets.deviation(means),
          std::max(bends[0].deviation(0), bends[1].deviation(0))};
}

/** \brief The normal equations of poses and planes. */
class NormalEquations {
public:
  NormalEquations(const PoseErrorModel& model, const std::vector<PlanePatch>& planes)
  : model_(model)
  , planes_(planes)
  , basis_(basisOf(model.up))
  , of_views_(static_cast<int>(model.poses.size()) * static_cast<int>(basis_.cols()))
  {}

  /** \brief Adds what the odometry tells, with the first pose as it is. */
  void
  addOdometry()
  {
    constexpr double fixed = 1e-6; // metres and radians
    for (int k = 0; k < 6; ++k)
      add({{0, Row6(Row6::Unit(k))}}, {}, fixed);
    for (std::size_t i = 0; i + 1 < model_.poses.size(); ++i) {
      const Eigen::Isometry3d motion = model_.poses[i].inverse() * model_.poses[i + 1];
      const double angle = Eigen::AngleAxisd(motion.linear()).angle();
      const double length = motion.translation().norm();
      const OdometryNoise& noise = model_.noise;
      const Vector3d arm =
          model_.poses[i + 1].translation() - model_.poses[i].translation();
      for (int k = 0; k < 3; ++k) {
        Row6 turn = Row6::Zero(), shift = Row6::Zero(), carried = Row6::Zero();
        turn[k] = 1;
        shift[3 + k] = 1;
        // omega x arm, along axis k
        carried.head<3>() = arm.cross(Vector3d(Vector3d::Unit(k))).transpose();
        carried[3 + k] = 1;
        add({{i, Row6(-turn)}, {i + 1, turn}},
            {},
            noise.turn + noise.turn_per_radian * angle);
        add({{i, Row6(-carried)}, {i + 1, shift}},
            {},
            noise.length + noise.length_per_metre * length);
      }
    }
  }

  /** \brief Adds what observations saw of a plane. */
  void
  addPlane(std::size_t plane,
           const std::map<std::int32_t, Glimpse>& glimpses,
           const Disagreement& sigma)
  {
    const PlanePatch& patch = planes_[plane];
    const Vector3d normal = patch.coefficients.head<3>();
    const auto column = static_cast<int>(numbers_.size());
    numbers_.push_back(plane);
    for (const auto& [view, glimpse] : glimpses) {
      const auto i = static_cast<std::size_t>(view);
      const Vector2d center = glimpse.center();
      const Vector3d place =
          patch.center + center.x() * patch.axis_u + center.y() * patch.axis_v;
      Row6 moved;
      moved << (place - model_.poses[i].translation()).cross(normal).transpose(),
          normal.transpose();
      add({{i, moved}},
          {{column, Vector3d(-center.x(), -center.y(), -1)}},
          sigma.offset);
      const Eigen::SelfAdjointEigenSolver<Matrix2d> axes(glimpse.scatter());
      for (int k = 0; k < 2; ++k) {
        const Vector2d axis = axes.eigenvectors().col(k);
        const double extent = std::sqrt(std::max(axes.eigenvalues()[k], 0.0));
        if (!(extent > 0))
          continue;
        const Vector3d along = axis.x() * patch.axis_u + axis.y() * patch.axis_v;
        Row6 turned = Row6::Zero();
        turned.head<3>() = along.cross(normal).transpose();
        add({{i, turned}},
            {{column, Vector3d(-axis.x(), -axis.y(), 0)}},
            sigma.bend / extent);
      }
    }
  }

  /** \brief Indices of the planes, in the order of the covariance. */
  const std::vector<std::size_t>&
  numbers() const
  {
    return numbers_;
  }

  /** \brief The covariance of (slope u, slope v, offset) of all planes; empty if the equations
   * have no solution. */
  MatrixXd
  covariance() const
  {
    const int size = of_views_ + 3 * static_cast<int>(numbers_.size());
    Eigen::SparseMatrix<double> normal(size, size);
    normal.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(normal);
    if (solver.info() != Eigen::Success)
      return {};
    const int of_planes = size - of_views_;
    MatrixXd wanted = MatrixXd::Zero(size, of_planes);
    wanted.bottomRows(of_planes).setIdentity();
    const MatrixXd solved = solver.solve(wanted);
    return (solved.bottomRows(of_planes) + solved.bottomRows(of_planes).transpose()) /
           2;
  }

private:
  struct OfView {
    std::size_t view;
    Row6 row; ///< by its turn and its shift, in the map frame
  };
  struct OfPlane {
    int plane;
    Vector3d row;
  };

  /** \brief The errors that a pose may have, of turn and shift. */
  static Eigen::Matrix<double, 6, Eigen::Dynamic>
  basisOf(const std::optional<Vector3d>& up)
  {
    Eigen::Matrix<double, 6, Eigen::Dynamic> basis;
    if (!up) {
      basis.setIdentity(6, 6);
      return basis;
    }
    const Vector3d along = up->unitOrthogonal();
    basis.setZero(6, 3);
    basis.col(0).head<3>() = up->normalized();
    basis.col(1).tail<3>() = along;
    basis.col(2).tail<3>() = up->normalized().cross(along);
    return basis;
  }

  /** \brief Adds an equation of poses and planes with its standard deviation. */
  void
  add(const std::vector<OfView>& views,
      const std::vector<OfPlane>& planes,
      double sigma)
  {
    std::vector<std::pair<int, double>> row;
    const auto freedom = static_cast<int>(basis_.cols());
    for (const OfView& one : views) {
      const Eigen::RowVectorXd reduced = one.row * basis_;
      for (int k = 0; k < freedom; ++k)
        row.emplace_back(static_cast<int>(one.view) * freedom + k, reduced[k]);
    }
    for (const OfPlane& one : planes)
      for (int k = 0; k < 3; ++k)
        row.emplace_back(of_views_ + 3 * one.plane + k, one.row[k]);
    const double weight = 1 / (sigma * sigma);
    for (const auto& [i, a] : row)
      for (const auto& [j, b] : row)
        if (a != 0 && b != 0)
          entries_.emplace_back(i, j, weight * a * b);
  }

  const PoseErrorModel& model_;
  const std::vector<PlanePatch>& planes_;
  Eigen::Matrix<double, 6, Eigen::Dynamic> basis_;
  int of_views_;
  std::vector<std::size_t> numbers_;
  std::vector<Eigen::Triplet<double>> entries_;
};

/** \brief Extents of a plane along its axes, so that slopes count as lengths; metres. */
Vector3d
extentsOf(const PlanePatch& plane)
{
  constexpr double least = 0.05;
  Eigen::AlignedBox2d box;
  for (const PlanePolygon& polygon : plane.polygons)
    for (const Eigen::Vector3f& corner : polygon.outer) {
      const Vector3d arm = corner.cast<double>() - plane.center;
      box.extend(Vector2d(arm.dot(plane.axis_u), arm.dot(plane.axis_v)));
    }
  const Vector2d half = box.isEmpty() ? Vector2d::Zero() : Vector2d(box.sizes() / 2);
  return {std::max(half.x(), least), std::max(half.y(), least), 1};
}

/** \brief Gives the planes the largest components of their joint covariance. */
void
setModes(const std::vector<std::size_t>& numbers,
         const MatrixXd& covariance,
         std::vector<PlanePatch>& planes)
{
  constexpr Eigen::Index max_modes = 8;
  Eigen::VectorXd scale(covariance.rows());
  for (std::size_t p = 0; p < numbers.size(); ++p)
    scale.segment<3>(3 * static_cast<Eigen::Index>(p)) = extentsOf(planes[numbers[p]]);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(scale.asDiagonal() * covariance *
                                                       scale.asDiagonal());
  const Eigen::Index modes = std::min(max_modes, covariance.rows());
  MatrixXd vectors = solver.eigenvectors().rightCols(modes);
  for (Eigen::Index k = 0; k < modes; ++k) { // their signs are arbitrary
    Eigen::Index largest = 0;
    vectors.col(k).cwiseAbs().maxCoeff(&largest);
    if (vectors(largest, k) < 0)
      vectors.col(k) *= -1;
  }
  for (std::size_t p = 0; p < numbers.size(); ++p) {
    PlanePatch& plane = planes[numbers[p]];
    const Eigen::Index at = 3 * static_cast<Eigen::Index>(p);
    for (Eigen::Index k = modes - 1; k >= 0; --k) { // the largest are the last
      const double value = solver.eigenvalues()[covariance.rows() - modes + k];
      plane.pose_modes.emplace_back(std::sqrt(std::max(value, 0.0)) *
                                    vectors.block<3, 1>(at, k).array() /
                                    scale.segment<3>(at).array());
    }
    plane.covariance += covariance.block<3, 3>(at, at);
  }
}

} // namespace

void
addPoseErrors(const CloudRows& cloud,
              const PointLabels& labels,
              const PoseErrorModel& model,
              std::vector<PlanePatch>& planes)
{
  const std::size_t views = model.poses.size();
  if (!cloud || views < 2 || views > max_views)
    return;
  const Glimpses glimpses = glimpsesOf(cloud, labels, planes, views);
  NormalEquations equations(model, planes);
  equations.addOdometry();
  const Disagreement sigma = disagreementOf(glimpses);
  for (std::size_t plane = 0; plane < glimpses.size(); ++plane)
    if (!glimpses[plane].empty())
      equations.addPlane(plane, glimpses[plane], sigma);
  if (equations.numbers().empty())
    return;
  if (const MatrixXd covariance = equations.covariance();
      covariance.allFinite() && covariance.size() > 0)
    setModes(equations.numbers(), covariance, planes);
}

} // namespace pcl
