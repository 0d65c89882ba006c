#include "small_scenes.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/standard_scenes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace pcl::acmap::test {
namespace {

bool
sameBytes(const SimulatedObservation& a, const SimulatedObservation& b)
{
  return a.pixels.size() == b.pixels.size() &&
         std::memcmp(a.pixels.data(),
                     b.pixels.data(),
                     a.pixels.size() * sizeof(ObservationPixel)) == 0;
}

Eigen::Vector3d
pointOf(const ObservationPixel& pixel)
{
  return {pixel.x, pixel.y, pixel.z};
}

TEST(Observation, HasExactlyItsPoints)
{
  const SimulatedScene scene = smallScene("corridor");
  for (const std::size_t view : {0u, 1u, 50u, 105u}) {
    const SimulatedObservation observation = observe(scene, view, 1);
    const auto finite =
        std::count_if(observation.pixels.begin(),
                      observation.pixels.end(),
                      [](const auto& pixel) { return std::isfinite(pixel.x); });
    EXPECT_EQ(static_cast<std::size_t>(finite), scene.sensor.pointsOfView(view));
    EXPECT_EQ(observation.points, scene.sensor.pointsOfView(view));
    EXPECT_GT(observation.in_reach, observation.points);
  }
}

TEST(Observation, TakesAllWhereFewSeeAnything)
{
  SimulatedScene scene = wallAt(2.0);
  scene.sensor.points = 1000000;
  const SimulatedObservation observation = observe(scene, 0, 1);
  EXPECT_EQ(observation.points, observation.pixels.size());
  EXPECT_EQ(observation.in_reach, observation.pixels.size());
  scene.sensor.reach = 1.0;
  EXPECT_EQ(observe(scene, 0, 1).points, 0u);
}

TEST(Observation, EveryPixelHasAColourOfItsSurface)
{
  const SimulatedScene scene = smallScene("corridor");
  const SurfaceImage image = castView(scene.geometry, scene.rig, scene.views[20]);
  const SimulatedObservation observation = observe(scene, image, 20, 1);
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < observation.pixels.size(); ++i) {
    const auto& surface =
        scene.geometry.surfaces()[static_cast<std::size_t>(image.surface[i])];
    const double red = (observation.pixels[i].rgb >> 16) & 0xff;
    const double grain = (red - surface.look.color[0]) / surface.look.texture;
    EXPECT_LT(std::abs(grain), 5.0);
    sum += grain;
    squares += grain * grain;
  }
  const auto count = static_cast<double>(observation.pixels.size());
  EXPECT_NEAR(sum / count, 0.0, 0.2);
  EXPECT_NEAR(std::sqrt(squares / count), 1.0, 0.15);
}

TEST(Observation, WithoutNoisePointsLieOnTheirPlanes)
{
  SimulatedScene scene = smallScene("office");
  scene.sensor.min_noise = scene.sensor.max_noise = 0.0;
  std::size_t labelled = 0;
  for (std::size_t view = 0; view < scene.views.size(); view += 7)
    for (const ObservationPixel& pixel : observe(scene, view, 1).pixels)
      if (pixel.label > 0) {
        const Eigen::Vector3d point = scene.views[view] * pointOf(pixel);
        const auto& plane = scene.geometry.planes()[pixel.label - 1].coefficients;
        EXPECT_LT(std::abs(plane.head<3>().dot(point) + plane[3]), 1e-6);
        ++labelled;
      }
  EXPECT_GT(labelled, 5000u);
}

TEST(Observation, NoiseMovesPointsAlongTheirRaysOnly)
{
  const SimulatedScene scene = smallScene("corridor");
  const SurfaceImage image = castView(scene.geometry, scene.rig, scene.views[4]);
  const SimulatedObservation observation = observe(scene, image, 4, 1);
  for (std::size_t i = 0; i < observation.pixels.size(); ++i) {
    const ObservationPixel& pixel = observation.pixels[i];
    if (!std::isfinite(pixel.x))
      continue;
    const auto column = static_cast<int>(i) % scene.rig.width;
    const auto row = static_cast<int>(i) / scene.rig.width;
    const Eigen::Vector3d ray = pixelRay(scene.rig, column, row);
    EXPECT_LT(pointOf(pixel).cross(ray).norm(), 1e-6);
    EXPECT_FLOAT_EQ(
        pixel.sigma,
        static_cast<float>(scene.sensor.sigma(image.distance[i] * ray.z())));
    EXPECT_LT(std::abs(pointOf(pixel).norm() - image.distance[i]), 6 * pixel.sigma);
  }
}

TEST(Observation, NoiseHasItsStandardDeviationAtEveryDepth)
{
  for (const double depth : {0.5, 1.5, 2.0, 2.5, 3.0, 4.0, 6.0}) {
    const SimulatedScene scene = wallAt(depth);
    const double expected = std::min(std::max(0.0025 * depth * depth, 0.01), 0.03);
    const SurfaceImage image = castView(scene.geometry, scene.rig, scene.views[0]);
    double sum = 0, squares = 0, count = 0;
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      const SimulatedObservation observation = observe(scene, image, 0, seed);
      for (std::size_t i = 0; i < observation.pixels.size(); ++i)
        if (std::isfinite(observation.pixels[i].x)) {
          const double error =
              pointOf(observation.pixels[i]).norm() - image.distance[i];
          sum += error;
          squares += error * error;
          ++count;
        }
    }
    EXPECT_NEAR(std::sqrt(squares / count), expected, 0.03 * expected) << depth;
    EXPECT_NEAR(sum / count, 0.0, 4.0 * expected / std::sqrt(count)) << depth;
  }
}

TEST(Observation, MeasuredPixelsAreSpreadEvenly)
{
  const SimulatedScene scene = wallAt(2.0);
  const SimulatedObservation observation = observe(scene, 0, 1);
  const int columns = 8, rows = 6;
  std::vector<int> measured(columns * rows), all(columns * rows);
  for (int row = 0; row < observation.height; ++row)
    for (int column = 0; column < observation.width; ++column) {
      const int cell = row * rows / observation.height * columns +
                       column * columns / observation.width;
      const auto i = static_cast<std::size_t>(row * observation.width + column);
      measured[static_cast<std::size_t>(cell)] +=
          std::isfinite(observation.pixels[i].x) ? 1 : 0;
      ++all[static_cast<std::size_t>(cell)];
    }
  for (std::size_t cell = 0; cell < all.size(); ++cell)
    EXPECT_NEAR(measured[cell], 0.5 * all[cell], 5 * 0.5 * std::sqrt(all[cell]));
}

TEST(Observation, ThreadsAndRepetitionGiveTheSameBytes)
{
  const SimulatedScene scene = smallScene("office", 320);
  const auto run = [&](unsigned threads, std::size_t view, std::uint64_t seed) {
    return withThreads(threads, [&] { return observe(scene, view, seed); });
  };
  const SimulatedObservation once = run(1, 2, 1);
  for (const unsigned threads : {1u, 2u, 8u})
    EXPECT_TRUE(sameBytes(run(threads, 2, 1), once));
  EXPECT_FALSE(sameBytes(run(1, 2, 2), once));
  EXPECT_FALSE(sameBytes(run(1, 3, 1), once));
}

TEST(Observation, ImagesOfOtherViewsAreRefused)
{
  const SimulatedScene scene = smallScene("office");
  EXPECT_THROW(observe(scene, scene.views.size(), 1), BadArgumentException);
  EXPECT_THROW(observe(scene, SurfaceImage{}, 0, 1), BadArgumentException);
}

TEST(Observation, IsAnOrganizedCloud)
{
  const SimulatedScene scene = smallScene("corridor");
  const SimulatedObservation observation = observe(scene, 0, 1);
  const PCLPointCloud2 cloud = cloudOf(observation);
  EXPECT_EQ(cloud.width, 80u);
  EXPECT_EQ(cloud.height, 60u);
  EXPECT_EQ(cloud.is_dense, 0);
  std::string names;
  for (const PCLPointField& field : cloud.fields)
    names += field.name + " ";
  EXPECT_EQ(names, "x y z rgb sigma label ");
  EXPECT_EQ(
      std::memcmp(cloud.data.data(), observation.pixels.data(), cloud.data.size()), 0);
}

} // namespace
} // namespace pcl::acmap::test
