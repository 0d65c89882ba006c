#include <pcl/core/exceptions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/pipeline/pose_errors.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Sparse>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
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

/** \brief Calls see (point, observation, plane or -1) for the points of a cloud that observations
 * have seen. */
template <typename See>
void
forEachSeen(const CloudRows& cloud,
            const PointLabels& labels,
            std::size_t views,
            const See& see)
{
  const PCLPointField* const field =
      acmap::findField(cloud.layout(), "view", PCLPointField::INT32);
  if (!field || labels.size() != cloud.size())
    return;
  const acmap::PointView points = acmap::requirePoints(cloud);
  const std::size_t step = cloud.layout().point_step;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    std::int32_t view = 0;
    std::memcpy(&view, cloud.data() + i * step + field->offset, sizeof view);
    if (view >= 0 && static_cast<std::size_t>(view) < views)
      see(points[i], view, labels[i]);
  }
}

void
dropSparse(std::size_t min_count, std::map<std::int32_t, Glimpse>& glimpses)
{
  for (auto one = glimpses.begin(); one != glimpses.end();)
    one = one->second.count < min_count ? glimpses.erase(one) : std::next(one);
}

Glimpses
glimpsesOf(const CloudRows& cloud,
           const PointLabels& labels,
           const std::vector<PlanePatch>& planes,
           std::size_t views)
{
  Glimpses glimpses(std::min(planes.size(), max_planes));
  forEachSeen(cloud,
              labels,
              views,
              [&](const Eigen::Vector3f& point, std::int32_t view, std::int32_t label) {
                if (label < 0 || static_cast<std::size_t>(label) >= glimpses.size())
                  return;
                const auto number = static_cast<std::size_t>(label);
                const PlanePatch& plane = planes[number];
                const Vector3d place = point.cast<double>();
                const Vector3d arm = place - plane.center;
                glimpses[number][view].add(
                    {arm.dot(plane.axis_u), arm.dot(plane.axis_v)},
                    plane.coefficients.dot(place.homogeneous()));
              });
  for (auto& of_plane : glimpses)
    dropSparse(min_points, of_plane);
  return glimpses;
}

/** \brief Keeps the observations that see the front of a plane, which is where most of its points
 * were seen from: points of a thin wall's other face are labelled alike. */
void
keepFront(const PlanePatch& plane,
          const std::vector<Eigen::Isometry3d>& poses,
          std::map<std::int32_t, Glimpse>& glimpses)
{
  const auto isBefore = [&](std::int32_t view) {
    const Vector3d sensor = poses[static_cast<std::size_t>(view)].translation();
    return plane.coefficients.dot(sensor.homogeneous()) > 0;
  };
  double balance = 0;
  for (const auto& [view, glimpse] : glimpses)
    balance += isBefore(view) ? glimpse.number() : -glimpse.number();
  for (auto one = glimpses.begin(); one != glimpses.end();)
    one = isBefore(one->first) == (balance > 0) ? std::next(one) : glimpses.erase(one);
}

/** \brief Sums of points. */
struct Moments {
  std::size_t count = 0;
  Vector3d sum = Vector3d::Zero();
  Matrix3d squares = Matrix3d::Zero();

  void
  add(const Vector3d& point)
  {
    ++count;
    sum += point;
    squares += point * point.transpose();
  }

  void
  add(const Moments& other)
  {
    count += other.count;
    sum += other.sum;
    squares += other.squares;
  }

  Vector3d
  mean() const
  {
    return sum / static_cast<double>(count);
  }

  Matrix3d
  covariance() const
  {
    return squares / static_cast<double>(count) - mean() * mean().transpose();
  }

  /** \brief The same points as they lie on a plane. */
  Glimpse
  on(const PlanePatch& plane, const Vector3d& center) const
  {
    Eigen::Matrix<double, 2, 3> axes;
    axes << plane.axis_u.transpose(), plane.axis_v.transpose();
    const Vector3d normal = plane.coefficients.head<3>();
    const double number = static_cast<double>(count);
    const Vector3d arms = sum - number * center;
    const Matrix3d products = squares - sum * center.transpose() -
                              center * sum.transpose() +
                              number * center * center.transpose();
    Glimpse glimpse;
    glimpse.count = count;
    glimpse.sum = axes * arms;
    glimpse.d_sums = axes * products * normal;
    glimpse.squares = axes * products * axes.transpose();
    glimpse.d_sum = normal.dot(arms);
    return glimpse;
  }
};

/** \brief A small flat piece of what is no plane of the map: clutter, columns, frames. */
struct Piece {
  PlanePatch patch; ///< centre, axes and coefficients
  std::map<std::int32_t, Glimpse> glimpses;
  std::size_t count = 0;
};

/** \brief Cells of space with the points that belong to no plane, by observation. */
class LooseCells {
public:
  void
  add(const Eigen::Vector3f& point, std::int32_t view)
  {
    const Eigen::Array3d place = point.cast<double>().array() / edge;
    if (!((place.abs() < limit).all()))
      return;
    const Cell cell{static_cast<int>(std::floor(place[0])),
                    static_cast<int>(std::floor(place[1])),
                    static_cast<int>(std::floor(place[2]))};
    if (cells_.size() < max_cells || cells_.count(cell) > 0)
      cells_[cell][view].add(point.cast<double>() - cornerOf(cell));
  }

  /** \brief The flat pieces that several observations saw, those with the most points. */
  std::vector<Piece>
  pieces(const std::vector<Eigen::Isometry3d>& poses) const
  {
    std::vector<Piece> found;
    for (const auto& [cell, by_view] : cells_)
      if (std::optional<Piece> piece = pieceOf(cell, by_view, poses))
        found.push_back(std::move(*piece));
    std::stable_sort(found.begin(), found.end(), [](const Piece& a, const Piece& b) {
      return a.count > b.count;
    });
    found.resize(std::min(found.size(), max_pieces));
    return found;
  }

private:
  using Cell = std::array<int, 3>;

  static constexpr double edge = 0.25, limit = 1e8; // metres, cells
  static constexpr std::size_t max_cells = 100000, max_pieces = 500;

  static Vector3d
  cornerOf(const Cell& cell)
  {
    return edge * Vector3d(cell[0], cell[1], cell[2]);
  }

  static std::optional<Piece>
  pieceOf(const Cell& cell,
          const std::map<std::int32_t, Moments>& by_view,
          const std::vector<Eigen::Isometry3d>& poses)
  {
    constexpr std::size_t min_of_view = 30;
    constexpr double max_thickness = 0.02, min_extent = 0.03; // metres
    Moments all;
    for (const auto& [view, moments] : by_view)
      if (moments.count >= min_of_view)
        all.add(moments);
    if (by_view.size() < 2 || all.count < 2 * min_of_view)
      return std::nullopt;
    const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(all.covariance());
    if (!(axes.eigenvalues()[0] < max_thickness * max_thickness) ||
        !(axes.eigenvalues()[1] > min_extent * min_extent))
      return std::nullopt;
    Piece piece;
    PlanePatch& patch = piece.patch;
    patch.center = cornerOf(cell) + all.mean();
    const Vector3d normal = axes.eigenvectors().col(0);
    patch.axis_u = axes.eigenvectors().col(2);
    patch.axis_v = normal.cross(patch.axis_u);
    patch.coefficients << normal, -normal.dot(patch.center);
    for (const auto& [view, moments] : by_view)
      if (moments.count >= min_of_view)
        piece.glimpses[view] = moments.on(patch, all.mean());
    keepFront(patch, poses, piece.glimpses);
    for (const auto& [view, glimpse] : piece.glimpses)
      piece.count += glimpse.count;
    return piece.glimpses.size() < 2 ? std::nullopt : std::optional(piece);
  }

  std::map<Cell, std::map<std::int32_t, Moments>> cells_;
};

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
  addPlane(std::size_t plane, const std::map<std::int32_t, Glimpse>& glimpses)
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
  addPiece(const Piece& piece)
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
             const std::map<std::int32_t, Glimpse>& glimpses,
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
    constexpr Eigen::Index probes = 128;
    std::mt19937 random; // of its default seed, the same in every run
    MatrixXd signs(weighted_.rows(), probes);
    for (double& sign : signs.reshaped())
      sign = random() & 1U ? 1 : -1;
    const MatrixXd hat = weighted_ * solver_.solve(weighted_.transpose() * signs);
    const Eigen::VectorXd taken = signs.cwiseProduct(hat).rowwise().mean();
    Scales sums{};
    for (std::size_t i = 0; i < equations_.all().size(); ++i)
      sums[equations_.all()[i].kind] += taken[static_cast<Eigen::Index>(i)];
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
  const std::size_t views = model.poses.size();
  if (!cloud || views < 2 || views > max_views)
    return;
  if (!model.before.empty() && model.before.size() != views)
    throw acmap::BadArgument(
        std::to_string(model.before.size()) + " poses before the correction of " +
        std::to_string(views) + " are refused: there must be one per pose, or none");
  Glimpses glimpses = glimpsesOf(cloud, labels, planes, views);
  PoseEquations equations(model, planes);
  equations.addOdometry();
  for (std::size_t plane = 0; plane < glimpses.size(); ++plane) {
    keepFront(planes[plane], model.poses, glimpses[plane]);
    if (!glimpses[plane].empty())
      equations.addPlane(plane, glimpses[plane]);
  }
  if (equations.numbers().empty())
    return;
  LooseCells loose;
  forEachSeen(cloud,
              labels,
              views,
              [&](const Eigen::Vector3f& point, std::int32_t view, std::int32_t label) {
                if (label < 0)
                  loose.add(point, view);
              });
  for (const Piece& piece : loose.pieces(model.poses))
    equations.addPiece(piece);
  const MatrixXd squares = PoseErrorSolution(equations).squaredErrors();
  if (squares.allFinite() && squares.size() > 0)
    setModes(equations.numbers(), squares, planes);
}

} // namespace pcl
