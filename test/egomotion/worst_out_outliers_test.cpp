#include "stereo_matches.h"

#include <pcl/egomotion/impl/motion_fit_kernel.h>
#include <pcl/egomotion/impl/worst_out_kernel.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

/** Errors of a motion computed from some matches. */
struct MotionErrors {
  double squared_metres = 0, squared_radians = 0;

  void
  add(const StereoMatches& matches,
      const std::vector<std::int32_t>& chosen,
      const StereoMatchSettings& scene)
  {
    const Eigen::Isometry3d found = fitMotion(placesAt(matches.source, chosen),
                                              placesAt(matches.target, chosen),
                                              {},
                                              MotionModel::Planar,
                                              MotionSolver::ConjugateGradient)
                                        .T_target_source;
    const Eigen::Isometry3d error = scene.T_target_source.inverse() * found;
    squared_metres += error.translation().squaredNorm();
    squared_radians += std::pow(Eigen::AngleAxisd(error.linear()).angle(), 2);
  }
};

class WorstOutOutliers : public testing::TestWithParam<std::size_t> {};

TEST_P(WorstOutOutliers, hardlyMoveTheAction)
{
  MotionErrors of_right, of_kept, of_all;
  std::size_t kept = 0, right = 0, kept_right = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    StereoMatchSettings scene;
    scene.right = 150;
    scene.wrong = GetParam();
    scene.seed = seed;
    Random random(seed);
    scene.T_target_source = planarMotion(random.uniform(-0.3, 0.3),
                                         random.uniform(-0.3, 0.3),
                                         random.uniform(-0.25, 0.25));
    const StereoMatches matches = stereoMatches(scene);
    const WorstOutOutcome outcome = leaveWorstOut(matches.source, matches.target, {});
    std::vector<std::int32_t> all(outcome.kept);
    all.insert(all.end(), outcome.removed.begin(), outcome.removed.end());
    of_right.add(matches, rightOnes(matches), scene);
    of_kept.add(matches, outcome.kept, scene);
    of_all.add(matches, all, scene);
    kept += outcome.kept.size();
    right += scene.right;
    for (const std::int32_t match : outcome.kept)
      kept_right += matches.is_right[static_cast<std::size_t>(match)] != 0;
  }
  const auto timesNoise = [](double squared, double of_noise) {
    return std::sqrt(squared / of_noise);
  };
  const double metres = timesNoise(of_kept.squared_metres, of_right.squared_metres);
  const double radians = timesNoise(of_kept.squared_radians, of_right.squared_radians);
  EXPECT_LT(metres, GetParam() ? 2 : 1.05);
  EXPECT_LT(radians, GetParam() ? 3 : 1.05);
  EXPECT_GT(static_cast<double>(kept_right), 0.99 * static_cast<double>(right));
  EXPECT_GT(static_cast<double>(kept_right), 0.96 * static_cast<double>(kept));
  // effect of the wrong matches without rejection
  if (GetParam()) {
    EXPECT_GT(timesNoise(of_all.squared_metres, of_right.squared_metres), 3.5);
  }
}

INSTANTIATE_TEST_SUITE_P(Wrong, WorstOutOutliers, testing::Values(0, 17, 50, 100, 150));

} // namespace
} // namespace pcl::acmap::test
