#include "boxes/box_pose.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>

namespace pcl::acmap::boxes {

namespace {

using Matrix9 = Eigen::Matrix<double, 9, 9>; // turn, then the positions of the sides
using Vector9 = Eigen::Matrix<double, 9, 1>;

/** Errors that all points of a plane share, as those of poses: planes of a map are
 * never known better. */
constexpr double shared_offset = 0.001; // metres
constexpr double shared_slope = 0.001;  // radians

Eigen::Matrix3d
covarianceOf(const PlanePatch& plane)
{
  constexpr double unknown_slope = 0.02, unknown_offset = 0.003;
  Eigen::Matrix3d covariance = plane.covariance;
  if (!covariance.allFinite() || !(covariance.diagonal().minCoeff() >= 0))
    covariance = Eigen::Vector3d(
                     unknown_slope, unknown_slope, std::max(unknown_offset, plane.rms))
                     .cwiseAbs2()
                     .asDiagonal();
  covariance.diagonal() +=
      Eigen::Vector3d(shared_slope, shared_slope, shared_offset).cwiseAbs2();
  return covariance;
}

/** Normal equations of one step. */
struct Equations {
  Matrix9 information = Matrix9::Zero();
  Vector9 gradient = Vector9::Zero();
  double misfit = 0; ///< chi squared of the planes

  /** Slopes and offset of a side relative to a plane in it. */
  void
  addPlane(const Box& box, std::size_t side, const PlanePatch& plane)
  {
    const Eigen::Vector3d outward = box.outward(side), from = plane.center - box.origin;
    const Eigen::Vector3d residual(-outward.dot(plane.axis_u),
                                   -outward.dot(plane.axis_v),
                                   box.sides[side].position - outward.dot(from));
    Eigen::Matrix<double, 3, 9> slopes = Eigen::Matrix<double, 3, 9>::Zero();
    slopes.block<1, 3>(0, 0) = -outward.cross(plane.axis_u).transpose();
    slopes.block<1, 3>(1, 0) = -outward.cross(plane.axis_v).transpose();
    slopes.block<1, 3>(2, 0) = -outward.cross(from).transpose();
    slopes(2, 3 + static_cast<Eigen::Index>(side)) = 1;
    const Eigen::Matrix3d weight = covarianceOf(plane).inverse();
    information += slopes.transpose() * weight * slopes;
    gradient += slopes.transpose() * weight * residual;
    misfit += residual.dot(weight * residual);
  }

  /** The axes are at the given turn about an axis. */
  void
  addTurn(const Eigen::Vector3d& axis, double deviation)
  {
    information.topLeftCorner<3, 3>() +=
        axis * axis.transpose() / (deviation * deviation);
  }

  void
  addPosition(std::size_t side, double difference, double deviation)
  {
    const auto row = 3 + static_cast<Eigen::Index>(side);
    const double weight = 1 / (deviation * deviation);
    information(row, row) += weight;
    gradient[row] += weight * difference;
  }
};

/** From turn and positions of the sides to turn, shift of the center and size. */
Matrix9
toCenterAndSize(const Eigen::Matrix3d& axes)
{
  Matrix9 change = Matrix9::Zero();
  change.topLeftCorner<3, 3>() = axes.transpose();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    change(3 + axis, 3 + 2 * axis) = 0.5;
    change(3 + axis, 4 + 2 * axis) = -0.5;
    change(6 + axis, 3 + 2 * axis) = 1;
    change(6 + axis, 4 + 2 * axis) = 1;
  }
  return change;
}

void
moveOriginToCenter(Box& box)
{
  const Eigen::Vector3d half = box.size() / 2;
  box.origin = box.center();
  for (std::size_t side = 0; side < box.sides.size(); ++side)
    box.sides[side].position = half[Box::axisOf(side)];
}

} // namespace

void
fitPose(const std::vector<PlanePatch>& planes, Box& box)
{
  constexpr int steps = 5;       // Gauss-Newton from axes that are right within degrees
  std::array<double, 6> given{}; // coordinates along the outward directions
  for (std::size_t side = 0; side < 6; ++side)
    given[side] = box.sides[side].position;
  for (int step = 0; step <= steps; ++step) {
    Equations equations;
    for (std::size_t side = 0; side < box.sides.size(); ++side)
      if (box.sides[side].kind == BoxFaceKind::Seen)
        equations.addPlane(
            box, side, planes[static_cast<std::size_t>(box.sides[side].plane)]);
      else
        equations.addPosition(
            side, box.sides[side].position - given[side], box.sides[side].deviation);
    if (box.turn_deviation > 0)
      equations.addTurn(box.axes.col(2), box.turn_deviation);
    const Eigen::LDLT<Matrix9> solver(equations.information);
    if (step == steps) { // only to linearize at the result
      const Matrix9 change = toCenterAndSize(box.axes);
      box.covariance = change * solver.solve(change.transpose());
      box.covariance = (box.covariance + box.covariance.transpose()).eval() / 2;
      box.misfit = equations.misfit;
      return;
    }
    const Vector9 shift = -solver.solve(equations.gradient);
    const Eigen::Vector3d turn = shift.head<3>();
    if (turn.norm() > 0)
      box.axes = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * box.axes;
    for (std::size_t side = 0; side < 6; ++side)
      box.sides[side].position += shift[3 + static_cast<Eigen::Index>(side)];
    const Eigen::Vector3d before = box.origin;
    moveOriginToCenter(box);
    for (std::size_t side = 0; side < 6; ++side)
      given[side] -= box.outward(side).dot(box.origin - before);
  }
}

} // namespace pcl::acmap::boxes
