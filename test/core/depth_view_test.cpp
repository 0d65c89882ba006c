#include "depth_room.h"

#include <pcl/core/impl/depth_view.h>
#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

PointView
viewOf(const std::vector<Eigen::Vector3f>& points)
{
  return {points.data(), sizeof points[0], points.size()};
}

TEST(DepthView, recognizesItsCamera)
{
  const DepthRoom room({});
  const auto view = DepthView::recognize(viewOf(room.points), DepthRoom::width);
  ASSERT_TRUE(view);
  EXPECT_EQ(view->height(), DepthRoom::height);
  EXPECT_EQ(view->measured(), room.points.size());
  EXPECT_NEAR(view->focal().x(), DepthRoom::focal, 0.01);
  EXPECT_NEAR(view->focal().y(), DepthRoom::focal, 0.01);
  for (const std::size_t pixel : {0u, 12345u, 76799u}) {
    const Eigen::Vector3d ray =
        view->ray(static_cast<double>(pixel % DepthRoom::width),
                  static_cast<double>(pixel / DepthRoom::width));
    const Eigen::Vector3d point = room.points[pixel].cast<double>();
    EXPECT_LT((ray - point / point.z()).norm(), 1e-5);
    EXPECT_NEAR(view->inverseDepth(pixel) * point.z(), 1, 1e-6);
  }
}

TEST(DepthView, recognizesAMirroredAxis)
{
  DepthRoom room({});
  for (Eigen::Vector3f& point : room.points)
    point.x() = -point.x();
  const auto view = DepthView::recognize(viewOf(room.points), DepthRoom::width);
  ASSERT_TRUE(view);
  EXPECT_NEAR(view->focal().x(), -DepthRoom::focal, 0.01);
}

TEST(DepthView, isNoneInAnotherFrameOrWithoutPoints)
{
  DepthRoom room({});
  EXPECT_FALSE(DepthView::recognize(viewOf(room.points), DepthRoom::width - 1));
  EXPECT_FALSE(DepthView::recognize(viewOf(room.points), 0));
  EXPECT_FALSE(DepthView::recognize({}, 640));
  std::vector<Eigen::Vector3f> moved = room.points;
  for (Eigen::Vector3f& point : moved)
    point += Eigen::Vector3f(1, 0.5F, 2);
  EXPECT_FALSE(DepthView::recognize(viewOf(moved), DepthRoom::width));
  const std::vector<Eigen::Vector3f> nothing(
      room.points.size(),
      Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_FALSE(DepthView::recognize(viewOf(nothing), DepthRoom::width));
  const std::vector<Eigen::Vector3f> same(room.points.size(), Eigen::Vector3f(1, 2, 3));
  EXPECT_FALSE(DepthView::recognize(viewOf(same), DepthRoom::width));
}

/** Each pixel gets its position again, for any order of the points. */
TEST(PictureOrder, isFoundAgainWithoutPixelsThatMeasureNothing)
{
  const DepthRoom room({});
  std::vector<std::size_t> kept;
  for (std::size_t pixel = 0; pixel < room.points.size(); ++pixel)
    if (pixel % 3 != 0 || pixel % DepthRoom::width < 20)
      kept.push_back(pixel * 7919 % room.points.size()); // 7919 is prime, so that each
                                                         // pixel occurs once
  std::vector<Eigen::Vector3f> points;
  for (const std::size_t pixel : kept)
    points.push_back(room.points[pixel]);
  points.emplace_back(std::nanf(""), 0, 1);
  const auto order = findPictureOrder(viewOf(points));
  ASSERT_TRUE(order);
  ASSERT_EQ(order->width, DepthRoom::width);
  ASSERT_EQ(order->height, DepthRoom::height);
  for (std::size_t i = 0; i < kept.size(); ++i)
    ASSERT_EQ(order->pixels[i], kept[i]) << i;
  EXPECT_EQ(order->pixels.back(), PictureOrder::nowhere);
  const std::vector<Eigen::Vector3f> arranged = order->arrange(viewOf(points));
  EXPECT_EQ(arranged[kept[5]], points[5]);
  EXPECT_TRUE(DepthView::recognize(viewOf(arranged), order->width));
  PointLabels labels(room.points.size(), 4);
  labels[kept[7]] = 9;
  EXPECT_EQ(order->labelsOfPoints(labels)[7], 9);
  EXPECT_EQ(order->labelsOfPoints(labels).back(), -1);
}

/** A wall that rises to the right, in rows, in columns, and in no order. */
TEST(PictureOrder, ofALargePictureIsFoundInAnyOrder)
{
  constexpr std::size_t width = 900, height = 600, pixels = width * height;
  const auto pointAt = [](std::size_t column, std::size_t row) {
    const float z = 2 + 0.001F * static_cast<float>(column);
    return Eigen::Vector3f(z * (static_cast<float>(column) - 450) / 800,
                           z * (static_cast<float>(row) - 300) / 800,
                           z);
  };
  std::vector<Eigen::Vector3f> in_rows, in_columns, mixed;
  for (std::size_t i = 0; i < pixels; ++i) {
    in_rows.push_back(pointAt(i % width, i / width));
    in_columns.push_back(pointAt(i / height, i % height));
    const std::size_t other = i * 7919 % pixels;
    mixed.push_back(pointAt(other % width, other / width));
  }
  for (const auto* points : {&in_rows, &in_columns, &mixed}) {
    const auto order = findPictureOrder(viewOf(*points));
    ASSERT_TRUE(order);
    EXPECT_EQ(order->width, width);
    EXPECT_EQ(order->height, height);
    EXPECT_EQ(order->arrange(viewOf(*points)), in_rows);
  }
  std::vector<Eigen::Vector3f> scan = in_rows; // of another place, after half a picture
  for (std::size_t i = pixels / 2; i < pixels; ++i)
    scan[i] += Eigen::Vector3f(1, 0.5F, 2);
  EXPECT_FALSE(findPictureOrder(viewOf(scan)));
}

TEST(PictureOrder, isNoneOfOtherClouds)
{
  const DepthRoom room({});
  std::vector<Eigen::Vector3f> moved = room.points, two = room.points;
  for (Eigen::Vector3f& point : moved)
    point += Eigen::Vector3f(0.3F, 0.2F, 0);
  EXPECT_FALSE(findPictureOrder(viewOf(moved)));
  for (const Eigen::Vector3f& point : room.points)
    two.push_back(1.1F * point);
  EXPECT_FALSE(findPictureOrder(viewOf(two))) << "two views";
  EXPECT_FALSE(findPictureOrder({}));
  const std::vector<Eigen::Vector3f> same(5000, Eigen::Vector3f(1, 2, 3));
  EXPECT_FALSE(findPictureOrder(viewOf(same)));
  const std::vector<Eigen::Vector3f> huge(5000, Eigen::Vector3f(1e30F, 1e30F, 1e-30F));
  EXPECT_FALSE(findPictureOrder(viewOf(huge)));
}

TEST(DepthStep, isFoundWhateverItIs)
{
  for (const double step : {0.0007, 0.0029, 0.006}) {
    DepthRoom::Camera camera;
    camera.step = step;
    EXPECT_NEAR(measureDepthStep(viewOf(DepthRoom(camera).points)), step, 0.02 * step);
  }
}

TEST(DepthStep, isFoundInDepthsOfMillimetres)
{
  DepthRoom room({});
  for (Eigen::Vector3f& point : room.points)
    point *= std::round(1000 * point.z()) / 1000 / point.z();
  EXPECT_NEAR(measureDepthStep(viewOf(room.points)), 0.0029, 0.05 * 0.0029);
}

TEST(DepthStep, isNoneWhereDepthIsNotQuantised)
{
  DepthRoom::Camera camera;
  camera.step = 0;
  const DepthRoom room(camera);
  EXPECT_EQ(measureDepthStep(viewOf(room.points)), 0);
  EXPECT_EQ(measureDepthStep({}), 0);
  // regular in depth, not in inverse depth: a file in centimetres, a lattice
  std::vector<Eigen::Vector3f> lattice;
  for (const Eigen::Vector3f& point : room.points)
    lattice.push_back({point.x(), point.y(), std::round(100 * point.z()) / 100});
  EXPECT_EQ(measureDepthStep(viewOf(lattice)), 0);
  // even in both: heights of a survey
  for (Eigen::Vector3f& point : lattice)
    point.z() += 200;
  EXPECT_EQ(measureDepthStep(viewOf(lattice)), 0);
}

TEST(InverseDepthNoise, tellsWhatNeighboursShareFromWhatIsAPixelsOwn)
{
  for (const auto& [independent, correlated] :
       {std::pair(2e-3, 0.0), std::pair(3e-4, 1.5e-3), std::pair(1e-3, 1e-3)}) {
    DepthRoom::Camera camera;
    camera.step = 0;
    camera.independent = independent;
    camera.correlated = correlated;
    const DepthRoom room(camera);
    const auto view = DepthView::recognize(viewOf(room.points), DepthRoom::width);
    ASSERT_TRUE(view);
    const NoiseScale::InverseDepth noise = measureInverseDepthNoise(*view, 0);
    const double sigma = std::hypot(independent, correlated);
    EXPECT_NEAR(noise.sigma(), sigma, 0.2 * sigma);
    // smoothed noise also varies inside the smallest tiles
    EXPECT_GT(noise.independent, 0.8 * independent);
    EXPECT_LT(noise.independent, std::hypot(independent, 0.5 * correlated));
  }
}

NoiseScale::InverseDepth
noiseOf(const DepthRoom& room, double step)
{
  const auto view = DepthView::recognize(viewOf(room.points), DepthRoom::width);
  return view ? measureInverseDepthNoise(*view, step) : NoiseScale::InverseDepth();
}

TEST(InverseDepthNoise, isMeasuredByDepthOnlyWhereItIsAPixelsOwn)
{
  DepthRoom::Camera camera;
  camera.step = 0;
  camera.independent = 2e-3;
  camera.correlated = 0;
  const NoiseScale::InverseDepth noise = noiseOf(DepthRoom(camera), 0);
  ASSERT_TRUE(noise.isIndependent());
  double before = 0;
  for (const NoiseScale::InverseDepth::AtDepth& at : noise.by_depth) {
    EXPECT_GT(at.inverse_depth, before);
    EXPECT_NEAR(at.sigma, camera.independent, 0.15 * camera.independent);
    before = at.inverse_depth;
  }
  camera.independent = camera.correlated = 1e-3;
  EXPECT_FALSE(noiseOf(DepthRoom(camera), 0).isIndependent());
  camera.independent = camera.correlated = 0; // only the rounding of floats
  EXPECT_FALSE(noiseOf(DepthRoom(camera), 0).isIndependent());
  EXPECT_FALSE(noiseOf(DepthRoom({}), DepthRoom::Camera().step).isIndependent());
  camera.independent = 0.1; // no surface
  EXPECT_FALSE(noiseOf(DepthRoom(camera), 0).isIndependent());
}

TEST(InverseDepthNoise, ofPixelsMayBeUniformInMetres)
{
  constexpr double sigma = 0.01; // metres
  DepthRoom::Camera camera;
  camera.step = camera.independent = camera.correlated = 0;
  DepthRoom room(camera);
  Random random(3);
  for (Eigen::Vector3f& point : room.points) {
    const double depth = static_cast<double>(point.z());
    point *= static_cast<float>(1 + sigma * random.normal() / depth);
  }
  const NoiseScale::InverseDepth noise = noiseOf(room, 0);
  ASSERT_TRUE(noise.isIndependent());
  for (const NoiseScale::InverseDepth::AtDepth& at : noise.by_depth)
    EXPECT_NEAR(at.sigma / at.inverse_depth / at.inverse_depth, sigma, 0.15 * sigma);
}

TEST(InverseDepthNoise, isNotBelowTheRounding)
{
  DepthRoom::Camera camera;
  camera.independent = camera.correlated = 0;
  const DepthRoom room(camera);
  const auto view = DepthView::recognize(viewOf(room.points), DepthRoom::width);
  ASSERT_TRUE(view);
  const NoiseScale::InverseDepth noise = measureInverseDepthNoise(*view, camera.step);
  EXPECT_GE(noise.independent, camera.step / std::sqrt(12.0));
  EXPECT_LT(noise.sigma(), 0.5 * camera.step);
}

TEST(NoiseScale, ofQuantisedDepthIsThatOfItsSteps)
{
  const DepthRoom room({});
  const SensorView sensor{Eigen::Vector3f(0, 0, 0)};
  for (const std::size_t width : {DepthRoom::width, std::size_t{0}}) {
    const NoiseScale scale = measureNoiseScale(viewOf(room.points), sensor, 0, width);
    ASSERT_TRUE(scale.inverse_depth);
    EXPECT_NEAR(scale.inverse_depth->step, 0.0029, 1e-4);
    // at most two quantization steps: at 3 m a step is 26 mm
    EXPECT_GT(scale.sigma, 0.0029 * 4 / std::sqrt(12.0));
    EXPECT_LT(scale.sigma, 0.0029 * 16);
    ASSERT_GT(scale.ranges.size(), 2u);
    for (const NoiseScale::Range& range : scale.ranges)
      EXPECT_NEAR(range.sigma,
                  scale.inverse_depth->sigma() * range.distance * range.distance,
                  1e-9);
  }
  DepthRoom::Camera smooth;
  smooth.step = 0;
  EXPECT_FALSE(
      measureNoiseScale(viewOf(DepthRoom(smooth).points), sensor, 0, DepthRoom::width)
          .inverse_depth);
}

} // namespace
} // namespace pcl::acmap::test
