#include "room_views.h"

#include <pcl/common/io.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/random.h>
#include <pcl/egomotion/visual_egomotion.h>

#include <gtest/gtest.h>

#ifdef ACMAP_FEW_POINT_TYPES
#include <pcl/egomotion/impl/visual_egomotion.hpp>
#endif

#include <cmath>
#include <limits>

namespace pcl::acmap::test {

namespace {

using Cloud = PointCloud<PointXYZRGBSigma>;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

template <typename PointT>
std::optional<EgomotionEstimate>
estimateOf(const typename PointCloud<PointT>::ConstPtr& source,
           const typename PointCloud<PointT>::ConstPtr& target)
{
  VisualEgomotion<PointT> egomotion;
  egomotion.setInputSource(source);
  egomotion.setInputTarget(target);
  return egomotion.compute();
}

void
expectRight(const std::optional<EgomotionEstimate>& estimate, double metres = 0.003)
{
  ASSERT_TRUE(estimate);
  const Eigen::Matrix<double, 6, 1> error =
      motionBetween(before.inverse() * now, estimate->T_target_source);
  EXPECT_LT(error.head<3>().norm(), metres);
  EXPECT_LT(error.tail<3>().norm(), 0.001);
  EXPECT_TRUE(estimate->covariance.allFinite());
}

/** \brief Corrupts every few points of a view. */
Cloud::Ptr
spoilt(const Cloud::Ptr& view, const std::function<void(PointXYZRGBSigma&)>& spoil)
{
  Random random(11);
  for (PointXYZRGBSigma& point : *view)
    if (random.uniform() < 0.1)
      spoil(point);
  return view;
}

/** \brief An image of any size: half of the pixels have points, all have colours. */
Cloud::Ptr
rubble(std::uint32_t width, std::uint32_t height, std::uint64_t seed)
{
  Random random(seed);
  Cloud::Ptr cloud(new Cloud(width, height));
  for (PointXYZRGBSigma& point : *cloud) {
    point.r = point.g = point.b = static_cast<std::uint8_t>(random.uniform(0, 256));
    point.getVector3fMap() =
        Eigen::Vector3d(random.normal(), random.normal(), 3).cast<float>();
    if (random.uniform() < 0.5)
      point.z = nan;
    point.sigma = 0.01F;
  }
  return cloud;
}

} // namespace

template <typename PointT>
class VisualEgomotionPoints : public testing::Test {};

using CompiledIn =
    testing::Types<PointXYZRGB, PointXYZRGBA, PointXYZRGBNormal, PointXYZRGBSigma>;
TYPED_TEST_SUITE(VisualEgomotionPoints, CompiledIn);

TYPED_TEST(VisualEgomotionPoints, giveTheMotion)
{
  typename PointCloud<TypeParam>::Ptr source(new PointCloud<TypeParam>),
      target(new PointCloud<TypeParam>);
  RoomCamera noisy;
  noisy.noise = 0.2;
  copyPointCloud(*viewOf(Room(), now, noisy), *source);
  noisy.seed = 2;
  copyPointCloud(*viewOf(Room(), before, noisy), *target);
  expectRight(estimateOf<TypeParam>(source, target));
}

TEST(VisualEgomotionUgly, pointsThatAreNotFiniteDoNotCount)
{
  const std::vector<std::function<void(PointXYZRGBSigma&)>> spoilers{
      [](PointXYZRGBSigma& point) { point.x = nan; },
      [](PointXYZRGBSigma& point) { point.z = nan; },
      [](PointXYZRGBSigma& point) { point.x = infinity; },
      [](PointXYZRGBSigma& point) { point.z = infinity; },
      [](PointXYZRGBSigma& point) { point.getVector3fMap().setZero(); },
      [](PointXYZRGBSigma& point) { point.z = -point.z; }};
  for (std::size_t i = 0; i < spoilers.size(); ++i) {
    SCOPED_TRACE(i);
    const auto source = spoilt(viewOf(Room(), now), spoilers[i]);
    const auto target = spoilt(viewOf(Room(), before), spoilers[i]);
    expectRight(estimateOf<PointXYZRGBSigma>(source, target));
  }
}

TEST(VisualEgomotionUgly, sigmasThatCannotBeAreEstimated)
{
  for (const float sigma : {nan, 0.0F, -1.0F, infinity, 1e30F, 1e-30F}) {
    SCOPED_TRACE(sigma);
    const auto spoil = [=](PointXYZRGBSigma& point) { point.sigma = sigma; };
    expectRight(estimateOf<PointXYZRGBSigma>(spoilt(viewOf(Room(), now), spoil),
                                             spoilt(viewOf(Room(), before), spoil)));
  }
}

TEST(VisualEgomotionUgly, imagesOfAnySizeGiveNoMotionAtWorst)
{
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> sizes{
      {1, 2}, {3, 3}, {2, 500}, {40, 30}, {17, 700}, {700, 17}, {81, 80}};
  for (const auto& [width, height] : sizes)
    for (const auto& [target_width, target_height] : sizes)
      EXPECT_FALSE(estimateOf<PointXYZRGBSigma>(rubble(width, height, 1),
                                                rubble(target_width, target_height, 2)))
          << width << " x " << height;
}

TEST(VisualEgomotionUgly, viewsOfDifferentSizesGiveTheMotion)
{
  RoomCamera wide;
  wide.width = 400;
  wide.height = 200;
  expectRight(
      estimateOf<PointXYZRGBSigma>(viewOf(Room(), now, wide), viewOf(Room(), before)));
  RoomCamera small;
  small.width = 161;
  small.height = 121;
  expectRight(estimateOf<PointXYZRGBSigma>(viewOf(Room(), now, small),
                                           viewOf(Room(), before, small)),
              0.006);
}

TEST(VisualEgomotionUgly, aViewHasNotMovedFromItself)
{
  const auto view = viewOf(Room(), now);
  const auto estimate = estimateOf<PointXYZRGBSigma>(view, view);
  ASSERT_TRUE(estimate);
  EXPECT_LT(
      motionBetween(Eigen::Isometry3d::Identity(), estimate->T_target_source).norm(),
      0.0005);
  EXPECT_LT(estimate->covariance.diagonal().maxCoeff(), 0.01 * 0.01);
}

TEST(VisualEgomotionUgly, whatIsMissingIsRefused)
{
  VisualEgomotion<PointXYZRGBSigma> egomotion;
  EXPECT_THROW(egomotion.compute(), InitFailedException);
  egomotion.setInputSource(viewOf(Room(), now));
  EXPECT_THROW(egomotion.compute(), InitFailedException);
  const Cloud::Ptr row(new Cloud(300, 1)), lying(new Cloud(640, 480));
  lying->points.resize(1000);
  egomotion.setInputTarget(row);
  EXPECT_THROW(egomotion.compute(), UnorganizedPointCloudException);
  egomotion.setInputTarget(lying);
  EXPECT_THROW(egomotion.compute(), InitFailedException);
}

TEST(VisualEgomotionUgly, emptyCloudsAreBlank)
{
  VisualEgomotion<PointXYZRGBSigma> egomotion;
  egomotion.setInputSource(viewOf(Room(), now));
  egomotion.setInputTarget(Cloud::Ptr(new Cloud));
  EXPECT_FALSE(egomotion.compute());
  EXPECT_EQ(egomotion.getReport().outcome, EgomotionOutcome::BlankView);
}

} // namespace pcl::acmap::test
