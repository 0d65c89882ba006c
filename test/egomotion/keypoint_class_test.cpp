#include "painted_views.h"

#include <pcl/core/point_types.h>
#include <pcl/egomotion/gradient_maximum_keypoint.h>
#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace pcl::acmap::test {
namespace {

using Detector = GradientMaximumKeypoint<PointXYZRGB>;
using Cloud = PointCloud<PointXYZRGB>;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

class GradientMaximumClass : public testing::Test {
protected:
  Indices
  indicesOf(const Cloud::ConstPtr& cloud)
  {
    detector_.setInputCloud(cloud);
    detector_.compute(keypoints_);
    return detector_.getKeypointsIndices()->indices;
  }

  Detector detector_;
  Cloud keypoints_;
  const Cloud::Ptr cloud_ = wallOf(paint(Wallpaper(2)));
};

TEST_F(GradientMaximumClass, givesThePointsOfItsIndices)
{
  cloud_->header.stamp = 77;
  const Indices indices = indicesOf(cloud_);
  ASSERT_GT(indices.size(), 100u);
  EXPECT_TRUE(std::is_sorted(indices.begin(), indices.end()));
  ASSERT_EQ(keypoints_.size(), indices.size());
  EXPECT_EQ(keypoints_.header.stamp, 77u);
  EXPECT_TRUE(keypoints_.is_dense);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const PointXYZRGB& point = (*cloud_)[static_cast<std::size_t>(indices[i])];
    EXPECT_EQ(keypoints_[i].getVector3fMap(), point.getVector3fMap());
    EXPECT_EQ(keypoints_[i].rgba, point.rgba);
  }
}

TEST_F(GradientMaximumClass, gainAndOffsetOfLightChangeNothing)
{
  // integral grey levels, to avoid effects of rounding
  Cloud::Ptr dim = wallOf(paint(Wallpaper(2, 12)));
  const Indices wanted = indicesOf(dim);
  for (PointXYZRGB& point : *dim)
    point.r = point.g = point.b = static_cast<std::uint8_t>(2 * point.r - 128);
  detector_.setMinimumGradient(1); // twice the default
  EXPECT_EQ(indicesOf(dim), wanted);
}

TEST_F(GradientMaximumClass, throughItsBaseItDoesTheSame)
{
  const Indices wanted = indicesOf(cloud_);
  Detector other;
  Keypoint<PointXYZRGB, PointXYZRGB>& base = other;
  base.setInputCloud(cloud_);
  Cloud keypoints;
  base.compute(keypoints);
  EXPECT_EQ(base.getKeypointsIndices()->indices, wanted);
  EXPECT_EQ(keypoints.size(), wanted.size());
}

TEST_F(GradientMaximumClass, onlyIndicesCanBeKeypoints)
{
  const Indices all = indicesOf(cloud_);
  IndicesPtr half(new Indices(cloud_->size() / 2));
  std::iota(half->begin(), half->end(), 0);
  half->insert(half->end(), half->begin(), half->end() - 5); // duplicates
  detector_.setIndices(half);
  Indices wanted;
  for (const index_t index : all)
    if (static_cast<std::size_t>(index) < cloud_->size() / 2)
      wanted.push_back(index);
  EXPECT_EQ(indicesOf(cloud_), wanted);
  EXPECT_EQ(detector_.getReport().maxima, all.size());
  EXPECT_EQ(detector_.getReport().without_place, all.size() - wanted.size());
}

TEST_F(GradientMaximumClass, colourCountsWherePlacesAreMissing)
{
  // every other column has no positions: the remaining keypoints do not move
  const Indices all = indicesOf(cloud_);
  for (std::size_t i = 1; i < cloud_->size(); i += 2)
    (*cloud_)[i].z = nan;
  Indices wanted;
  for (const index_t index : all)
    if (index % 2 == 0)
      wanted.push_back(index);
  EXPECT_EQ(indicesOf(cloud_), wanted);
}

TEST_F(GradientMaximumClass, uglyCloudsGiveNothingAndSayWhy)
{
  Cloud::Ptr black(new Cloud(40, 30));
  Cloud::Ptr empty(new Cloud);
  Cloud::Ptr thin(new Cloud(1, 30));
  Cloud::Ptr nowhere(new Cloud(*cloud_));
  for (PointXYZRGB& point : *nowhere)
    point.x = point.y = point.z = nan;
  for (const auto& cloud : {black, empty, thin, nowhere}) {
    keypoints_.resize(3);
    EXPECT_TRUE(indicesOf(cloud).empty());
    EXPECT_TRUE(keypoints_.empty());
    EXPECT_EQ(detector_.getReport().remarks.size(), 1u);
  }
  EXPECT_GT(detector_.getReport().without_place, 100u);
}

TEST_F(GradientMaximumClass, whatIsNoImageIsRefused)
{
  const auto refuse = [&](const Cloud::ConstPtr& cloud) {
    keypoints_.resize(3);
    EXPECT_THROW(indicesOf(cloud), UnorganizedPointCloudException);
    EXPECT_EQ(keypoints_.size(), 3u);
  };
  refuse(Cloud::Ptr(new Cloud(1, 1)));
  refuse(Cloud::Ptr(new Cloud(100, 1)));
  Cloud::Ptr torn(new Cloud(*cloud_)); // the header announces more pixels
  for (const std::size_t points :
       {torn->size() - 1, std::size_t{1000}, std::size_t{0}}) {
    torn->points.resize(points);
    EXPECT_THROW(indicesOf(torn), InitFailedException);
  }
  for (const index_t index : {-1, 43200}) {
    detector_.setIndices(IndicesPtr(new Indices{5, index}));
    EXPECT_THROW(indicesOf(cloud_), InitFailedException);
  }
}

TEST(GradientMaximumTypes, ownPointsAreTaken)
{
  const Cloud::Ptr wall = wallOf(paint(Wallpaper(2)));
  PointCloud<PointXYZRGBSigma>::Ptr cloud(
      new PointCloud<PointXYZRGBSigma>(wall->width, wall->height));
  for (std::size_t i = 0; i < wall->size(); ++i) {
    (*cloud)[i].getVector3fMap() = (*wall)[i].getVector3fMap();
    (*cloud)[i].rgba = (*wall)[i].rgba;
    (*cloud)[i].sigma = 0.01F;
  }
  GradientMaximumKeypoint<PointXYZRGBSigma> detector;
  PointCloud<PointXYZRGBSigma> keypoints;
  detector.setInputCloud(cloud);
  detector.compute(keypoints);
  EXPECT_GT(keypoints.size(), 100u);
  EXPECT_EQ(keypoints[0].sigma, 0.01F);
}

} // namespace
} // namespace pcl::acmap::test
