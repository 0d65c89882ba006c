#include "painted_views.h"

#include <pcl/core/point_types.h>
#include <pcl/egomotion/correspondence_estimation_log_polar.h>
#include <pcl/egomotion/gradient_maximum_keypoint.h>
#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

using Matcher = registration::CorrespondenceEstimationLogPolar<PointXYZRGB>;
using Cloud = PointCloud<PointXYZRGB>;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

std::vector<std::pair<index_t, index_t>>
pairsOf(const Correspondences& matches)
{
  std::vector<std::pair<index_t, index_t>> pairs;
  for (const Correspondence& match : matches)
    pairs.emplace_back(match.index_query, match.index_match);
  return pairs;
}

class LogPolarClass : public testing::Test {
protected:
  Correspondences
  matchesOf(const Cloud::ConstPtr& now,
            double distance = std::numeric_limits<double>::max())
  {
    Correspondences matches;
    matcher_.setInputSource(now);
    matcher_.setInputTarget(before_);
    matcher_.determineCorrespondences(matches, distance);
    return matches;
  }

  static IndicesPtr
  keypointsIn(const Cloud::ConstPtr& cloud)
  {
    GradientMaximumKeypoint<PointXYZRGB> detector;
    Cloud keypoints;
    detector.setInputCloud(cloud);
    detector.compute(keypoints);
    return IndicesPtr(new Indices(detector.getKeypointsIndices()->indices));
  }

  const Wallpaper paper_{7};
  const ViewChange change_{0.05, 1.05, {4, -3}};
  const Cloud::Ptr before_ = wallOf(paint(paper_));
  const Cloud::Ptr now_ = wallOf(paint(paper_, change_));
  Matcher matcher_;
};

TEST_F(LogPolarClass, matchesAreWhatItsWordsSay)
{
  const Correspondences matches = matchesOf(now_);
  ASSERT_GT(matches.size(), 80u);
  ASSERT_EQ(matcher_.getScores().size(), matches.size());
  std::size_t right = 0;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const auto source = static_cast<std::size_t>(matches[i].index_query);
    const auto target = static_cast<std::size_t>(matches[i].index_match);
    const Eigen::Vector3f way =
        (*now_)[source].getVector3fMap() - (*before_)[target].getVector3fMap();
    EXPECT_FLOAT_EQ(matches[i].distance, way.squaredNorm());
    EXPECT_GE(matcher_.getScores()[i], 0.8F);
    EXPECT_LE(matcher_.getScores()[i], 1);
    const Eigen::Vector2d wanted(matches[i].index_query % 240,
                                 matches[i].index_query / 240);
    const Eigen::Vector2d from(matches[i].index_match % 240,
                               matches[i].index_match / 240);
    right += (change_(from) - wanted).norm() < 2.5;
  }
  EXPECT_GE(20 * right, 19 * matches.size());
  const registration::LogPolarReport& report = matcher_.getReport();
  EXPECT_EQ(report.matches, matches.size());
  EXPECT_EQ(report.matches + report.weak + report.ambiguous + report.one_sided,
            report.source_patches);
  EXPECT_TRUE(report.remarks.empty());
  Correspondences reciprocal;
  matcher_.determineReciprocalCorrespondences(reciprocal);
  EXPECT_EQ(pairsOf(reciprocal), pairsOf(matches));
}

TEST_F(LogPolarClass, withoutIndicesItFindsTheKeypointsItself)
{
  const auto wanted = pairsOf(matchesOf(now_));
  matcher_.setIndicesSource(keypointsIn(now_));
  matcher_.setIndicesTarget(keypointsIn(before_));
  EXPECT_EQ(pairsOf(matchesOf(now_)), wanted);
}

TEST_F(LogPolarClass, whereTheCloudsWereMovedToChangesNothing)
{
  const auto wanted = pairsOf(matchesOf(now_));
  Cloud::Ptr moved(new Cloud(*now_));
  for (PointXYZRGB& point : *moved)
    point.getVector3fMap() += Eigen::Vector3f(3, -2, 10);
  EXPECT_EQ(pairsOf(matchesOf(moved)), wanted);
  EXPECT_TRUE(matchesOf(moved, 5).empty());
}

TEST_F(LogPolarClass, distancesAreKept)
{
  matcher_.setMaximumImageDistance(15);
  const Correspondences matches = matchesOf(now_, 0.04);
  ASSERT_GT(matches.size(), 20u);
  for (const Correspondence& match : matches) {
    EXPECT_LE(match.distance, 0.04 * 0.04 + 1e-9);
    EXPECT_LE(std::hypot(match.index_query % 240 - match.index_match % 240,
                         match.index_query / 240 - match.index_match / 240),
              15);
  }
  matcher_.setMaximumImageDistance(std::numeric_limits<float>::infinity());
  EXPECT_GT(matchesOf(now_).size(), matches.size());
}

TEST_F(LogPolarClass, keypointsWithoutPlaceAreNone)
{
  const IndicesPtr keypoints = keypointsIn(now_);
  matcher_.setIndicesSource(keypoints);
  for (std::size_t i = 0; i < keypoints->size(); i += 2)
    (*now_)[static_cast<std::size_t>((*keypoints)[i])].y = nan;
  const Correspondences matches = matchesOf(now_);
  EXPECT_GT(matches.size(), 40u);
  EXPECT_EQ(matcher_.getReport().source_keypoints, keypoints->size() / 2);
  for (const Correspondence& match : matches)
    EXPECT_TRUE(std::isfinite(match.distance));
}

TEST_F(LogPolarClass, doubledIndicesGiveNoMatchTwice)
{
  const auto wanted = pairsOf(matchesOf(now_));
  const IndicesPtr keypoints = keypointsIn(now_);
  keypoints->insert(keypoints->end(), keypoints->begin(), keypoints->begin() + 100);
  matcher_.setIndicesSource(keypoints);
  EXPECT_EQ(pairsOf(matchesOf(now_)), wanted);
}

TEST_F(LogPolarClass, aCopyGoesOnWithTheSameSettings)
{
  matcher_.setMaximumShifts(2, 3);
  const auto wanted = pairsOf(matchesOf(now_));
  const auto copy = matcher_.clone();
  matcher_.setMaximumShifts(0, 0);
  Correspondences matches;
  copy->determineCorrespondences(matches);
  EXPECT_EQ(pairsOf(matches), wanted);
}

TEST_F(LogPolarClass, cloudsWithNothingToSeeGiveNothingAndSayWhy)
{
  Cloud::Ptr black(new Cloud(60, 50));
  Cloud::Ptr empty(new Cloud);
  Cloud::Ptr nowhere(new Cloud(*now_));
  for (PointXYZRGB& point : *nowhere)
    point.x = point.y = point.z = nan;
  Cloud::Ptr small(new Cloud(30, 30));
  for (std::size_t i = 0; i < small->size(); ++i)
    (*small)[i].g = static_cast<std::uint8_t>(i * i % 251);
  for (const auto& cloud : {black, empty, nowhere, small}) {
    EXPECT_TRUE(matchesOf(cloud).empty());
    EXPECT_EQ(matcher_.getReport().remarks.size(), 1u);
    EXPECT_TRUE(matcher_.getScores().empty());
    EXPECT_EQ(matcher_.getReport().weak, 0u);
  }
  EXPECT_NE(matcher_.getReport().remarks[0].find("border"), std::string::npos);
  const Cloud::Ptr other = wallOf(paint(Wallpaper(8)));
  matcher_.setMinimumScore(0.99F);
  EXPECT_TRUE(matchesOf(other).empty());
  EXPECT_NE(matcher_.getReport().remarks[0].find("strong"), std::string::npos);
}

TEST_F(LogPolarClass, withNothingBeforeAllOfNowIsWeak)
{
  Correspondences matches(3);
  matcher_.setInputSource(now_);
  matcher_.setInputTarget(Cloud::Ptr(new Cloud(60, 50)));
  matcher_.determineCorrespondences(matches);
  EXPECT_TRUE(matches.empty());
  EXPECT_GT(matcher_.getReport().source_patches, 80u);
  EXPECT_EQ(matcher_.getReport().weak, matcher_.getReport().source_patches);
  EXPECT_EQ(matcher_.getReport().target_patches, 0u);
  EXPECT_EQ(matcher_.getReport().remarks.size(), 1u);
}

TEST_F(LogPolarClass, nothingIsAsDistinctAsAmbiguityNought)
{
  matcher_.setMaximumAmbiguity(0);
  EXPECT_TRUE(matchesOf(before_).empty());
}

TEST_F(LogPolarClass, inputThatCannotBeIsRefusedAndOutputUntouched)
{
  Correspondences matches(3);
  const auto refuse = [&](const Cloud::ConstPtr& now) {
    matcher_.setInputSource(now);
    matcher_.determineCorrespondences(matches);
  };
  EXPECT_THROW(matcher_.determineCorrespondences(matches), InitFailedException);
  matcher_.setInputTarget(before_);
  EXPECT_THROW(matcher_.determineCorrespondences(matches), InitFailedException);
  EXPECT_THROW(refuse(Cloud::Ptr(new Cloud(1, 1))), UnorganizedPointCloudException);
  EXPECT_THROW(refuse(Cloud::Ptr(new Cloud(500, 1))), UnorganizedPointCloudException);
  const Cloud::Ptr torn(new Cloud(640, 480)); // its header announces more pixels
  torn->points.resize(1000);
  EXPECT_THROW(refuse(torn), InitFailedException);
  matcher_.setInputTarget(torn);
  EXPECT_THROW(refuse(now_), InitFailedException);
  torn->points.clear();
  EXPECT_THROW(refuse(now_), InitFailedException);
  matcher_.setInputTarget(before_);
  EXPECT_THROW(refuse(torn), InitFailedException);
  for (const double distance : {0.0, -1.0, std::nan("")}) {
    matcher_.setInputSource(now_);
    EXPECT_THROW(matcher_.determineCorrespondences(matches, distance),
                 BadArgumentException);
  }
  for (const index_t index : {-1, 43200}) {
    const IndicesPtr outside(new Indices{7, index});
    matcher_.setIndicesTarget(outside);
    EXPECT_THROW(refuse(now_), InitFailedException);
    matcher_.setIndicesTarget({});
    matcher_.setIndicesSource(outside);
    EXPECT_THROW(refuse(now_), InitFailedException);
    matcher_.setIndicesSource({});
  }
  EXPECT_EQ(matches.size(), 3u);
}

TEST(LogPolarTypes, ownPointsCanBeMatched)
{
  const Cloud::Ptr wall = wallOf(paint(Wallpaper(9)));
  PointCloud<PointXYZRGBSigma>::Ptr cloud(
      new PointCloud<PointXYZRGBSigma>(wall->width, wall->height));
  for (std::size_t i = 0; i < wall->size(); ++i) {
    (*cloud)[i].getVector3fMap() = (*wall)[i].getVector3fMap();
    (*cloud)[i].rgba = (*wall)[i].rgba;
  }
  registration::CorrespondenceEstimationLogPolar<PointXYZRGBSigma> matcher;
  matcher.setInputSource(cloud);
  matcher.setInputTarget(cloud);
  Correspondences matches;
  matcher.determineCorrespondences(matches);
  EXPECT_GT(matches.size(), 50u);
  for (const Correspondence& match : matches)
    EXPECT_EQ(match.index_query, match.index_match);
}

} // namespace
} // namespace pcl::acmap::test
