#include "rectification/descent.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace pcl::acmap::test {
namespace {

double
rosenbrock(const Eigen::VectorXd& u, Eigen::VectorXd& gradient)
{
  const double a = 1 - u[0];
  const double b = u[1] - u[0] * u[0];
  gradient[0] = -2 * a - 400 * u[0] * b;
  gradient[1] = 200 * b;
  return a * a + 100 * b * b;
}

/** A quadratic function whose axes differ by a factor of ten thousand. */
double
longBowl(const Eigen::VectorXd& u, Eigen::VectorXd& gradient)
{
  double sum = 0;
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    const double steepness =
        std::pow(10, 4 * static_cast<double>(i) / static_cast<double>(u.size() - 1));
    const double off = u[i] - static_cast<double>(i);
    gradient[i] = steepness * off;
    sum += steepness * off * off / 2;
  }
  return sum;
}

TEST(Descent, findsTheEndOfRosenbrocksValley)
{
  for (const double start : {-1.2, 0.0, 3.0}) {
    Eigen::VectorXd u = Eigen::Vector2d(start, 1);
    const std::size_t evaluations = descend(rosenbrock, u, 1e-16);
    EXPECT_LT((u - Eigen::Vector2d(1, 1)).norm(), 1e-5) << start;
    EXPECT_LT(evaluations, 200U);
  }
}

TEST(Descent, findsTheBottomOfALongBowl)
{
  Eigen::VectorXd u = Eigen::VectorXd::Constant(10, -3);
  const std::size_t evaluations = descend(longBowl, u, 1e-14);
  for (Eigen::Index i = 0; i < u.size(); ++i)
    EXPECT_NEAR(u[i], static_cast<double>(i), 1e-4);
  EXPECT_LT(evaluations, 200U);
}

TEST(Descent, theValueNeverRisesAndStepsAreShort)
{
  Eigen::VectorXd u = Eigen::Vector2d(-40, 60);
  Eigen::VectorXd last = u, gradient(2);
  double minimum = rosenbrock(u, gradient);
  std::size_t steps = 0, calls = 0;
  const Objective counted = [&](const Eigen::VectorXd& at, Eigen::VectorXd& by) {
    ++calls;
    return rosenbrock(at, by);
  };
  const std::size_t evaluations =
      descend(counted, u, 0, [&](const Eigen::VectorXd& at, double value) {
        EXPECT_LT(value, minimum);
        EXPECT_EQ(value, rosenbrock(at, gradient));
        EXPECT_LE((at - last).cwiseAbs().maxCoeff(), 3 + 1e-9);
        minimum = value;
        last = at;
        ++steps;
      });
  EXPECT_EQ(evaluations, calls);
  EXPECT_EQ(u, last);
  EXPECT_GT(steps, 10U);
  EXPECT_LE(steps, 100U);
}

TEST(Descent, stopsWhereAStepGainsLittle)
{
  Eigen::VectorXd u = Eigen::VectorXd::Constant(10, -3);
  const std::size_t few = descend(longBowl, u, 100);
  u.setConstant(-3);
  EXPECT_LT(few, descend(longBowl, u, 1e-14));
}

TEST(Descent, staysAtTheBottom)
{
  Eigen::VectorXd u = Eigen::Vector2d(1, 1);
  EXPECT_EQ(descend(rosenbrock, u, 1e-9), 1U);
  EXPECT_EQ(u, Eigen::Vector2d(1, 1));
}

TEST(Descent, endsWhenTheGradientLies)
{
  const Objective liar = [](const Eigen::VectorXd& at, Eigen::VectorXd& gradient) {
    gradient = -at;
    return at.squaredNorm();
  };
  Eigen::VectorXd u = Eigen::Vector2d(1, 2);
  EXPECT_LE(descend(liar, u, 1e-9), 30U);
  EXPECT_EQ(u, Eigen::Vector2d(1, 2));
}

TEST(Descent, goesRoundWhatHasNoValue)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Objective walled = [](const Eigen::VectorXd& at, Eigen::VectorXd& gradient) {
    gradient = 2 * at;
    if (at[0] > 0.5 && at[0] < 1)
      return infinity;
    return at.squaredNorm();
  };
  Eigen::VectorXd u = Eigen::Vector2d(2, 0);
  descend(walled, u, 1e-12);
  EXPECT_LE(u[0], 2);
  EXPECT_TRUE(u.allFinite());
  EXPECT_TRUE(u[0] <= 0.5 || u[0] >= 1);

  const Objective nowhere = [](const Eigen::VectorXd&, Eigen::VectorXd& gradient) {
    gradient.setZero();
    return infinity;
  };
  u = Eigen::Vector2d(3, 4);
  EXPECT_LE(descend(nowhere, u, 1e-9), 2U);
  EXPECT_EQ(u, Eigen::Vector2d(3, 4));
}

} // namespace
} // namespace pcl::acmap::test
