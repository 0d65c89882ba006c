#include "kinect_scenes.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/simulation/standard_scenes.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <set>

namespace pcl::acmap::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Spread {
  double mean = 0, sigma = 0;
};

Spread
spreadOf(const std::vector<double>& values)
{
  double sum = 0, squares = 0;
  for (const double value : values) {
    sum += value;
    squares += value * value;
  }
  const auto count = static_cast<double>(values.size());
  return {sum / count, std::sqrt(squares / count - sum * sum / count / count)};
}

/** \brief Errors of a wall's disparities, px. */
std::vector<double>
disparityErrors(const SimulatedScene& scene)
{
  const SeenView seen(scene);
  std::vector<double> errors;
  for (int row = 0; row < scene.rig.height; ++row)
    for (int column = 0; column < scene.rig.width; ++column)
      if (seen.isAwayFromEdges(row, column, 4) && std::isfinite(seen.at(row, column).z))
        errors.push_back(seen.error(row, column) * scene.rig.focal_length *
                         std::abs(scene.rig.baseline_horizontal));
  return errors;
}

TEST(DepthCamera, DepthsAreThoseOfRoundedDisparities)
{
  const SimulatedScene scene = standardSeenByKinect("loop");
  const SimulatedObservation observation = observe(scene, 0, 1);
  EXPECT_GT(observation.points, 100000u);
  std::set<float> depths;
  for (const ObservationPixel& pixel : observation.pixels)
    if (std::isfinite(pixel.z))
      depths.insert(pixel.z);
  EXPECT_GT(depths.size(), 100u);
  EXPECT_LT(depths.size(), 640u);
  std::vector<double> spacings;
  double before = infinity;
  for (const float depth : depths) {
    EXPECT_NEAR(depth * 1000.0, std::round(depth * 1000.0), 1e-3);
    if (depth > 2.0f && before > 2.0)
      spacings.push_back(1.0 / before - 1.0 / static_cast<double>(depth));
    before = depth;
  }
  std::nth_element(
      spacings.begin(), spacings.begin() + spacings.size() / 2, spacings.end());
  EXPECT_NEAR(spacings[spacings.size() / 2], 0.0029, 0.02 * 0.0029);
}

TEST(DepthCamera, WithoutNoiseAWallIsHalfAStepOff)
{
  for (const double depth : {0.7, 1.3, 2.2, 3.9, 5.7}) {
    SimulatedScene scene = wallSeenByKinect(depth);
    scene.rig.disparity_sigma = 0.0;
    const SeenView seen(scene);
    // rounding to mm, and 1e-5 px of the growth with the angle of incidence
    const double rounding = 0.0006 / (depth * depth);
    for (int row = 0; row < scene.rig.height; ++row)
      for (int column = 0; column < scene.rig.width - 8; ++column)
        ASSERT_LT(std::abs(seen.error(row, column)),
                  0.51 * inverseStep(scene) + rounding)
            << depth;
  }
}

TEST(DepthCamera, PlanesOfTheStandardScenesAreWithinTwoSteps)
{
  for (const char* const name : {"office", "corridor", "loop"}) {
    const SimulatedScene scene = standardSeenByKinect(name);
    const SeenView seen(scene);
    std::size_t all = 0, near = 0;
    for (int row = 0; row < scene.rig.height; ++row)
      for (int column = 0; column < scene.rig.width; ++column)
        if (seen.isAwayFromEdges(row, column, 5) &&
            std::isfinite(seen.at(row, column).z)) {
          ++all;
          near += std::abs(seen.error(row, column)) < 2 * inverseStep(scene);
        }
    EXPECT_GT(all, 100000u) << name;
    EXPECT_GT(static_cast<double>(near), 0.99 * static_cast<double>(all)) << name;
  }
}

TEST(DepthCamera, NoiseIsThatOfTheRigAndOfRounding)
{
  std::vector<double> errors;
  for (const double depth : {1.5, 1.6, 1.7, 1.8, 1.9, 2.0, 2.1, 2.2, 2.3, 2.4})
    for (const double error : disparityErrors(wallSeenByKinect(depth)))
      errors.push_back(error);
  const Spread spread = spreadOf(errors);
  const double expected = std::hypot(0.08, 0.125 / std::sqrt(12.0));
  EXPECT_NEAR(spread.sigma, expected, 0.1 * expected);
  EXPECT_NEAR(spread.mean, 0.0, 0.02);
}

TEST(DepthCamera, NeighboursShareTheirNoise)
{
  const SimulatedScene scene = wallSeenByKinect(2.0, 320);
  const SeenView seen(scene);
  const auto correlation = [&](int rows, int columns) {
    double sum = 0, squares = 0;
    for (int row = 4; row < scene.rig.height - 30; ++row)
      for (int column = 4; column < scene.rig.width - 30; ++column) {
        const double error = seen.error(row, column);
        sum += error * seen.error(row + rows, column + columns);
        squares += error * error;
      }
    return sum / squares;
  };
  EXPECT_GT(correlation(0, 1), 0.7);
  EXPECT_GT(correlation(1, 0), 0.7);
  EXPECT_GT(correlation(0, 1), correlation(0, 4) + 0.2);
  EXPECT_LT(std::abs(correlation(0, 20)), 0.15);
  EXPECT_LT(std::abs(correlation(20, 0)), 0.15);
}

TEST(DepthCamera, NothingIsMeasuredInTheShadowOfTheForeground)
{
  for (const double side : {1.0, -1.0}) { // projector on the right, on the left
    SimulatedScene scene = boardBeforeAWall();
    scene.rig.baseline_horizontal *= side;
    const SeenView seen(scene);
    const int first_column = 122, last_column = 197; // of the board
    ASSERT_EQ(seen.image.surface[seen.indexOf(100, first_column)], 1);
    ASSERT_EQ(seen.image.surface[seen.indexOf(100, first_column - 1)], 0);
    ASSERT_EQ(seen.image.surface[seen.indexOf(100, last_column)], 1);
    ASSERT_EQ(seen.image.surface[seen.indexOf(100, last_column + 1)], 0);
    // 575 px * 7.5 cm * (1 / 1.5 m - 1 / 3 m) = 14.4 px, minus what the matching window
    // bridges
    const auto missing = [&](int first, int last) {
      int count = 0;
      for (int row = 20; row < 220; ++row)
        for (int column = first; column <= last; ++column)
          count += std::isnan(seen.at(row, column).z);
      return count / 200.0;
    };
    const double left = missing(first_column - 20, first_column - 1);
    const double right = missing(last_column + 1, last_column + 20);
    EXPECT_NEAR(side > 0 ? left : right, 12.0, 3.0);
    EXPECT_LT(side > 0 ? right : left, 3.0);
    EXPECT_EQ(missing(first_column - 10, first_column - 6), side > 0 ? 5.0 : 0.0);
    EXPECT_EQ(missing(last_column + 6, last_column + 10), side > 0 ? 0.0 : 5.0);
  }
}

TEST(DepthCamera, ForegroundIsFattened)
{
  const SimulatedScene scene = boardBeforeAWall();
  const SeenView seen(scene);
  std::size_t fat = 0;
  for (int row = 0; row < scene.rig.height; ++row)
    for (int column = 0; column < scene.rig.width; ++column) {
      const ObservationPixel& pixel = seen.at(row, column);
      if (!std::isfinite(pixel.z))
        continue;
      // the label belongs to the measured surface, not to the one seen by the pixel
      EXPECT_EQ(pixel.label, pixel.z < 2.0f ? 2u : 1u);
      if (seen.image.surface[seen.indexOf(row, column)] == 0 && pixel.z < 2.0f) {
        ++fat;
        EXPECT_GE(column, 122 - 4);
        EXPECT_LE(column, 197 + 4);
      }
    }
  EXPECT_GT(fat, 100u);
}

TEST(DepthCamera, NarrowThingsAreLost)
{
  SimulatedScene scene = wallSeenByKinect(3.0, 320);
  scene.rig.baseline_horizontal = 0.001; // hardly any shadow
  scene.rig.disparity_sigma = 0.0;
  scene.depth_camera->disparity_step = 0.001;
  scene.geometry.addRectangle( // 3 px wide
      "wire",
      "wire",
      {{-0.004, 1, 1.5}, {0.008, 0, 0}, {0, -2, 0}},
      {});
  const SeenView seen(scene);
  ASSERT_EQ(seen.image.surface[seen.indexOf(100, 160)], 1);
  for (int row = 0; row < scene.rig.height; ++row)
    for (int column = 0; column < scene.rig.width - 8; ++column)
      ASSERT_GT(seen.at(row, column).z, 2.9f);
}

TEST(DepthCamera, PlacesBesideJumpsAreMissingByChance)
{
  const SeenView seen(boardBeforeAWall());
  const auto missing = [&](int column) {
    int count = 0;
    for (int row = 0; row < 240; ++row)
      count += std::isnan(seen.at(row, column).z);
    return count / 240.0;
  };
  for (const int column : {197, 198}) {
    EXPECT_GT(missing(column), 0.15) << column;
    EXPECT_LT(missing(column), 0.85) << column;
  }
  EXPECT_EQ(missing(197 - 6), 0.0);
  EXPECT_EQ(missing(198 + 6), 0.0);
}

TEST(DepthCamera, TheRightRimIsBlindButHasColour)
{
  SimulatedScene scene = wallSeenByKinect(2.0);
  const SeenView seen(scene);
  for (int row = 0; row < scene.rig.height; ++row)
    for (int column = 0; column < scene.rig.width; ++column) {
      const ObservationPixel& pixel = seen.at(row, column);
      const bool is_blind = column >= scene.rig.width - 8;
      ASSERT_EQ(std::isnan(pixel.z), is_blind);
      ASSERT_EQ(std::isnan(pixel.x), is_blind);
      ASSERT_EQ(std::isnan(pixel.y), is_blind);
      ASSERT_EQ(pixel.label, is_blind ? 0u : 1u);
      ASSERT_EQ(pixel.rgb, 0x6496c8u);
      ASSERT_TRUE(std::isnan(pixel.sigma));
    }
}

TEST(DepthCamera, MeasuresFromHalfAMetreToEight)
{
  const double all = 152.0 / 160.0; // all columns except the invalid ones at the border
  EXPECT_EQ(SeenView(wallSeenByKinect(0.45)).observation.points, 0u);
  EXPECT_EQ(SeenView(wallSeenByKinect(0.45)).observation.in_reach, 0u);
  EXPECT_NEAR(SeenView(wallSeenByKinect(0.55)).measuredShare(), all, 1e-9);
  EXPECT_NEAR(SeenView(wallSeenByKinect(5.9)).measuredShare(), all, 1e-9);
  EXPECT_NEAR(SeenView(wallSeenByKinect(7.0, 320)).measuredShare(), 0.5, 0.1);
  EXPECT_EQ(SeenView(wallSeenByKinect(8.6)).observation.points, 0u);
}

TEST(DepthCamera, GrazingIncidenceIsNoisyAndThenBlind)
{
  const auto share = [](double degrees) {
    const SeenView seen(slantedWall(degrees));
    return seen.measuredShare() * 48 / 40;
  };
  EXPECT_GT(share(60), 0.99);
  EXPECT_LT(share(80), 0.9);
  EXPECT_GT(share(80), 0.1);
  EXPECT_LT(share(88), 0.01);
  const double facing = spreadOf(disparityErrors(slantedWall(10))).sigma;
  EXPECT_GT(spreadOf(disparityErrors(slantedWall(78))).sigma, 1.5 * facing);
}

TEST(DepthCamera, PointsLieOnThePixelsRays)
{
  const SimulatedScene scene = standardSeenByKinect("office");
  const SimulatedObservation observation = observe(scene, 5, 1);
  for (int row = 0; row < observation.height; row += 7)
    for (int column = 0; column < observation.width; column += 7) {
      const ObservationPixel& pixel =
          observation
              .pixels[static_cast<std::size_t>(row * observation.width + column)];
      if (std::isnan(pixel.z))
        continue;
      EXPECT_NEAR(pixel.x / pixel.z * 575.0 + 319.5, column, 1e-3);
      EXPECT_NEAR(pixel.y / pixel.z * 575.0 + 239.5, row, 1e-3);
    }
}

TEST(DepthCamera, ThreadsAndRepetitionGiveTheSameBytes)
{
  SimulatedScene scene = standardScene("office");
  useSmallKinect(scene);
  const auto bytes = [&](unsigned threads, std::size_t view, std::uint64_t seed) {
    const PCLPointCloud2 cloud =
        cloudOf(withThreads(threads, [&] { return observe(scene, view, seed); }));
    return std::string(cloud.data.begin(), cloud.data.end());
  };
  const std::string once = bytes(1, 2, 1);
  for (const unsigned threads : {1u, 2u, 8u})
    EXPECT_TRUE(bytes(threads, 2, 1) == once) << threads;
  EXPECT_FALSE(bytes(1, 2, 2) == once);
  EXPECT_FALSE(bytes(1, 3, 1) == once);
}

TEST(DepthCamera, CloudsHaveNoSigma)
{
  SimulatedScene scene = standardScene("office");
  useSmallKinect(scene);
  const SimulatedObservation observation = observe(scene, 0, 1);
  const PCLPointCloud2 cloud = cloudOf(observation);
  EXPECT_EQ(cloud.width, 160u);
  EXPECT_EQ(cloud.height, 120u);
  std::string names;
  for (const PCLPointField& field : cloud.fields)
    names += field.name + " ";
  EXPECT_EQ(names, "x y z rgb label ");
  ASSERT_EQ(cloud.data.size(), observation.pixels.size() * cloud.point_step);
  const auto valueAt = [&](std::size_t pixel, std::size_t field, auto value) {
    std::memcpy(&value,
                &cloud.data[pixel * cloud.point_step + cloud.fields[field].offset],
                sizeof(value));
    return value;
  };
  for (std::size_t i = 0; i < observation.pixels.size(); ++i) {
    const ObservationPixel& pixel = observation.pixels[i];
    if (std::isfinite(pixel.z)) {
      ASSERT_EQ(valueAt(i, 0, 0.0f), pixel.x);
      ASSERT_EQ(valueAt(i, 2, 0.0f), pixel.z);
    }
    ASSERT_EQ(valueAt(i, 3, 0u), pixel.rgb);
    ASSERT_EQ(valueAt(i, 4, 0u), pixel.label);
  }
}

TEST(DepthCamera, ViewsAreMergedAsThoseOfOtherSensors)
{
  SimulatedScene scene = standardScene("office");
  useSmallKinect(scene);
  scene.views.resize(3);
  const MergedObservations merged = mergeObservations(scene, 0, 1);
  std::size_t points = 0;
  for (std::size_t view = 0; view < 3; ++view)
    points += observe(scene, view, 1).points;
  ASSERT_EQ(merged.points.size(), points);
  std::size_t near = 0, labelled = 0;
  for (std::size_t i = 0; i < points; ++i)
    if (merged.label[i] > 0) {
      const Eigen::Vector4d& plane = merged.planes[merged.label[i] - 1].coefficients;
      ++labelled;
      near += std::abs(plane.head<3>().dot(merged.points[i].cast<double>()) +
                       plane[3]) < 0.1;
    }
  EXPECT_GT(labelled, 30000u);
  EXPECT_GT(static_cast<double>(near), 0.99 * static_cast<double>(labelled));
}

TEST(DepthCamera, ImagesWithoutSurfacesAndOfOnePixelAreLegal)
{
  SimulatedScene scene = wallSeenByKinect(2.0);
  scene.geometry = SceneGeometry();
  EXPECT_EQ(observe(scene, 0, 1).points, 0u);
  scene = wallSeenByKinect(2.0);
  scene.rig.width = scene.rig.height = 1;
  scene.rig.center_x = scene.rig.center_y = 0;
  scene.depth_camera->blind_columns = 0;
  EXPECT_EQ(observe(scene, 0, 1).points, 1u);
}

TEST(DepthCamera, UglySettingsAreRefused)
{
  const auto refused = [](const std::string& word, const auto& spoil) {
    SimulatedScene scene = wallSeenByKinect(2.0);
    spoil(scene);
    EXPECT_THAT([&] { observe(scene, 0, 1); },
                testing::ThrowsMessage<BadArgumentException>(testing::HasSubstr(word)))
        << word << " was taken";
  };
  const double nan = std::nan("");
  for (const int window : {-9, 0, 4, 103})
    refused("window", [=](SimulatedScene& s) { s.depth_camera->window = window; });
  for (const double step : {-0.125, 0.0, 11.0, nan})
    refused("disparity_step",
            [=](SimulatedScene& s) { s.depth_camera->disparity_step = step; });
  for (const double step : {-0.001, 0.0, 2.0, nan})
    refused("depth_step",
            [=](SimulatedScene& s) { s.depth_camera->depth_step = step; });
  for (const int columns : {-1, 161})
    refused("blind_columns",
            [=](SimulatedScene& s) { s.depth_camera->blind_columns = columns; });
  for (const double depth : {-1.0, 0.0, nan, infinity})
    refused("nearest", [=](SimulatedScene& s) { s.depth_camera->nearest = depth; });
  for (const double depth : {0.4, nan, infinity})
    refused("farthest", [=](SimulatedScene& s) { s.depth_camera->farthest = depth; });
  for (const double depth : {0.4, 8.1, nan})
    refused("fading", [=](SimulatedScene& s) { s.depth_camera->fading = depth; });
  for (const double baseline : {0.0, 20.0, nan})
    refused("baseline_horizontal",
            [=](SimulatedScene& s) { s.rig.baseline_horizontal = baseline; });
  refused("disparity_sigma", [](SimulatedScene& s) { s.rig.disparity_sigma = -1; });
}

} // namespace
} // namespace pcl::acmap::test
