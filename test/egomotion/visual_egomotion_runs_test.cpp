#include "room_views.h"

#include <pcl/core/exceptions.h>
#include <pcl/egomotion/visual_egomotion.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {

namespace {

using Egomotion = VisualEgomotion<PointXYZRGBSigma>;
using Cloud = PointCloud<PointXYZRGBSigma>;

/** \brief Complete result of a run. */
struct Outcome {
  Eigen::Matrix4d motion = Eigen::Matrix4d::Zero();
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  std::vector<int> matches, inliers;
  std::size_t keypoints = 0;
  bool is_refined = false;

  bool
  operator==(const Outcome& other) const
  {
    return motion == other.motion && covariance == other.covariance &&
           matches == other.matches && inliers == other.inliers &&
           keypoints == other.keypoints && is_refined == other.is_refined;
  }
};

std::vector<int>
numbersOf(const Correspondences& matches)
{
  std::vector<int> numbers;
  for (const Correspondence& match : matches) {
    numbers.push_back(match.index_query);
    numbers.push_back(match.index_match);
  }
  return numbers;
}

Outcome
runOn(Egomotion& egomotion,
      const Cloud::ConstPtr& source,
      const Cloud::ConstPtr& target)
{
  egomotion.setInputSource(source);
  egomotion.setInputTarget(target);
  Outcome outcome;
  if (const auto estimate = egomotion.compute()) {
    outcome.motion = estimate->T_target_source.matrix();
    outcome.covariance = estimate->covariance;
  }
  outcome.matches = numbersOf(egomotion.getMatches());
  outcome.inliers = numbersOf(egomotion.getInliers());
  outcome.keypoints = egomotion.getReport().source_keypoints;
  outcome.is_refined = egomotion.getReport().is_refined;
  return outcome;
}

/** \brief Views along a path. */
std::vector<Cloud::ConstPtr>
walk(std::size_t steps)
{
  std::vector<Cloud::ConstPtr> views;
  RoomCamera noisy;
  noisy.noise = 1;
  Eigen::Isometry3d pose = poseOf({-0.3, 0, -0.5}, 0.1);
  for (std::size_t i = 0; i < steps; ++i) {
    noisy.seed = i + 1;
    views.push_back(viewOf(Room(), pose, noisy));
    pose = pose * poseOf({0.05, 0, 0.1}, 0.03);
  }
  return views;
}

} // namespace

TEST(VisualEgomotionRuns, sequencesGiveWhatPairsGive)
{
  const std::vector<Cloud::ConstPtr> views = walk(4);
  Egomotion sequence;
  for (std::size_t i = 1; i < views.size(); ++i) {
    Egomotion fresh;
    EXPECT_EQ(runOn(sequence, views[i], views[i - 1]),
              runOn(fresh, views[i], views[i - 1]));
  }
}

// Cached clouds must not be changed; this test does so to show that they are cached:
// without the cache, b would have no features.
TEST(VisualEgomotionRuns, viewsAreLookedAtOnce)
{
  const Cloud::ConstPtr a = walk(3)[0], c = walk(3)[2];
  const Cloud::Ptr b(new Cloud(*walk(3)[1]));
  Egomotion egomotion;
  EXPECT_FALSE(runOn(egomotion, b, a).motion.isZero());
  for (PointXYZRGBSigma& point : *b)
    point.r = point.g = point.b = 0;
  EXPECT_FALSE(runOn(egomotion, c, b).motion.isZero());
  EXPECT_FALSE(runOn(egomotion, a, c).motion.isZero()); // b is removed from the cache
  EXPECT_TRUE(runOn(egomotion, c, b).motion.isZero());
  EXPECT_EQ(egomotion.getReport().outcome, EgomotionOutcome::BlankView);
}

TEST(VisualEgomotionRuns, settersOfWhatIsLookedAtDropTheViews)
{
  const std::vector<Cloud::ConstPtr> views = walk(2);
  const auto withKeypoints = [&](Egomotion& egomotion) {
    egomotion.setMaximumKeypoints(150);
    return runOn(egomotion, views[1], views[0]);
  };
  const auto withoutRefinement = [&](Egomotion& egomotion) {
    egomotion.setRefinement(false);
    return runOn(egomotion, views[1], views[0]);
  };
  Egomotion used, fresh, other;
  const Outcome first = runOn(used, views[1], views[0]);
  EXPECT_EQ(withKeypoints(used), withKeypoints(fresh));
  EXPECT_FALSE(withKeypoints(used) == first);
  EXPECT_EQ(withoutRefinement(used), withoutRefinement(fresh));
  withoutRefinement(other);
  other.setRefinement(true);
  EXPECT_EQ(runOn(other, views[1], views[0]), first);
}

TEST(VisualEgomotionRuns, threadsDoNotChangeAByte)
{
  const std::vector<Cloud::ConstPtr> views = walk(2);
  for (const MotionModel model : {MotionModel::Planar, MotionModel::Rigid}) {
    std::vector<Outcome> outcomes;
    for (const unsigned threads : {1U, 2U, 8U, 1U}) {
      Egomotion egomotion;
      egomotion.setMotionModel(model);
      egomotion.setNumberOfThreads(threads);
      outcomes.push_back(runOn(egomotion, views[1], views[0]));
      EXPECT_EQ(outcomes.back(), outcomes.front()) << threads;
    }
    EXPECT_TRUE(outcomes.front().is_refined);
  }
}

TEST(VisualEgomotionRuns, cancelledRunsChangeNothing)
{
  const std::vector<Cloud::ConstPtr> views = walk(3);
  Egomotion egomotion;
  const Outcome first = runOn(egomotion, views[1], views[0]);
  std::vector<double> told;
  egomotion.setProgressCallback([&](double fraction, const std::string& step) {
    EXPECT_FALSE(step.empty());
    told.push_back(fraction);
    return true;
  });
  Outcome wanted = runOn(egomotion, views[2], views[1]);
  ASSERT_GT(told.size(), 2u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  const std::size_t calls = told.size();
  for (std::size_t last = 0; last < calls; ++last) {
    Egomotion stopped;
    EXPECT_EQ(runOn(stopped, views[1], views[0]), first);
    std::size_t call = 0;
    stopped.setProgressCallback(
        [&](double, const std::string&) { return call++ != last; });
    EXPECT_THROW(runOn(stopped, views[2], views[1]), CancelledException);
    EXPECT_EQ(numbersOf(stopped.getMatches()), first.matches);
    EXPECT_EQ(numbersOf(stopped.getInliers()), first.inliers);
    EXPECT_EQ(stopped.getReport().source_keypoints, first.keypoints);
    stopped.setProgressCallback({});
    EXPECT_EQ(runOn(stopped, views[2], views[1]), wanted);
  }
}

TEST(VisualEgomotionRuns, failuresLeaveNoMatchesOfEarlierRuns)
{
  const std::vector<Cloud::ConstPtr> views = walk(2);
  const Cloud::Ptr black(new Cloud(*views[0]));
  for (PointXYZRGBSigma& point : *black)
    point.r = point.g = point.b = 0;
  Egomotion egomotion;
  EXPECT_FALSE(runOn(egomotion, views[1], views[0]).matches.empty());
  EXPECT_TRUE(runOn(egomotion, black, views[0]).matches.empty());
  EXPECT_TRUE(egomotion.getInliers().empty());
  EXPECT_EQ(egomotion.getReport().matches, 0u);
  EXPECT_FALSE(runOn(egomotion, views[1], views[0]).matches.empty());
  EXPECT_TRUE(egomotion.getReport().reason.empty());
}

TEST(VisualEgomotionRuns, countsAreOfTheMatches)
{
  const std::vector<Cloud::ConstPtr> views = walk(2);
  Egomotion egomotion;
  runOn(egomotion, views[1], views[0]);
  const EgomotionReport& report = egomotion.getReport();
  EXPECT_EQ(report.matches, egomotion.getMatches().size());
  EXPECT_EQ(report.inliers, egomotion.getInliers().size());
  EXPECT_LE(report.inliers, report.consistent);
  EXPECT_LE(report.consistent, report.matches);
  EXPECT_NEAR(report.feature_chi, 1, 0.5);
  for (const Correspondence& match : egomotion.getMatches())
    EXPECT_NEAR(match.distance,
                ((*views[1])[match.index_query].getVector3fMap() -
                 (*views[0])[match.index_match].getVector3fMap())
                    .squaredNorm(),
                1e-6);
}

TEST(VisualEgomotionRuns, parametersKeepTheirRanges)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Egomotion egomotion;
  for (const double metres : {0.0, -1.0, 1e7, nan})
    EXPECT_THROW(egomotion.setMaximumTranslation(metres), BadArgumentException);
  for (const double radians : {-0.1, 3.2, nan})
    EXPECT_THROW(egomotion.setMaximumRotation(radians), BadArgumentException);
  for (const std::size_t keypoints : {0, 9, 100001})
    EXPECT_THROW(egomotion.setMaximumKeypoints(keypoints), BadArgumentException);
  EXPECT_EQ(egomotion.getMaximumTranslation(), 1);
  EXPECT_NEAR(egomotion.getMaximumRotation(), 0.5236, 1e-4);
  EXPECT_EQ(egomotion.getMaximumKeypoints(), 1000u);
  EXPECT_EQ(egomotion.getMotionModel(), MotionModel::Planar);
  EXPECT_EQ(egomotion.getSolver(), MotionSolver::ConjugateGradient);
  EXPECT_TRUE(egomotion.getRefinement());
}

} // namespace pcl::acmap::test
