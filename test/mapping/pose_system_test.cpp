#include "plane_adjustment/pose_system.h"

#include <pcl/core/random.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

/** A random positive definite system of a path with a few revisits, sparse and dense. */
struct RandomSystem {
  explicit RandomSystem(std::size_t poses)
  : pairs(pairsOf(poses))
  , sparse(poses, pairs)
  , dense(Eigen::MatrixXd::Zero(size(poses), size(poses)))
  {
    Random random(7);
    for (const auto& [a, b] : pairs) {
      Matrix6 block;
      for (double& value : block.reshaped())
        value = random.normal();
      sparse.add(a, b, block);
      dense.block<6, 6>(size(a), size(b)) += block;
      dense.block<6, 6>(size(b), size(a)) += block.transpose();
    }
    const Matrix6 diagonal = 40 * Matrix6::Identity();
    for (std::size_t i = 0; i < poses; ++i) {
      sparse.add(i, i, diagonal);
      dense.block<6, 6>(size(i), size(i)) += diagonal;
    }
  }

  static Eigen::Index
  size(std::size_t poses)
  {
    return 6 * static_cast<Eigen::Index>(poses);
  }

  static std::vector<PoseSystem::Pair>
  pairsOf(std::size_t poses)
  {
    std::vector<PoseSystem::Pair> pairs;
    for (std::size_t i = 0; i + 1 < poses; ++i)
      pairs.emplace_back(i, i + 1);
    for (std::size_t i = 0; i + 3 < poses; i += 2)
      pairs.emplace_back(i + 3, i);
    pairs.emplace_back(0, poses - 1);
    return pairs;
  }

  std::vector<PoseSystem::Pair> pairs;
  PoseSystem sparse;
  Eigen::MatrixXd dense;
};

TEST(PoseSystem, solvesAsADenseMatrix)
{
  constexpr std::size_t poses = 23;
  RandomSystem system(poses);
  Random random(3);
  Eigen::VectorXd right(RandomSystem::size(poses));
  for (double& value : right)
    value = random.normal();
  std::vector<Vector6> blocks;
  for (std::size_t i = 0; i < poses; ++i)
    blocks.emplace_back(right.segment<6>(RandomSystem::size(i)));
  ASSERT_TRUE(system.sparse.factorize());
  const std::vector<Vector6> found = system.sparse.solve(blocks);
  const Eigen::VectorXd wanted = system.dense.ldlt().solve(right);
  for (std::size_t i = 0; i < poses; ++i)
    EXPECT_LT((found[i] - wanted.segment<6>(RandomSystem::size(i))).norm(), 1e-10);
}

TEST(PoseSystem, selectedInverseIsThatOfADenseMatrix)
{
  constexpr std::size_t poses = 23;
  RandomSystem system(poses);
  ASSERT_TRUE(system.sparse.factorize());
  system.sparse.invert();
  const Eigen::MatrixXd wanted = system.dense.inverse();
  const auto check = [&](std::size_t a, std::size_t b) {
    const Matrix6 block =
        wanted.block<6, 6>(RandomSystem::size(a), RandomSystem::size(b));
    EXPECT_LT((system.sparse.inverse(a, b) - block).norm(), 1e-10);
    EXPECT_LT((system.sparse.inverse(b, a) - block.transpose()).norm(), 1e-10);
  };
  for (std::size_t i = 0; i < poses; ++i)
    check(i, i);
  for (const auto& [a, b] : system.pairs)
    check(a, b);
}

TEST(PoseSystem, fillOfAPathIsLinear)
{
  std::vector<PoseSystem::Pair> pairs;
  constexpr std::size_t poses = 1000, reach = 10;
  for (std::size_t i = 0; i < poses; ++i)
    for (std::size_t k = 1; k <= reach && i + k < poses; ++k)
      pairs.emplace_back(i, i + k);
  EXPECT_LT(PoseSystem(poses, pairs).fill(), 2 * poses * reach);
}

TEST(PoseSystem, refusesAMatrixThatIsNotPositiveDefinite)
{
  PoseSystem system(2, {{0, 1}});
  system.add(0, 0, Matrix6::Identity());
  system.add(1, 1, Matrix6::Identity());
  system.add(0, 1, 2 * Matrix6::Identity());
  EXPECT_FALSE(system.factorize());
}

} // namespace
} // namespace pcl::acmap::test
