#include "motion_problems.h"

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

class FittedMotion
: public testing::TestWithParam<std::tuple<MotionModel, MotionSolver>> {
protected:
  const MotionModel model_ = std::get<0>(GetParam());
  const MotionSolver solver_ = std::get<1>(GetParam());
};

constexpr MotionModel models[] = {MotionModel::Planar, MotionModel::Rigid};

/** Differs by less than 1e-6 from the closed form, also far from the origin and with
 * tiny weights. */
TEST(MotionFitOracle, conjugateGradientFindsWhatTheClosedFormDoes)
{
  for (const MotionModel model : models)
    for (const double far : {0.0, 1e4})
      for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        MotionProblem problem =
            randomProblem(seed, model, seed % 3 == 0 ? 0.0 : 0.05, far);
        for (double& weight : problem.weights)
          weight *= seed % 2 ? 1e-200 : 1.0;
        const MotionFit closed = fit(problem, model, MotionSolver::ClosedForm);
        const MotionFit descended =
            fit(problem, model, MotionSolver::ConjugateGradient);
        EXPECT_TRUE(descended.has_converged) << seed;
        EXPECT_LT(difference(descended.T_target_source,
                             closed.T_target_source,
                             problem.source),
                  1e-6)
            << "seed " << seed << ", far " << far;
      }
}

/** The start is far from the solution and the unknowns are badly scaled: steepest
 * descent fails here. */
TEST(MotionFitOracle, soItDoesBetweenUnrelatedPoints)
{
  for (const MotionModel model : models)
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      MotionProblem problem = randomProblem(seed, model, 0);
      Random random(seed);
      for (auto* places : {&problem.source, &problem.target})
        for (Eigen::Vector3d& place : *places)
          for (double& coordinate : place)
            coordinate = random.normal();
      problem.weights.clear();
      const MotionFit closed = fit(problem, model, MotionSolver::ClosedForm);
      const MotionFit descended = fit(problem, model, MotionSolver::ConjugateGradient);
      EXPECT_TRUE(descended.has_converged) << seed;
      EXPECT_LT(descended.iterations, 40u) << seed;
      EXPECT_LT(
          difference(descended.T_target_source, closed.T_target_source, problem.source),
          1e-6)
          << seed;
    }
}

TEST_P(FittedMotion, aMotionWithoutNoiseIsRecovered)
{
  for (const double far : {0.0, 1e4})
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      const MotionProblem problem = randomProblem(seed, model_, 0, far);
      const MotionFit found = fit(problem, model_, solver_);
      EXPECT_LT(
          difference(found.T_target_source, problem.T_target_source, problem.source),
          far > 0 ? 1e-6 : 1e-8)
          << "seed " << seed << ", far " << far;
    }
}

/** The energy, computed here, has its minimum at the fit. */
TEST_P(FittedMotion, noStepLeadsFurtherDown)
{
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const MotionProblem problem = randomProblem(seed, model_, 0.1);
    const MotionFit found = fit(problem, model_, solver_);
    const auto energy = [&problem](const Eigen::Isometry3d& motion) {
      double sum = 0;
      for (std::size_t i = 0; i < problem.source.size(); ++i)
        sum += problem.weights[i] *
               (problem.target[i] - motion * problem.source[i]).squaredNorm();
      return sum;
    };
    const double minimum = energy(found.T_target_source);
    EXPECT_NEAR(found.energy, minimum, 1e-12 * minimum);
    for (int direction = 0; direction < 6; ++direction) {
      // x, z and the rotation about y are 0, 2 and 4
      if (model_ == MotionModel::Planar && direction % 2 != 0)
        continue;
      for (const double step : {-1e-3, 1e-3}) {
        Eigen::Isometry3d moved = found.T_target_source;
        if (direction < 3)
          moved.pretranslate(step * Eigen::Vector3d::Unit(direction));
        else
          moved.prerotate(
              Eigen::AngleAxisd(step, Eigen::Vector3d::Unit(direction - 3)));
        EXPECT_GT(energy(moved), minimum) << "seed " << seed << ", " << direction;
      }
    }
  }
}

TEST_P(FittedMotion, swappingInvertsTheMotion)
{
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    MotionProblem problem = randomProblem(seed, model_, 0.05);
    const Eigen::Isometry3d there = fit(problem, model_, solver_).T_target_source;
    std::swap(problem.source, problem.target);
    const Eigen::Isometry3d back = fit(problem, model_, solver_).T_target_source;
    EXPECT_LT(difference(there.inverse(), back, problem.source), 1e-7) << seed;
  }
}

TEST_P(FittedMotion, aWeightCountsAsRepetition)
{
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    MotionProblem weighted = randomProblem(seed, model_, 0.05), repeated;
    for (std::size_t i = 0; i < weighted.source.size(); ++i) {
      weighted.weights[i] = static_cast<double>(i % 4);
      for (std::size_t times = 0; times < i % 4; ++times) {
        repeated.source.push_back(weighted.source[i]);
        repeated.target.push_back(weighted.target[i]);
      }
    }
    EXPECT_LT(difference(fit(weighted, model_, solver_).T_target_source,
                         fit(repeated, model_, solver_).T_target_source,
                         weighted.source),
              1e-8)
        << seed;
  }
}

/** A planar motion does not change heights. */
TEST(MotionFitOracle, planarMotionsAreOnTheFloor)
{
  for (const MotionSolver solver :
       {MotionSolver::ConjugateGradient, MotionSolver::ClosedForm})
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const MotionProblem problem = randomProblem(seed, MotionModel::Rigid, 0.1);
      const Eigen::Isometry3d motion =
          fit(problem, MotionModel::Planar, solver).T_target_source;
      EXPECT_EQ(motion.translation().y(), 0);
      EXPECT_EQ(motion.linear().row(1), Eigen::RowVector3d::UnitY());
      EXPECT_EQ(motion.linear().col(1), Eigen::Vector3d::UnitY());
    }
}

INSTANTIATE_TEST_SUITE_P(
    ModelsAndSolvers,
    FittedMotion,
    testing::Combine(testing::ValuesIn(models),
                     testing::Values(MotionSolver::ConjugateGradient,
                                     MotionSolver::ClosedForm)));

} // namespace
} // namespace pcl::acmap::test
