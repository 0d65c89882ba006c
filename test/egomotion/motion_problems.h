#pragma once

#include "stereo_matches.h"

#include <pcl/egomotion/impl/motion_fit_kernel.h>

#include <vector>

namespace pcl::acmap::test {

/** \brief Points, and their positions after a motion. */
struct MotionProblem {
  std::vector<Eigen::Vector3d> source, target;
  std::vector<double> weights;
  Eigen::Isometry3d T_target_source;
};

/** \brief A random motion of 3 to 40 points, whose spread in each axis is centimetres
 * to metres. */
inline MotionProblem
randomProblem(std::uint64_t seed, MotionModel model, double noise, double far = 0)
{
  Random random(seed);
  MotionProblem problem;
  problem.T_target_source = model == MotionModel::Rigid
                                ? anyMotion(random)
                                : planarMotion(random.uniform(-1, 1),
                                               random.uniform(-1, 1),
                                               random.uniform(-3.1, 3.1));
  Eigen::Vector3d size;
  for (double& length : size)
    length = std::pow(10, random.uniform(-1.5, 1));
  const auto anywhere = [&random] {
    const double x = random.normal(), y = random.normal();
    return Eigen::Vector3d(x, y, random.normal());
  };
  const int points = 3 + static_cast<int>(random.bits() % 38);
  for (int i = 0; i < points; ++i) {
    const Eigen::Vector3d place =
        anywhere().cwiseProduct(size) + Eigen::Vector3d(far, far, -far);
    problem.source.push_back(place);
    problem.target.push_back(problem.T_target_source * place + noise * anywhere());
    problem.weights.push_back(std::pow(10, random.uniform(-2, 2)));
  }
  return problem;
}

inline MotionFit
fit(const MotionProblem& problem, MotionModel model, MotionSolver solver)
{
  return fitMotion(problem.source, problem.target, problem.weights, model, solver);
}

/** \brief Maximum difference of two motions: of the transformed points and of the
 * rotations. */
inline double
difference(const Eigen::Isometry3d& a,
           const Eigen::Isometry3d& b,
           const std::vector<Eigen::Vector3d>& points)
{
  double maximum = (a.linear() - b.linear()).cwiseAbs().maxCoeff();
  for (const Eigen::Vector3d& point : points)
    maximum = std::max(maximum, (a * point - b * point).norm());
  return maximum;
}

} // namespace pcl::acmap::test
