#include "small_scenes.h"

#include <pcl/core/random.h>
#include <pcl/simulation/simulated_truth.h>
#include <pcl/stereo/disparity_back_projection.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();

/** A small rig, with a different disparity and colour at every pixel. */
class BackProjection : public testing::Test {
protected:
  BackProjection()
  {
    rig_.center_x = 30.25;
    rig_.center_y = 20.75;
    rig_.baseline_horizontal = -0.1;
    rig_.baseline_vertical = 0.3;
    projection_.setInputRig(rig_);
    Random random(5);
    matched_.disparity = {rig_.width, rig_.height, {}};
    color_ = {rig_.width, rig_.height, 3, {}};
    for (int i = 0; i < rig_.width * rig_.height; ++i) {
      matched_.disparity.values.push_back(static_cast<float>(random.uniform(1, 9)));
      matched_.sigma.push_back(static_cast<float>(random.uniform(0.01, 0.5)));
      for (int channel = 0; channel < 3; ++channel)
        color_.values.push_back(static_cast<std::uint8_t>(random.bits()));
    }
  }

  PointCloud<PointXYZRGBSigma>
  project()
  {
    PointCloud<PointXYZRGBSigma> cloud;
    projection_.project(matched_, color_, cloud);
    return cloud;
  }

  std::string
  faultOfProject()
  {
    PointCloud<PointXYZRGBSigma> cloud(3, 1);
    try {
      projection_.project(matched_, color_, cloud);
    }
    catch (const BadArgumentException& error) {
      EXPECT_EQ(cloud.size(), 3u) << "the output was touched";
      return error.what();
    }
    return "";
  }

  TrinocularRig rig_ = smallRig(64);
  DisparityBackProjection projection_;
  MatchedDisparity matched_;
  CameraImage color_;
};

TEST_F(BackProjection, EveryPixelIsWhereTheFormulasSay)
{
  const auto cloud = project();
  ASSERT_EQ(cloud.width, 64u);
  ASSERT_EQ(cloud.height, 48u);
  EXPECT_TRUE(cloud.is_dense);
  for (int row = 0; row < 48; ++row)
    for (int column = 0; column < 64; ++column) {
      const auto& point = cloud.at(column, row);
      const double disparity = matched_.disparity.at(column, row);
      const double z = rig_.focal_length * 0.1 / disparity;
      const Eigen::Vector3d ray(
          (column - 30.25) / rig_.focal_length, (row - 20.75) / rig_.focal_length, 1.0);
      EXPECT_LT((point.getVector3fMap().cast<double>() - z * ray).norm(), 1e-6 * z);
      // displacement of the point for a disparity change of one sigma
      const auto i = static_cast<std::size_t>(64 * row + column);
      constexpr double step = 1e-4;
      const double moved =
          (rig_.focal_length * 0.1 / (disparity - step) - z) * ray.norm() / step;
      EXPECT_NEAR(point.sigma, moved * matched_.sigma[i], 1e-3 * point.sigma);
      EXPECT_EQ(point.r, color_.values[3 * i]);
      EXPECT_EQ(point.g, color_.values[3 * i + 1]);
      EXPECT_EQ(point.b, color_.values[3 * i + 2]);
      EXPECT_EQ(point.a, 255);
    }
  EXPECT_EQ(projection_.getReport().points, 64u * 48u);
  EXPECT_TRUE(projection_.getReport().remarks.empty());
}

TEST_F(BackProjection, TheVerticalBaselineServesWhereThereIsNoOther)
{
  rig_.baseline_horizontal = 0.0;
  projection_.setInputRig(rig_);
  const auto cloud = project();
  EXPECT_NEAR(cloud[7].z, rig_.focal_length * 0.3 / matched_.disparity.values[7], 1e-5);
}

TEST_F(BackProjection, PixelsWithoutAPlaceHaveColourAndAreCounted)
{
  std::vector<float>& values = matched_.disparity.values;
  values[1] = nan_value;
  values[2] = std::numeric_limits<float>::infinity();
  values[3] = 0.0F;
  values[4] = -2.0F;
  const double focal_baseline = 0.1 * rig_.focal_length;
  values[5] = static_cast<float>(focal_baseline / 0.49);
  values[6] = static_cast<float>(focal_baseline / 7.1);
  for (std::size_t i = 7; i < values.size(); ++i)
    values[i] = static_cast<float>(focal_baseline / (0.51 + 6.0 * double(i) / 3072));
  values[0] = 2.0F;
  projection_.setMinimumDepth(0.5);
  projection_.setMaximumDepth(7.0);
  const auto cloud = project();
  EXPECT_FALSE(cloud.is_dense);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const bool has_place = i == 0 || i > 6;
    for (const float value : {cloud[i].x, cloud[i].y, cloud[i].z, cloud[i].sigma})
      EXPECT_EQ(std::isfinite(value), has_place) << i;
    EXPECT_EQ(cloud[i].g, color_.values[3 * i + 1]);
  }
  const DisparityBackProjectionReport report = projection_.getReport();
  EXPECT_EQ(report.points, cloud.size() - 6);
  EXPECT_EQ(report.invalid, 2u);
  EXPECT_EQ(report.too_near, 1u);
  EXPECT_EQ(report.too_far, 3u);
}

TEST_F(BackProjection, WithoutAnyPlaceItSaysSo)
{
  matched_.disparity.values.assign(64 * 48, nan_value);
  const auto cloud = project();
  EXPECT_EQ(cloud.size(), 64u * 48u);
  EXPECT_EQ(projection_.getReport().points, 0u);
  ASSERT_EQ(projection_.getReport().remarks.size(), 1u);
  EXPECT_EQ(cloud[9].r, color_.values[27]);
}

TEST_F(BackProjection, SigmaIsTheRigsWhereThereIsNone)
{
  rig_.disparity_sigma = 0.25;
  projection_.setInputRig(rig_);
  matched_.sigma[0] = nan_value;
  matched_.sigma[1] = -1.0F;
  matched_.sigma[2] = std::numeric_limits<float>::infinity();
  matched_.sigma[3] = 0.25F;
  matched_.sigma[4] = 0.0F;
  const auto given = project();
  EXPECT_EQ(given[4].sigma, 0.0F);
  matched_.sigma.clear();
  const auto of_rig = project();
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(given[i].sigma, of_rig[i].sigma) << i;
  EXPECT_NE(given[5].sigma, of_rig[5].sigma);
}

TEST_F(BackProjection, GreyIsGreyAndNoColourIsBlack)
{
  color_.channels = 1;
  color_.values.resize(64 * 48);
  const auto grey = project();
  for (const std::size_t i : {0u, 1000u, 3071u}) {
    EXPECT_EQ(grey[i].r, color_.values[i]);
    EXPECT_EQ(grey[i].g, color_.values[i]);
    EXPECT_EQ(grey[i].b, color_.values[i]);
  }
  color_ = {};
  EXPECT_EQ(project()[1000].rgba, 0xff000000u);
}

TEST_F(BackProjection, WhatDoesNotFitIsRefused)
{
  const MatchedDisparity matched = matched_;
  const CameraImage color = color_;
  matched_.disparity.width = 32;
  EXPECT_THAT(faultOfProject(), HasSubstr("32 x 48"));
  matched_ = matched;
  matched_.disparity.values.pop_back();
  EXPECT_THAT(faultOfProject(), HasSubstr("not all its values"));
  matched_ = matched;
  matched_.sigma.pop_back();
  EXPECT_THAT(faultOfProject(), HasSubstr("3071"));
  matched_ = matched;
  color_.height = 24;
  EXPECT_THAT(faultOfProject(), HasSubstr("64 x 24"));
  color_ = color;
  color_.channels = 2;
  EXPECT_THAT(faultOfProject(), HasSubstr("2 channels"));
  color_ = color;
  color_.values.pop_back();
  EXPECT_THAT(faultOfProject(), HasSubstr("colour"));
  color_ = color;
  projection_.setMinimumDepth(5);
  projection_.setMaximumDepth(5);
  EXPECT_THAT(faultOfProject(), HasSubstr("below the maximum depth"));
  projection_.setMaximumDepth(100);
  EXPECT_EQ(faultOfProject(), "");
}

TEST_F(BackProjection, ARigWithoutNeighboursIsRefusedAndTheOldOneStays)
{
  TrinocularRig lonely = rig_;
  lonely.baseline_horizontal = lonely.baseline_vertical = 0.0;
  EXPECT_THROW(projection_.setInputRig(lonely), BadArgumentException);
  lonely = rig_;
  lonely.focal_length = -1;
  EXPECT_THROW(projection_.setInputRig(lonely), BadArgumentException);
  EXPECT_EQ(projection_.getInputRig().baseline_vertical, 0.3);
  EXPECT_THROW(DisparityBackProjection().getInputRig(), InitFailedException);
}

/** Points from the exact disparities of a view. */
PointCloud<PointXYZRGBSigma>
trueCloud(const SimulatedScene& scene, const SimulatedTruth& truth)
{
  DisparityBackProjection projection;
  projection.setInputRig(scene.rig);
  MatchedDisparity matched;
  matched.disparity = truth.horizontal;
  PointCloud<PointXYZRGBSigma> cloud;
  projection.project(matched, {}, cloud);
  return cloud;
}

double
distanceToSurface(const Eigen::Vector3d& point, const SimulatedSurface& surface)
{
  if (const auto* rectangle = std::get_if<SimulatedRectangle>(&surface.shape))
    return std::abs(rectangle->normal().dot(point - rectangle->corner));
  if (const auto* disc = std::get_if<SimulatedDisc>(&surface.shape))
    return std::abs(disc->normal.dot(point - disc->center));
  const auto& cylinder = std::get<SimulatedCylinder>(surface.shape);
  return std::abs((point - cylinder.base).cross(cylinder.axis.normalized()).norm() -
                  cylinder.radius);
}

TEST(BackProjectionOfTruth, PointsLieOnTheSurfacesOfTheScene)
{
  for (const char* name : {"corridor", "office"}) {
    const SimulatedScene scene = smallScene(name, 160);
    for (const std::size_t view : {std::size_t{0}, scene.views.size() / 2}) {
      const SimulatedTruth truth = truthOf(scene, view);
      const auto cloud = trueCloud(scene, truth);
      std::size_t seen = 0;
      for (std::size_t i = 0; i < cloud.size(); ++i) {
        ASSERT_EQ(std::isfinite(cloud[i].z), truth.surfaces[i] >= 0);
        if (truth.surfaces[i] < 0)
          continue;
        const auto& surface =
            scene.geometry.surfaces()[static_cast<std::size_t>(truth.surfaces[i])];
        const Eigen::Vector3d point =
            scene.views[view] * cloud[i].getVector3fMap().cast<double>();
        EXPECT_LT(distanceToSurface(point, surface), 1e-4) << surface.name;
        ++seen;
      }
      EXPECT_GT(seen, cloud.size() / 2);
    }
  }
}

TEST(BackProjectionOfTruth, AWallAtThreeMetresIsOne)
{
  const SimulatedScene scene = wallAt(3.0);
  const auto cloud = trueCloud(scene, truthOf(scene, 0));
  const TrinocularRig& rig = scene.rig;
  const double deviation = rig.disparity_sigma * 9.0 / (rig.focal_length * 0.1);
  for (const auto& point : cloud) {
    EXPECT_NEAR(point.z, 3.0, 1e-5);
    EXPECT_NEAR(point.sigma, deviation * point.getVector3fMap().norm() / 3.0, 1e-6);
  }
  // width and height of the view are determined by its focal length
  const double width = 3.0 * (rig.width - 1) / rig.focal_length;
  const double height = 3.0 * (rig.height - 1) / rig.focal_length;
  EXPECT_NEAR(cloud.back().x - cloud.front().x, width, 1e-5);
  EXPECT_NEAR(cloud.back().y - cloud.front().y, height, 1e-5);
}

} // namespace
} // namespace pcl::acmap::test
