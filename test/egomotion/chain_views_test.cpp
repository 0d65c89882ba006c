#include "chain/egomotion_failure.h"
#include "chain/surface_blocks.h"
#include "chain/view_levels.h"
#include "chain_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
const Eigen::Isometry3d here = poseOf({-0.3, 0, -0.5}, 0.1);

/** \brief A frontal wall that fills the view. */
Room
wallAt(double depth)
{
  Room room;
  room.walls = Box(Eigen::Vector3d(-50, -50, -1), Eigen::Vector3d(50, 50, depth));
  room.things.clear();
  return room;
}

std::shared_ptr<const EgomotionView>
prepared(const Room& room,
         const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity())
{
  return prepareView(chainView(room, pose), {});
}

double
median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

} // namespace

TEST(EgomotionView, hasNoPinholeIfPointsLieOnNoCamerasRays)
{
  EXPECT_TRUE(prepared(Room(), here)->pinhole);
  CameraView mirrored = chainView(Room(), here);
  for (Eigen::Vector3f& point : mirrored.points)
    point.x() = -point.x();
  EXPECT_FALSE(prepareView(mirrored, {})->pinhole);
}

TEST(ViewLevels, halveByTheirWeights)
{
  const CameraView view = chainView(Room(), here);
  const std::vector<ViewLevel> levels = viewLevels(view);
  ASSERT_EQ(levels.size(), 3u); // 30 rows would be too few
  const double weights[] = {1, 3, 3, 1};
  for (std::size_t l = 1; l < levels.size(); ++l) {
    const GreyImage& fine = levels[l - 1].image;
    const GreyImage& half = levels[l].image;
    ASSERT_EQ(half.width, fine.width / 2);
    ASSERT_EQ(half.height, fine.height / 2);
    for (int y = 0; y < half.height; ++y)
      for (int x = 0; x < half.width; ++x) {
        double sum = 0;
        for (int j = 0; j < 4; ++j)
          for (int i = 0; i < 4; ++i)
            sum += weights[i] * weights[j] / 64 *
                   fine.values[static_cast<std::size_t>(
                       std::clamp(2 * y - 1 + j, 0, fine.height - 1) * fine.width +
                       std::clamp(2 * x - 1 + i, 0, fine.width - 1))];
        ASSERT_NEAR(
            half.values[static_cast<std::size_t>(y * half.width + x)], sum, 1e-3);
      }
  }
}

TEST(ViewLevels, pointsAreMeansOfWholeSurfacesOnly)
{
  CameraView view = chainView(Room(), here);
  Random random(7);
  for (Eigen::Vector3f& point : view.points)
    if (random.uniform() < 0.1)
      point.setConstant(nan);
  const std::vector<ViewLevel> levels = viewLevels(view);
  const ViewLevel& half = levels.at(1);
  std::size_t places = 0;
  for (int y = 0; y < half.image.height; ++y)
    for (int x = 0; x < half.image.width; ++x) {
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      float nearest = 1e9F, farthest = 0;
      for (const int at : {0, 1, view.image.width, view.image.width + 1}) {
        const Eigen::Vector3f& point = view.points[static_cast<std::size_t>(
            2 * y * view.image.width + 2 * x + at)];
        sum += point;
        nearest = std::min(nearest, point.z());
        farthest = std::max(farthest, point.z());
      }
      const Eigen::Vector3f& found =
          half.points[static_cast<std::size_t>(y * half.image.width + x)];
      const bool is_whole = sum.allFinite() && farthest - nearest <= 0.05F * nearest;
      ASSERT_EQ(found.allFinite(), is_whole);
      if (is_whole) {
        ASSERT_LT((found - sum / 4).norm(), 1e-5F);
        ++places;
      }
    }
  EXPECT_GT(places, half.points.size() / 2);
}

TEST(ViewLevels, noiseIsMeasuredAndHalvedWithTheImage)
{
  for (const double noise : {1.0, 3.0, 8.0}) {
    CameraView view = chainView(Room(), here);
    Random random(9);
    for (float& value : view.image.values)
      value += static_cast<float>(noise * random.normal());
    EXPECT_NEAR(imageNoise(view.image), noise, 0.2 * noise); // the texture also counts
                                                             // as noise
    const CameraView clean = chainView(Room(), here);
    const std::vector<ViewLevel> levels = viewLevels(view), truth = viewLevels(clean);
    for (std::size_t l = 1; l < levels.size(); ++l) {
      double squares = 0;
      for (std::size_t i = 0; i < truth[l].image.values.size(); ++i)
        squares += std::pow(levels[l].image.values[i] - truth[l].image.values[i], 2);
      const double rms =
          std::sqrt(squares / static_cast<double>(truth[l].image.values.size()));
      EXPECT_NEAR(levels[l].noise, rms, 0.25 * rms) << noise << ", level " << l;
    }
  }
}

TEST(SurfaceBlocks, sigmaOfNoisyPlanesIsEstimated)
{
  for (const double sigma : {0.0005, 0.001, 0.003}) {
    RoomCamera noisy;
    noisy.noise = 1;
    noisy.sigma = sigma;
    const CameraView view = chainView(Room(), here, noisy);
    const std::vector<float> estimated = estimatedSigmas(view);
    std::vector<double> ratios;
    for (std::size_t i = 0; i < estimated.size(); ++i)
      ratios.push_back(estimated[i] / view.sigmas[i]);
    EXPECT_NEAR(median(ratios), 1, 0.3) << sigma;
  }
}

TEST(SurfaceBlocks, arePlanesOfTheRoom)
{
  RoomCamera noisy;
  noisy.noise = 1;
  const Room room = wallAt(2.5);
  const SurfaceBlocks surfaces =
      surfaceBlocks(chainView(room, Eigen::Isometry3d::Identity(), noisy));
  std::size_t planes = 0;
  double squared = 0;
  for (const SurfaceBlock& block : surfaces.blocks)
    if (block.isPlane()) {
      EXPECT_GT(block.normal.dot(-Eigen::Vector3d::UnitZ()), 0.99);
      squared += std::pow(block.point.z() - 2.5, 2) / block.variance;
      ++planes;
    }
  EXPECT_GT(planes, surfaces.blocks.size() / 2);
  // the variance is that of a single point; here the errors of neighbours are
  // independent
  EXPECT_NEAR(squared / static_cast<double>(planes), 1.0 / 64, 0.005);
}

TEST(Contradiction, isWhatStandsBeforeWhatWasSeen)
{
  const auto near = prepared(wallAt(2)), far = prepared(wallAt(3));
  const Eigen::Isometry3d still = Eigen::Isometry3d::Identity();
  EXPECT_EQ(contradictedShare(*near, *near, still), 0);
  EXPECT_EQ(contradictedShare(*near, *far, still), 1);
  EXPECT_EQ(contradictedShare(*far, *near, still), 1); // because of the target's
                                                       // surfaces
  EXPECT_EQ(contradictedShare(*near, *far, poseOf({0, 0, 1}, 0)), 0);
}

TEST(Contradiction, isTheShareOfTheSurface)
{
  Room half = wallAt(3);
  half.things = {Box(Eigen::Vector3d(-50, -50, 2), Eigen::Vector3d(0, 50, 2.2))};
  const double share = contradictedShare(
      *prepared(half), *prepared(wallAt(3)), Eigen::Isometry3d::Identity());
  EXPECT_NEAR(share, 0.5, 0.05);
}

TEST(Contradiction, isNoneOfARightMotion)
{
  const Eigen::Isometry3d there = here * poseOf({0.15, 0, 0.2}, 0.1);
  const double share = contradictedShare(
      *prepared(Room(), there), *prepared(Room(), here), here.inverse() * there);
  EXPECT_LT(share, 0.01);
}

} // namespace pcl::acmap::test
