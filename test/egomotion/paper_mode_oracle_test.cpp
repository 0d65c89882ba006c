#include "naive_egomotion.h"
#include "room_views.h"

#include <pcl/egomotion/visual_egomotion.h>

#include <gtest/gtest.h>

#include <limits>

namespace pcl::acmap::test {

namespace {

using Cloud = PointCloud<PointXYZRGBSigma>;

constexpr double max_distortion = 1.15;

/** Two small views of a room; the points of some pixels are missing, and those of others
 * have moved by half a metre, so that Eq. 1 has matches to remove. */
class PaperModeKeypoints : public testing::Test {
protected:
  static Cloud::Ptr
  spoiledView(const Eigen::Isometry3d& pose,
              std::uint64_t seed,
              float moved,
              double gain = 1)
  {
    RoomCamera camera;
    camera.gain = gain;
    camera.offset = 128 - 128 * gain;
    camera.width = 120;
    camera.height = 90;
    camera.focal_length = 100;
    camera.noise = 1;
    camera.seed = seed;
    const Cloud::Ptr view = viewOf(Room(seed), pose, camera);
    for (std::size_t i = 0; i < view->size(); ++i)
      if (i % 120 > 70 && i / 120 < 40)
        (*view)[i].x += moved;
      else if (i % 7 == 0)
        (*view)[i].getVector3fMap().setConstant(
            std::numeric_limits<float>::quiet_NaN());
    return view;
  }

  static NaiveMatches
  pixelsOf(const Correspondences& matches)
  {
    NaiveMatches pixels;
    for (const Correspondence& match : matches)
      pixels.emplace_back(match.index_query, match.index_match);
    return pixels;
  }
};

/** Parameters: seed, shifts of rings and of sectors. */
class PaperModeOracle : public PaperModeKeypoints,
                        public testing::WithParamInterface<std::tuple<int, int, int>> {
};

} // namespace

TEST_P(PaperModeOracle, everyStepIsTheNaiveOne)
{
  const auto [number, ring_shifts, sector_shifts] = GetParam();
  const auto seed = static_cast<std::uint64_t>(number);
  // it approaches by a fifth and rolls by a sector, so that shifts matter
  const bool shifts = ring_shifts > 0;
  const Cloud::Ptr source = spoiledView(
      shifts ? before * poseOf({0.1, 0, 0.7}, 0.05, 0, 0.24) : now, seed, 0.5F);
  const Cloud::Ptr target = spoiledView(before, seed, 0);
  VisualEgomotion<PointXYZRGBSigma> egomotion;
  egomotion.setPaperMode(true);
  egomotion.setMaximumShifts(ring_shifts, sector_shifts);
  egomotion.setInputSource(source);
  egomotion.setInputTarget(target);
  const auto estimate = egomotion.compute();
  ASSERT_TRUE(estimate) << egomotion.getReport().reason;
  const EgomotionReport& report = egomotion.getReport();

  EXPECT_EQ(report.source_keypoints, naiveKeypoints(*source).size());
  EXPECT_EQ(report.target_keypoints, naiveKeypoints(*target).size());
  const NaiveMatches matches =
      naiveMatches(*source, *target, ring_shifts, sector_shifts);
  EXPECT_EQ(pixelsOf(egomotion.getMatches()), matches);
  if (shifts) {
    EXPECT_NE(matches, naiveMatches(*source, *target, 0, sector_shifts));
    EXPECT_NE(matches, naiveMatches(*source, *target, ring_shifts, 0));
  }

  NaiveMatches kept;
  for (const std::size_t i :
       naiveLeaveWorstOut(pairsOf(*source, *target, matches), max_distortion))
    kept.push_back(matches[i]);
  EXPECT_EQ(pixelsOf(egomotion.getInliers()), kept);
  EXPECT_EQ(report.removed, matches.size() - kept.size());
  EXPECT_GT(report.removed, 0u);
  EXPECT_GT(kept.size(), 10u);

  const NaivePairs pairs = pairsOf(*source, *target, kept);
  const Eigen::Vector3d action = naiveAction(pairs);
  EXPECT_NEAR(estimate->action.dx, action[0], 1e-7);
  EXPECT_NEAR(estimate->action.dz, action[1], 1e-7);
  EXPECT_NEAR(estimate->action.dtheta, action[2], 1e-7);
  EXPECT_EQ(report.fits, 1u);
  EXPECT_GT(report.iterations, 0u);
  const Eigen::Matrix3d covariance = naiveCovariance(pairs, action);
  const int rows[] = {0, 2, 4};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(estimate->covariance(rows[i], rows[j]),
                  covariance(i, j),
                  1e-5 * std::sqrt(covariance(i, i) * covariance(j, j)));
}

TEST_F(PaperModeKeypoints, faintMaximaCountAsWell)
{
  const Cloud::Ptr view = spoiledView(now, 1, 0, 0.05);
  VisualEgomotion<PointXYZRGBSigma> egomotion;
  egomotion.setPaperMode(true);
  egomotion.setInputSource(view);
  egomotion.setInputTarget(view);
  egomotion.compute();
  EXPECT_EQ(egomotion.getReport().source_keypoints, naiveKeypoints(*view).size());
  EXPECT_GT(egomotion.getReport().matches, 0u);
}

INSTANTIATE_TEST_SUITE_P(SeedsAndShifts,
                         PaperModeOracle,
                         testing::Values(std::tuple(1, 1, 1),
                                         std::tuple(2, 1, 1),
                                         std::tuple(3, 1, 1),
                                         std::tuple(4, 0, 0),
                                         std::tuple(5, 2, 3)));

} // namespace pcl::acmap::test
