#include "stereo_matches.h"

#include <pcl/conversions.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/point_types.h>
#include <pcl/egomotion/correspondence_rejector_worst_out.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

using registration::CorrespondenceRejectorWorstOut;

/** Matches between shuffled points, with unmatched points in between. */
class WorstOutRejector : public testing::Test {
protected:
  WorstOutRejector()
  {
    StereoMatchSettings scene;
    scene.right = 60;
    scene.wrong = 30;
    made_ = stereoMatches(scene);
    const std::size_t n = made_.source.size();
    source_->resize(2 * n);
    target_->resize(2 * n);
    for (std::size_t i = 0; i < n; ++i) {
      (*source_)[2 * i].getVector3fMap() = made_.source[i];
      (*target_)[2 * n - 1 - 2 * i].getVector3fMap() = made_.target[i];
      matches_.emplace_back(
          static_cast<int>(2 * i), static_cast<int>(2 * n - 1 - 2 * i), 0.5F);
    }
    wanted_ = leaveWorstOut(made_.source, made_.target, {});
    rejector_.setInputSource<PointXYZRGBSigma>(source_);
    rejector_.setInputTarget<PointXYZRGBSigma>(target_);
  }

  void
  expectWanted(const Correspondences& remaining) const
  {
    ASSERT_EQ(remaining.size(), wanted_.kept.size());
    for (std::size_t i = 0; i < remaining.size(); ++i)
      EXPECT_EQ(remaining[i].index_query, 2 * wanted_.kept[i]);
  }

  StereoMatches made_;
  PointCloud<PointXYZRGBSigma>::Ptr source_{new PointCloud<PointXYZRGBSigma>},
      target_{new PointCloud<PointXYZRGBSigma>};
  Correspondences matches_;
  WorstOutOutcome wanted_;
  CorrespondenceRejectorWorstOut rejector_;
};

TEST_F(WorstOutRejector, keepsMatchesAsTheyAreAndInTheirOrder)
{
  Correspondences remaining;
  rejector_.getRemainingCorrespondences(matches_, remaining);
  expectWanted(remaining);
  EXPECT_EQ(remaining.front().distance, 0.5F);
  const auto& report = rejector_.getReport();
  EXPECT_EQ(report.given, 90u);
  EXPECT_EQ(report.kept, remaining.size());
  EXPECT_EQ(report.invalid, 0u);
  EXPECT_EQ(report.distortion, wanted_.distortion);
  EXPECT_TRUE(report.remarks.empty());
}

TEST_F(WorstOutRejector, inputMayBeOutput)
{
  rejector_.getRemainingCorrespondences(matches_, matches_);
  expectWanted(matches_);
}

TEST_F(WorstOutRejector, theSameByPclsWay)
{
  CorrespondenceRejectorWorstOut rejector;
  for (const bool is_organized : {false, true}) {
    PCLPointCloud2::Ptr source(new PCLPointCloud2), target(new PCLPointCloud2);
    toPCLPointCloud2(*source_, *source);
    toPCLPointCloud2(*target_, *target);
    if (is_organized) {
      target->width /= 2;
      target->height = 2;
      target->row_step /= 2;
    }
    rejector.setSourcePoints(source);
    rejector.setTargetPoints(target);
    rejector.setInputCorrespondences(
        CorrespondencesConstPtr(new Correspondences(matches_)));
    Correspondences remaining;
    rejector.getCorrespondences(remaining);
    expectWanted(remaining);
  }
}

TEST_F(WorstOutRejector, settingsDoWhatTheySay)
{
  Correspondences remaining;
  rejector_.setMaximumDistortion(1.2);
  rejector_.getRemainingCorrespondences(matches_, remaining);
  EXPECT_GT(remaining.size(), wanted_.kept.size());
  rejector_.setMaximumDistortion(1.06);

  rejector_.setMinimumMatches(wanted_.kept.size() + 1);
  rejector_.getRemainingCorrespondences(matches_, remaining);
  EXPECT_TRUE(remaining.empty());
  EXPECT_EQ(rejector_.getReport().remarks.size(), 1u);
  rejector_.setMinimumMatches(6);

  rejector_.setMinimumDistance(100); // all pairs count as near now
  rejector_.getRemainingCorrespondences(matches_, remaining);
  EXPECT_TRUE(remaining.empty());
}

TEST_F(WorstOutRejector, paperModeIsEquationOneAsPrinted)
{
  EXPECT_FALSE(rejector_.getPaperMode());
  rejector_.setPaperMode(true);
  EXPECT_TRUE(rejector_.getPaperMode());
  WorstOutSettings settings;
  settings.paper = true;
  wanted_ = leaveWorstOut(made_.source, made_.target, settings);
  Correspondences remaining;
  rejector_.getRemainingCorrespondences(matches_, remaining);
  expectWanted(remaining);
  rejector_.setMinimumDistance(100); // has no effect
  rejector_.setMinimumMatches(1000);
  rejector_.setSampleSize(10);
  rejector_.getRemainingCorrespondences(matches_, remaining);
  expectWanted(remaining);
  rejector_.getRemainingCorrespondences({}, remaining);
  EXPECT_EQ(rejector_.getReport().remarks.size(), 1u);
}

TEST_F(WorstOutRejector, invalidPlacesAreRemovedAndCounted)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const auto kept = static_cast<std::size_t>(wanted_.kept[3]);
  (*source_)[2 * kept].y = nan;
  rejector_.setInputSource<PointXYZRGBSigma>(source_);
  Correspondences remaining;
  rejector_.getRemainingCorrespondences(matches_, remaining);
  EXPECT_EQ(rejector_.getReport().invalid, 1u);
  EXPECT_EQ(rejector_.getReport().remarks.size(), 1u);
  for (const Correspondence& match : remaining)
    EXPECT_NE(match.index_query, static_cast<int>(2 * kept));
}

TEST_F(WorstOutRejector, whatIsMissingIsSaidAndNothingTouched)
{
  const Correspondences before(matches_);
  Correspondences remaining(matches_);
  CorrespondenceRejectorWorstOut without;
  EXPECT_THROW(without.getRemainingCorrespondences(matches_, remaining),
               InitFailedException);
  without.setInputSource<PointXYZRGBSigma>(source_);
  EXPECT_THROW(without.getRemainingCorrespondences(matches_, remaining),
               InitFailedException);
  EXPECT_THROW(rejector_.setInputSource<PointXYZRGBSigma>(nullptr),
               BadArgumentException);
  EXPECT_THROW(rejector_.setInputTarget<PointXYZ>(nullptr), BadArgumentException);
  for (const int outside : {-1, 180, 1 << 30}) {
    for (const bool is_query : {true, false}) {
      Correspondences wrong(matches_);
      (is_query ? wrong[7].index_query : wrong[7].index_match) = outside;
      EXPECT_THROW(rejector_.getRemainingCorrespondences(wrong, remaining),
                   BadArgumentException);
    }
  }
  EXPECT_EQ(remaining.size(), before.size());
  rejector_.getRemainingCorrespondences(matches_, remaining);
  expectWanted(remaining);
}

TEST_F(WorstOutRejector, blobsThatAreNoCloudsAreRefused)
{
  PCLPointCloud2 good;
  toPCLPointCloud2(*source_, good);
  const auto expectRefused = [this](const PCLPointCloud2& blob) {
    const PCLPointCloud2::ConstPtr cloud(new PCLPointCloud2(blob));
    EXPECT_THROW(rejector_.setSourcePoints(cloud), BadArgumentException);
    EXPECT_THROW(rejector_.setTargetPoints(cloud), BadArgumentException);
  };
  EXPECT_THROW(rejector_.setSourcePoints(nullptr), BadArgumentException);
  expectRefused(PCLPointCloud2());

  PCLPointCloud2 bad = good;
  bad.fields.erase(bad.fields.begin() + 1);
  expectRefused(bad);
  bad = good;
  bad.fields[2].datatype = PCLPointField::FLOAT64;
  expectRefused(bad);
  bad = good;
  bad.fields[0].count = 3;
  expectRefused(bad);
  bad = good;
  bad.fields[0].offset = bad.point_step - 3;
  expectRefused(bad);
  bad = good;
  bad.fields[0].offset = 0xffffffff;
  expectRefused(bad);
  bad = good;
  bad.data.pop_back();
  expectRefused(bad);
  bad = good;
  bad.width /= 2;
  bad.height = 2; // rows with padding
  expectRefused(bad);

  // earlier settings are kept
  Correspondences remaining;
  rejector_.getRemainingCorrespondences(matches_, remaining);
  expectWanted(remaining);
}

} // namespace
} // namespace pcl::acmap::test
