#include "room_views.h"

#include <pcl/core/pinhole.h>
#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

const Eigen::Isometry3d here = poseOf({-0.3, 0, -0.5}, 0.1);
constexpr std::size_t width = 320;

std::vector<Eigen::Vector3f>
seenFrom(const Eigen::Isometry3d& T_room_camera, const RoomCamera& camera = {})
{
  std::vector<Eigen::Vector3f> points;
  const PointCloud<PointXYZRGBSigma>::Ptr view = viewOf(Room(), T_room_camera, camera);
  for (const PointXYZRGBSigma& point : *view)
    points.push_back(point.getVector3fMap());
  return points;
}

std::optional<Pinhole>
fitTo(const std::vector<Eigen::Vector3f>& points, std::size_t pixels_per_row = width)
{
  return fitPinhole({points.data(), sizeof points[0], points.size()}, pixels_per_row);
}

std::optional<Pinhole>
fitUprightTo(const std::vector<Eigen::Vector3f>& points)
{
  return fitUprightPinhole({points.data(), sizeof points[0], points.size()}, width);
}

TEST(Pinhole, isFoundExactly)
{
  const std::optional<Pinhole> pinhole = fitTo(seenFrom(here));
  ASSERT_TRUE(pinhole);
  EXPECT_NEAR(pinhole->fx, 260, 1e-3);
  EXPECT_NEAR(pinhole->fy, 260, 1e-3);
  EXPECT_NEAR(pinhole->cx, 159.5, 1e-3);
  EXPECT_NEAR(pinhole->cy, 119.5, 1e-3);
  EXPECT_TRUE(fitUprightTo(seenFrom(here)));
}

TEST(Pinhole, ofHolesAndNoiseIsTheSame)
{
  RoomCamera noisy;
  noisy.noise = 1;
  std::vector<Eigen::Vector3f> points = seenFrom(here, noisy);
  Random random(5);
  for (Eigen::Vector3f& point : points)
    if (random.uniform() < 0.5)
      point.setConstant(std::numeric_limits<float>::quiet_NaN());
  const std::optional<Pinhole> pinhole = fitTo(points);
  ASSERT_TRUE(pinhole);
  EXPECT_NEAR(pinhole->fx, 260, 1e-3); // noise is along the rays
}

/** Noise across the rays neither shortens the focal length, as it does if pixels are
 * regressed on rays, nor do a few points of other rays make a view unknown. */
TEST(Pinhole, isNotShortenedByNoiseAcrossTheRays)
{
  RoomCamera small;
  small.width = 24;
  small.height = 18;
  small.focal_length = 20;
  std::vector<Eigen::Vector3f> points = seenFrom(here, small);
  double mean = 0;
  constexpr int runs = 200;
  Random random(3);
  for (int run = 0; run < runs; ++run) {
    std::vector<Eigen::Vector3f> noisy = points;
    for (Eigen::Vector3f& point : noisy)
      point.x() += static_cast<float>(point.z() * (random.uniform() - 0.5) * 0.09);
    const std::optional<Pinhole> pinhole = fitTo(noisy, 24);
    ASSERT_TRUE(pinhole);
    mean += pinhole->fx / runs;
  }
  // the other regression finds 20 / (1 + 0.0056); the bias of this one is far less
  EXPECT_NEAR(mean, 20, 0.02);
  for (std::size_t i = 0; i < points.size(); i += 30)
    points[i].x() += 0.3F * points[i].z();
  EXPECT_TRUE(fitTo(points, 24));
}

TEST(Pinhole, isNoneWherePointsLieOnNoCamerasRays)
{
  std::vector<Eigen::Vector3f> panorama = seenFrom(here);
  for (std::size_t i = 0; i < panorama.size(); ++i) {
    const double angle = (static_cast<double>(i % width) - 159.5) / 120;
    const auto row = static_cast<double>(i / width);
    panorama[i] =
        Eigen::Vector3d(2 * std::sin(angle), (row - 119.5) / 120, 2 * std::cos(angle))
            .cast<float>();
  }
  EXPECT_FALSE(fitTo(panorama));
  std::vector<Eigen::Vector3f> mirrored = seenFrom(here);
  for (Eigen::Vector3f& point : mirrored)
    point.x() = -point.x();
  EXPECT_FALSE(fitUprightTo(mirrored));
  ASSERT_TRUE(fitTo(mirrored));
  EXPECT_NEAR(fitTo(mirrored)->fx, -260, 1e-3);
  std::vector<Eigen::Vector3f> empty = seenFrom(here);
  for (Eigen::Vector3f& point : empty)
    point.setConstant(std::numeric_limits<float>::quiet_NaN());
  EXPECT_FALSE(fitTo(empty));
  EXPECT_FALSE(fitTo({}));
  EXPECT_FALSE(fitTo(seenFrom(here), 0));
  EXPECT_FALSE(fitTo(seenFrom(here), 319));
}

/** The projection of each point of a view is its pixel. */
TEST(Pinhole, projectsPointsToTheirPixels)
{
  const std::vector<Eigen::Vector3f> points = seenFrom(here);
  const std::optional<Pinhole> pinhole = fitTo(points);
  ASSERT_TRUE(pinhole);
  for (std::size_t i = 0; i < points.size(); i += 997) {
    const Eigen::Vector2d pixel = pinhole->project(points[i].cast<double>());
    EXPECT_NEAR(pixel.x(), static_cast<double>(i % width), 1e-2);
    EXPECT_NEAR(pixel.y(), static_cast<double>(i / width), 1e-2);
  }
}

} // namespace
} // namespace pcl::acmap::test
