#include "seen_surfaces.h"

#include <pcl/core/exceptions.h>
#include <pcl/pipeline/pose_errors.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Sparse>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <string>

namespace pcl {

namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;

using Row6 = Eigen::Matrix<double, 1, 6>;

/** \brief Equations with a common scale of their noise. */
enum Kind : std::size_t {
  turn_kind,
  shift_kind,
  offset_kind,
  bend_kind,
  still_offset_kind, ///< of planes that no error of a pose moves, as floors under a robot
  still_bend_kind,
  piece_offset_kind, ///< of what is no plane of the map
  piece_bend_kind,
  kinds
};

using Scales = std::array<double, kinds>;

/** \brief A linear equation of the unknowns: row x + residual = noise. */
struct Equation {
  std::vector<std::pair<int, double>> row;
  double residual;
  double sigma; ///< of the noise, to be scaled by that of its kind
  Kind kind;
};

/** \brief The equations of the errors of poses, of the odometry and of planes. */
class PoseEquations {
public:
  PoseEquations(const PoseErrorModel& model, const std::vector<PlanePatch>& planes)
  : model_(model)
  , planes_(planes)
  , basis_(basisOf(model.up))
  , freedom_(static_cast<int>(basis_.cols()))
  , of_poses_(static_cast<int>(model.poses.size()) * freedom_)
  {}

  /** \brief Adds what the odometry tells. Its errors are independent, and one that all steps
   * share, in the frame of the sensor and in standard deviations of a step. */
  void
  addOdometry()
  {
    for (std::size_t i = 0; i + 1 < model_.poses.size(); ++i)
      addStep(i);
    for (int k = 0; k < freedom_; ++k)
      add({{bias(), Row6(basis_.col(k).transpose())}}, {}, 0, 1, kindOf(k));
  }

  /** \brief Adds what observations saw of a plane. */
  void
  addPlane(std::size_t plane, const acmap::Glimpses& glimpses)
  {
    const bool is_still = isStill(planes_[plane].coefficients.head<3>());
    numbers_.push_back(plane);
    addSurface(planes_[plane],
               glimpses,
               is_still ? still_offset_kind : offset_kind,
               is_still ? still_bend_kind : bend_kind);
  }

  /** \brief Adds what observations saw of something else, after all planes. */
  void
  addPiece(const acmap::LoosePiece& piece)
  {
    addSurface(piece.patch, piece.glimpses, piece_offset_kind, piece_bend_kind);
  }

  const std::vector<Equation>&
  all() const
  {
    return equations_;
  }

  int
  unknowns() const
  {
    return of_poses_ + 3 * surfaces_;
  }

  /** \brief The first unknown of planes: slope u, slope v and offset of each. */
  int
  beginOfPlanes() const
  {
    return of_poses_;
  }

  /** \brief Indices of the planes, in the order of the unknowns. */
  const std::vector<std::size_t>&
  numbers() const
  {
    return numbers_;
  }

private:
  struct OfPose {
    std::size_t pose;
    Row6 row; ///< by its turn and its shift, in the map frame
  };
  struct OfSurface {
    int surface;
    Vector3d row;
  };

  void
  addSurface(const PlanePatch& patch,
             const acmap::Glimpses& glimpses,
             Kind offset_kind,
             Kind bend_kind)
  {
    const Vector3d normal = patch.coefficients.head<3>();
    const int column = surfaces_++;
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
          glimpse.offset(),
          1,
          offset_kind);
      const Eigen::SelfAdjointEigenSolver<Matrix2d> axes(glimpse.scatter());
      for (int k = 0; k < 2; ++k) {
        const Vector2d axis = axes.eigenvectors().col(k);
        const double variance = axes.eigenvalues()[k];
        if (!(variance > 0))
          continue;
        const Vector3d along = axis.x() * patch.axis_u + axis.y() * patch.axis_v;
        Row6 turned = Row6::Zero();
        turned.head<3>() = along.cross(normal).transpose();
        add({{i, turned}},
            {{column, Vector3d(-axis.x(), -axis.y(), 0)}},
            axis.dot(glimpse.bend()) / variance,
            1 / std::sqrt(variance),
            bend_kind);
      }
    }
  }

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

  Kind
  kindOf(int error) const
  {
    return basis_.col(error).head<3>().isZero() ? shift_kind : turn_kind;
  }

  bool
  isStill(const Vector3d& normal) const
  {
    constexpr double level = 0.9; // cosine
    return model_.up && std::abs(model_.up->normalized().dot(normal)) > level;
  }

  /** \brief Number of the common error of the odometry, which follows those of the poses. */
  std::size_t
  bias() const
  {
    return model_.poses.size();
  }

  void
  addStep(std::size_t i)
  {
    const Eigen::Isometry3d &from = model_.poses[i], &to = model_.poses[i + 1];
    const Eigen::Isometry3d motion = from.inverse() * to;
    const Eigen::Isometry3d told =
        model_.before.empty() ? motion
                              : model_.before[i].inverse() * model_.before[i + 1];
    const Eigen::AngleAxisd turned(motion.linear() * told.linear().transpose());
    const Vector3d turn = from.linear() * (turned.angle() * turned.axis());
    const Vector3d shift = from.linear() * (motion.translation() - told.translation());
    const OdometryNoise& noise = model_.noise;
    const double turn_sigma =
        noise.turn + noise.turn_per_radian * Eigen::AngleAxisd(told.linear()).angle();
    const double shift_sigma =
        noise.length + noise.length_per_metre * told.translation().norm();
    const Matrix3d since_first =
        from.linear() * model_.poses.front().linear().transpose();
    const Vector3d arm = to.translation() - from.translation();
    for (int k = 0; k < freedom_; ++k) {
      const Kind kind = kindOf(k);
      const bool is_turn = kind == turn_kind;
      const Vector3d axis = is_turn ? basis_.col(k).head<3>() : basis_.col(k).tail<3>();
      const double sigma = is_turn ? turn_sigma : shift_sigma;
      Row6 begin = Row6::Zero(), end = Row6::Zero(), shared = Row6::Zero();
      end.segment<3>(is_turn ? 0 : 3) = axis.transpose();
      begin = -end;
      if (!is_turn)
        begin.head<3>() = -arm.cross(axis).transpose(); // omega x arm
      shared.segment<3>(is_turn ? 0 : 3) =
          -sigma * (since_first.transpose() * axis).transpose();
      add({{i, begin}, {i + 1, end}, {bias(), shared}},
          {},
          axis.dot(is_turn ? turn : shift),
          sigma,
          kind);
    }
  }

  /** \brief Adds an equation; the first pose has no error. */
  void
  add(const std::vector<OfPose>& poses,
      const std::vector<OfSurface>& surfaces,
      double residual,
      double sigma,
      Kind kind)
  {
    Equation equation{{}, residual, sigma, kind};
    for (const OfPose& one : poses) {
      const Eigen::RowVectorXd reduced = one.row * basis_;
      for (int k = 0; k < freedom_ && one.pose > 0; ++k)
        if (reduced[k] != 0)
          equation.row.emplace_back((static_cast<int>(one.pose) - 1) * freedom_ + k,
                                    reduced[k]);
    }
    for (const OfSurface& one : surfaces)
      for (int k = 0; k < 3; ++k)
        equation.row.emplace_back(of_poses_ + 3 * one.surface + k, one.row[k]);
    equations_.push_back(std::move(equation));
  }

  const PoseErrorModel& model_;
  const std::vector<PlanePatch>& planes_;
  Eigen::Matrix<double, 6, Eigen::Dynamic> basis_;
  int freedom_;
  int of_poses_; ///< number of unknowns: all poses but the first, and the common error
  int surfaces_ = 0;
  std::vector<std::size_t> numbers_;
  std::vector<Equation> equations_;
};

/** \brief Solves the equations by least squares, with scales of the noise that agree with what is
 * left of the residuals. */
class PoseErrorSolution {
public:
  explicit PoseErrorSolution(const PoseEquations& equations)
  : equations_(equations)
  {
    constexpr int rounds = 6; // until the scales change by less than 1 %
    for (int round = 0; round < rounds && solve(); ++round)
      rescale();
    is_solved_ = is_solved_ && solve();
  }

  /** \brief Mean of the products of the errors of all planes, slope u, slope v and offset of each:
   * their covariance, and the product of what the most likely ones are, since the map is not
   * corrected by these. Empty without a solution. */
  MatrixXd
  squaredErrors() const
  {
    if (!is_solved_)
      return {};
    const int begin = equations_.beginOfPlanes();
    const int size = 3 * static_cast<int>(equations_.numbers().size());
    MatrixXd wanted = MatrixXd::Zero(equations_.unknowns(), size);
    wanted.middleRows(begin, size).setIdentity();
    const MatrixXd covariance = solver_.solve(wanted).middleRows(begin, size);
    const Eigen::VectorXd likely = errors_.segment(begin, size);
    return (covariance + covariance.transpose()) / 2 + likely * likely.transpose();
  }

private:
  using Matrix = Eigen::SparseMatrix<double>;

  bool
  solve()
  {
    const std::vector<Equation>& all = equations_.all();
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd residuals(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double weight = 1 / (all[i].sigma * scales_[all[i].kind]);
      for (const auto& [column, value] : all[i].row)
        entries.emplace_back(static_cast<int>(i), column, weight * value);
      residuals[static_cast<Eigen::Index>(i)] = weight * all[i].residual;
    }
    weighted_ = Matrix(static_cast<int>(all.size()), equations_.unknowns());
    weighted_.setFromTriplets(entries.begin(), entries.end());
    solver_.compute(Matrix(weighted_.transpose() * weighted_));
    is_solved_ = solver_.info() == Eigen::Success;
    if (!is_solved_)
      return false;
    errors_ = -solver_.solve(weighted_.transpose() * residuals);
    left_ = residuals + weighted_ * errors_;
    return true;
  }

  /** \brief How many degrees of freedom the unknowns take from each kind: the trace of its part of
   * the hat matrix, by random signs. */
  Scales
  takenFreedom() const
  {
    constexpr Eigen::Index probes = 128, at_once = 8; // all at once may be a gigabyte
    std::mt19937 random; // of its default seed, the same in every run
    Eigen::VectorXd taken = Eigen::VectorXd::Zero(weighted_.rows());
    MatrixXd signs(weighted_.rows(), at_once);
    for (Eigen::Index probe = 0; probe < probes; probe += at_once) {
      for (double& sign : signs.reshaped())
        sign = random() & 1U ? 1 : -1;
      const MatrixXd hat = weighted_ * solver_.solve(weighted_.transpose() * signs);
      taken += signs.cwiseProduct(hat).rowwise().sum();
    }
    Scales sums{};
    for (std::size_t i = 0; i < equations_.all().size(); ++i)
      sums[equations_.all()[i].kind] += taken[static_cast<Eigen::Index>(i)] / probes;
    return sums;
  }

  /** \brief Sets the scales to those of the residuals; the first ones count as much as three
   * residuals. */
  void
  rescale()
  {
    constexpr double residuals_of_first = 3;
    const Scales taken = takenFreedom();
    Scales squares{}, numbers{};
    for (std::size_t i = 0; i < equations_.all().size(); ++i) {
      const Kind kind = equations_.all()[i].kind;
      squares[kind] += std::pow(scales_[kind] * left_[static_cast<Eigen::Index>(i)], 2);
      ++numbers[kind];
    }
    for (std::size_t kind = 0; kind < kinds; ++kind)
      scales_[kind] =
          std::sqrt((residuals_of_first * first_scales[kind] * first_scales[kind] +
                     squares[kind]) /
                    (residuals_of_first + std::max(0.0, numbers[kind] - taken[kind])));
  }

  /** Of the stated noise of the odometry; metres, of the offset and the rim of what is seen. */
  static constexpr Scales first_scales{1, 1, 0.002, 0.002, 0.002, 0.002, 0.01, 0.01};

  const PoseEquations& equations_;
  Scales scales_ = first_scales;
  Matrix weighted_; ///< rows in standard deviations
  Eigen::SimplicialLDLT<Matrix> solver_;
  Eigen::VectorXd errors_, left_;
  bool is_solved_ = false;
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

/** \brief Gives the planes the largest components of their joint squared errors. */
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
  constexpr std::size_t max_views = 2000;
  const std::size_t views = model.poses.size();
  if (!cloud || views < 2 || views > max_views)
    return;
  if (!model.before.empty() && model.before.size() != views)
    throw acmap::BadArgument(
        std::to_string(model.before.size()) + " poses before the correction of " +
        std::to_string(views) + " are refused: there must be one per pose, or none");
  PoseEquations equations(model, planes);
  equations.addOdometry();
  const std::vector<acmap::Glimpses> glimpses =
      acmap::glimpsesOfPlanes(cloud, labels, planes, model.poses);
  for (std::size_t plane = 0; plane < glimpses.size(); ++plane)
    if (!glimpses[plane].empty())
      equations.addPlane(plane, glimpses[plane]);
  if (equations.numbers().empty())
    return;
  for (const acmap::LoosePiece& piece : acmap::loosePieces(cloud, labels, model.poses))
    equations.addPiece(piece);
  const MatrixXd squares = PoseErrorSolution(equations).squaredErrors();
  if (squares.allFinite() && squares.size() > 0)
    setModes(equations.numbers(), squares, planes);
}

} // namespace pcl
