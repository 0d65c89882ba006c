#include "pictures/drawing.h"

#include <pcl/pipeline/odometry_pictures.h>

#include <gtest/gtest.h>

#include <limits>
#include <utility>

namespace pcl::acmap::test {
namespace {

std::size_t
pixelsIn(const RgbImage& image, const Color& color)
{
  std::size_t count = 0;
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      const std::uint8_t* const pixel = image.at(column, row);
      count += Color{pixel[0], pixel[1], pixel[2]} == color ? 1 : 0;
    }
  return count;
}

Eigen::Vector2d
middleOf(const RgbImage& image, const Color& color)
{
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      if (Color{image.at(column, row)[0],
                image.at(column, row)[1],
                image.at(column, row)[2]} == color)
        sum += Eigen::Vector2d(column, row);
  return sum / static_cast<double>(pixelsIn(image, color));
}

std::vector<std::optional<Eigen::Isometry3d>>
wayAlongX(std::size_t poses)
{
  std::vector<std::optional<Eigen::Isometry3d>> way;
  for (std::size_t i = 0; i < poses; ++i) {
    way.emplace_back(Eigen::Isometry3d::Identity());
    way.back()->translation() << static_cast<double>(i), 0, 0;
  }
  return way;
}

TEST(TrajectoryPicture, ShowsGapsInRedAndTheTruthInGrey)
{
  auto way = wayAlongX(11);
  const RgbImage whole = trajectoryPicture(way, {});
  EXPECT_EQ(pixelsIn(whole, red), 0U);
  const std::size_t blue_of_whole = pixelsIn(whole, blue);
  EXPECT_GT(blue_of_whole, 900U);
  way[5].reset();
  const RgbImage torn = trajectoryPicture(way, {});
  EXPECT_GT(pixelsIn(torn, red), 50U);
  EXPECT_NEAR(static_cast<double>(pixelsIn(torn, blue)), 0.8 * blue_of_whole, 100);
  std::vector<Eigen::Isometry3d> truth(2, Eigen::Isometry3d::Identity());
  truth[1].translation() << 10, 0, 1;
  EXPECT_GT(pixelsIn(trajectoryPicture(wayAlongX(11), truth), gray),
            800 + pixelsIn(whole, gray));
}

TEST(TrajectoryPicture, DirectionsPointWhereTheCameraLooks)
{
  // a single pose in the centre, looking along x, then along -z
  for (const auto& [yaw, side] :
       {std::pair{1.5707963, Eigen::Vector2d(8, 0)}, {3.1415927, {0, 8}}}) {
    auto way = wayAlongX(1);
    way[0]->rotate(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitY()));
    const RgbImage image = trajectoryPicture(way, {});
    const Eigen::Vector2d at = middleOf(image, blue); // centre of the start dot
    const auto isDark = [&](const Eigen::Vector2d& place) {
      for (int dx = -1; dx <= 1; ++dx)
        for (int dy = -1; dy <= 1; ++dy)
          if (image.at(static_cast<int>(place.x()) + dx,
                       static_cast<int>(place.y()) + dy)[0] < 100)
            return true;
      return false;
    };
    EXPECT_TRUE(isDark(at + side)) << yaw;
    EXPECT_FALSE(isDark(at - side)) << yaw;
  }
}

TEST(TrajectoryPicture, OfWildPlacesCanBeDrawn)
{
  auto way = wayAlongX(3);
  way[1]->translation() << 1e12, std::numeric_limits<double>::quiet_NaN(), -1e300;
  EXPECT_GT(pixelsIn(trajectoryPicture(way, {}), blue), 40U); // the start dot
  EXPECT_GT(pixelsIn(trajectoryPicture({}, {}), black),
            50U); // the scale bar, the count
}

TEST(MatchPicture, LinesGoFromViewToView)
{
  PointCloud<PointXYZRGBSigma> before(40, 30), now(40, 30);
  const Correspondences matches = {{39, 0, 0}, {40 * 15, 40 * 15 + 39, 0}};
  const RgbImage image = matchPicture(now, before, matches, {matches[1]});
  const int middle = image.height / 2;
  const auto isDrawn = [&](int column, int row) {
    const std::uint8_t* const pixel = image.at(column, row);
    return std::max(pixel[0], pixel[1]) > 150 && pixel[2] < 150;
  };
  const int top = middle - 30;
  EXPECT_TRUE(isDrawn(0, top)); // from the upper left corner of the previous view
  // to the upper right corner of the current view
  EXPECT_TRUE(isDrawn(image.width - 1, top));
  EXPECT_FALSE(isDrawn(0, middle + top));
  EXPECT_TRUE(isDrawn(39, middle + top + 15));
  EXPECT_TRUE(isDrawn(image.width - 40, middle + top + 15));
  EXPECT_FALSE(isDrawn(10, middle + top + 15));
}

} // namespace
} // namespace pcl::acmap::test
