#include "landmark_solver.h"

#include "plane_frame.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {
namespace {

using Matrix46 = Eigen::Matrix<double, 4, 6>;
using Matrix43 = Eigen::Matrix<double, 4, 3>;
using Matrix63 = Eigen::Matrix<double, 6, 3>;

/** Fits a plane by regression of the heights above the current one. Tilts are small, so
 * that this is the plane of least squares after two passes.
 * \return chi^2 */
double
fitPlaneOf(const Poses& poses, Landmark& landmark)
{
  double cost = 0;
  for (int pass = 0; pass < 2; ++pass) {
    const Eigen::Vector3d origin = landmark.center + landmark.offset * landmark.normal;
    const PlaneFrame frame(landmark.normal, origin);
    Eigen::Matrix4d sums = Eigen::Matrix4d::Zero();
    for (const LandmarkView& view : landmark.views)
      sums += frame.sumsOf(view.cluster, poses[view.view]);
    const HeightPlane fit(sums);
    cost = fit.cost;
    const Eigen::Vector3d normal = frame.axes.transpose() *
                                   Eigen::Vector3d(-fit.plane[0], -fit.plane[1], 1) /
                                   std::sqrt(fit.square);
    landmark.offset =
        normal.dot(origin + fit.plane[2] * landmark.normal - landmark.center);
    landmark.normal = normal;
  }
  return cost;
}

/** What a view contributes to a landmark's equations. */
struct ViewTerms {
  std::size_t row;
  Matrix63 with_plane; ///< after elimination: times the root of the plane's covariance
};

} // namespace

std::vector<PoseSystem::Pair>
connectedRows(const std::vector<Landmark>& landmarks, std::size_t views)
{
  std::vector<std::vector<char>> connected(views);
  std::vector<PoseSystem::Pair> pairs;
  for (std::size_t view = 1; view + 1 < views; ++view)
    pairs.emplace_back(view - 1, view);
  for (const Landmark& landmark : landmarks)
    for (const LandmarkView& a : landmark.views)
      for (const LandmarkView& b : landmark.views)
        if (a.view > 0 && a.view < b.view) {
          auto& row = connected[a.view];
          row.resize(std::max(row.size(), b.view - a.view + 1));
          char& known = row[b.view - a.view];
          if (!known)
            pairs.emplace_back(a.view - 1, b.view - 1);
          known = 1;
        }
  return pairs;
}

double
fitLandmarks(const Poses& poses, std::vector<Landmark>& landmarks)
{
  double cost = 0;
  for (Landmark& landmark : landmarks)
    cost += fitPlaneOf(poses, landmark);
  return cost;
}

void
linearizeLandmarks(const Poses& poses,
                   const std::vector<Landmark>& landmarks,
                   PoseSystem& system,
                   std::vector<Vector6>& gradient)
{
  std::vector<ViewTerms> terms;
  for (const Landmark& landmark : landmarks) {
    terms.clear();
    const Eigen::Vector3d origin = landmark.center + landmark.offset * landmark.normal;
    const Eigen::Matrix3d axes = PlaneFrame(landmark.normal, origin).axes;
    Eigen::Matrix3d of_plane = Eigen::Matrix3d::Zero();
    Eigen::Vector3d plane_gradient = Eigen::Vector3d::Zero();
    for (const LandmarkView& view : landmark.views) {
      const Eigen::Isometry3d& pose = poses[view.view];
      const Eigen::Vector3d way = pose.translation() - origin;
      const Eigen::Vector3d normal = pose.linear().transpose() * landmark.normal;
      Eigen::Vector4d plane;
      plane << normal, landmark.normal.dot(way);
      Matrix43 by_plane = Matrix43::Zero();
      by_plane.topLeftCorner<3, 2>() =
          pose.linear().transpose() * axes.topRows<2>().transpose();
      by_plane.bottomLeftCorner<1, 2>() = (axes.topRows<2>() * way).transpose();
      by_plane(3, 2) = 1;
      const Matrix43 weighted = view.cluster * by_plane;
      const Eigen::Vector4d residual = view.cluster * plane;
      of_plane.noalias() += by_plane.transpose() * weighted;
      plane_gradient.noalias() += by_plane.transpose() * residual;
      if (view.view == 0)
        continue;
      Matrix46 by_pose = Matrix46::Zero();
      by_pose.topLeftCorner<3, 3>() << 0, -normal.z(), normal.y(), normal.z(), 0,
          -normal.x(), -normal.y(), normal.x(), 0;
      by_pose.bottomRightCorner<1, 3>() = normal.transpose();
      const std::size_t row = view.view - 1;
      system.add(row, row, by_pose.transpose() * view.cluster * by_pose);
      gradient[row].noalias() += by_pose.transpose() * residual;
      terms.push_back({row, by_pose.transpose() * weighted});
    }
    const Eigen::LLT<Eigen::Matrix3d> root(of_plane);
    if (root.info() != Eigen::Success)
      continue; // its views do not determine the plane
    const Eigen::Vector3d rest = root.matrixL().solve(plane_gradient);
    for (ViewTerms& term : terms)
      term.with_plane =
          root.matrixL().solve(term.with_plane.transpose()).transpose().eval();
    for (std::size_t a = 0; a < terms.size(); ++a) {
      gradient[terms[a].row].noalias() -= terms[a].with_plane * rest;
      for (std::size_t b = 0; b <= a; ++b)
        system.add(terms[a].row,
                   terms[b].row,
                   -terms[a].with_plane * terms[b].with_plane.transpose());
    }
  }
}

double
minimize(const OdometryPrior& prior,
         const RevisitLinks& links,
         std::size_t steps,
         std::vector<Landmark>& landmarks,
         Poses& poses)
{
  const std::size_t rows = poses.size() - 1;
  std::vector<PoseSystem::Pair> pairs = connectedRows(landmarks, poses.size());
  links.addPairs(pairs);
  PoseSystem system(rows, pairs);
  const Poses start = poses;
  double cost = fitLandmarks(poses, landmarks) + prior.cost(poses) + links.cost(poses);
  double damping = 0;
  for (std::size_t step = 0; step < steps; ++step) {
    system.setZero();
    std::vector<Vector6> gradient(rows, Vector6::Zero());
    prior.linearize(poses, system, gradient);
    links.linearize(poses, system, gradient);
    linearizeLandmarks(poses, landmarks, system, gradient);
    system.damp(damping);
    if (!system.factorize()) {
      damping = std::max(1e-4, 10 * damping);
      continue;
    }
    const std::vector<Vector6> motions = system.solve(gradient);
    Poses moved = poses;
    for (std::size_t row = 0; row < rows; ++row)
      moved[row + 1] = retract(poses[row + 1], -motions[row]);
    std::vector<Landmark> fitted = landmarks;
    const double new_cost =
        fitLandmarks(moved, fitted) + prior.cost(moved) + links.cost(moved);
    if (!(new_cost < cost)) {
      damping = std::max(1e-4, 10 * damping);
      continue;
    }
    const bool is_flat = new_cost > cost * (1 - 1e-9);
    poses = std::move(moved);
    landmarks = std::move(fitted);
    cost = new_cost;
    damping *= 0.1;
    if (is_flat)
      break;
  }
  double farthest = 0;
  for (std::size_t i = 0; i < poses.size(); ++i)
    farthest =
        std::max(farthest, (poses[i].translation() - start[i].translation()).norm());
  return farthest;
}

double
distanceOfView(const Landmark& landmark, const LandmarkView& view, const Poses& poses)
{
  const Eigen::Vector3d middle = view.cluster.col(3).head<3>() / view.cluster(3, 3);
  return landmark.normal.dot(poses[view.view] * middle - landmark.center) -
         landmark.offset;
}

double
thicknessOf(const std::vector<Landmark>& landmarks, const Poses& poses)
{
  double squares = 0;
  std::size_t count = 0;
  for (const Landmark& landmark : landmarks)
    for (const LandmarkView& view : landmark.views) {
      const double distance = distanceOfView(landmark, view, poses);
      squares += distance * distance;
      ++count;
    }
  return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0;
}

} // namespace pcl::acmap
