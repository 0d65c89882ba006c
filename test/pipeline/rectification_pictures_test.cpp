#include "pictures/drawing.h"

#include <pcl/core/random.h>
#include <pcl/pipeline/plan_picture.h>
#include <pcl/pipeline/rectification_pictures.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

Color
colorAt(const RgbImage& image, int column, int row)
{
  const std::uint8_t* const pixel = image.at(column, row);
  return {pixel[0], pixel[1], pixel[2]};
}

std::size_t
countOf(const RgbImage& image, const Color& color)
{
  std::size_t count = 0;
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      count += colorAt(image, column, row) == color ? 1 : 0;
  return count;
}

/** A rectangle of points, 10 m by 5 m, with an outlier far away. */
PlanContents
floorContents()
{
  PlanContents contents;
  for (int i = 0; i <= 100; ++i)
    for (int k = 0; k <= 50; ++k)
      contents.addPoint({0.1 * i, 7, 100 + 0.1 * k});
  contents.addPoint({1e9, 0, -1e9});
  contents.addPoint({std::numeric_limits<double>::quiet_NaN(), 0, 0});
  return contents;
}

TEST(PlanExtent, HoldsThePointsButStraysAndAllPlaces)
{
  const PlanExtent extent = floorContents().extent();
  EXPECT_NEAR(extent.pixel * extent.width, 10, 1);
  EXPECT_NEAR(extent.pixel * extent.height, 5, 1);
  EXPECT_LE(extent.minimum.x(), 0);
  EXPECT_LE(extent.minimum.y(), 100);
  PlanContents with_place = floorContents();
  with_place.addPlace({5, 0, 80});
  const PlanExtent higher = with_place.extent();
  EXPECT_LT(higher.minimum.y(), 80);
  EXPECT_NEAR(higher.pixel * higher.height, 25, 1.5);
}

TEST(PlanExtent, OfNothingOrOnePointCanBeDrawn)
{
  PlanContents contents;
  contents.addPlace({1e300, 0, 0});
  contents.addPoint({0, 0, -1e300});
  contents.addPlace({0, 0, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_GT(PlanPicture(contents.extent()).draw({}, channelsOf(red)).width, 0);
  contents.addPlace({1, 2, 3});
  const PlanExtent extent = contents.extent();
  PlanPicture plan(extent);
  plan.add({1, 2, 3});
  const RgbImage image = plan.draw({Eigen::Isometry3d::Identity()}, channelsOf(blue));
  EXPECT_EQ(image.width, extent.width);
  EXPECT_GT(image.width * image.height, 0);
}

TEST(PlanPicture, ShowsXToTheRightAndZUpwards)
{
  const PlanExtent extent = floorContents().extent();
  PlanPicture plan(extent);
  plan.add({2.5, 0, 104}); // left of the centre, above it
  plan.add({std::numeric_limits<double>::quiet_NaN(), 0, 104});
  plan.add({1e9, 0, 104});
  const RgbImage image = plan.draw({}, channelsOf(red));
  int dark = 0;
  for (int row = 0; row < image.height / 2; ++row)
    for (int column = 0; column < image.width; ++column)
      if (colorAt(image, column, row) != Color{255, 255, 255}) {
        ++dark;
        EXPECT_NEAR(
            extent.minimum.x() + (column + 0.5) * extent.pixel, 2.5, extent.pixel);
        EXPECT_NEAR(extent.minimum.y() + (image.height - row - 0.5) * extent.pixel,
                    104,
                    2 * extent.pixel);
      }
  EXPECT_EQ(dark, 1);
}

TEST(PlanPicture, MorePointsAreDarkerAndTheWayIsALine)
{
  const PlanExtent extent = floorContents().extent();
  PlanPicture plan(extent);
  for (int i = 0; i < 100; ++i)
    plan.add({2, 0, 104});
  for (int i = 0; i < 10; ++i)
    plan.add({5, 0, 104});
  const RgbImage image = plan.draw({}, channelsOf(red));
  const auto level = [&](double x) {
    int minimum = 255;
    const auto column = static_cast<int>((x - extent.minimum.x()) / extent.pixel);
    for (int row = 0; row < image.height / 2; ++row)
      minimum = std::min<int>(minimum, colorAt(image, column, row)[0]);
    return minimum;
  };
  EXPECT_EQ(level(2), 0);
  EXPECT_GT(level(5), 30);
  EXPECT_LT(level(5), 240);
  std::vector<Eigen::Isometry3d> poses(2, Eigen::Isometry3d::Identity());
  poses[0].translation() << 1, 0, 101;
  poses[1].translation() << 9, 0, 101;
  EXPECT_GT(countOf(plan.draw(poses, channelsOf(blue)), blue), 8 / extent.pixel);
}

TEST(PlanPicture, TwoStandBesideEachOther)
{
  PlanPicture plan(floorContents().extent());
  plan.add({5, 0, 104});
  const RgbImage image = plan.draw({}, channelsOf(red));
  const RgbImage both = beside(image, image);
  ASSERT_EQ(both.height, image.height);
  ASSERT_GT(both.width, 2 * image.width);
  const int shift = both.width - image.width;
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      ASSERT_EQ(colorAt(both, column, row), colorAt(image, column, row));
      ASSERT_EQ(colorAt(both, column + shift, row), colorAt(image, column, row));
    }
}

std::vector<RectificationStep>
descent(const std::string& search, double from, int count)
{
  std::vector<RectificationStep> steps;
  for (int i = 0; i < count; ++i) {
    RectificationStep step;
    step.search = search;
    step.bin_size = i < count / 2 ? 0.4 : 0.1;
    step.energy = from + std::exp(-0.1 * i);
    steps.push_back(step);
  }
  return steps;
}

TEST(RectificationPictures, ShowTheSamePartBeforeAndAfter)
{
  const PointCloud<PointNormal>::Ptr wall(new PointCloud<PointNormal>);
  for (int i = 0; i <= 100; ++i) {
    PointNormal point;
    point.getVector3fMap() << 0.04F * static_cast<float>(i), 0, 3;
    wall->push_back(point);
  }
  std::vector<Eigen::Isometry3d> before(2, Eigen::Isometry3d::Identity());
  std::vector<Eigen::Isometry3d> after = before;
  before[1].translation() << 0, 0, 1;
  const Eigen::Vector3d up = -Eigen::Vector3d::UnitY();
  const RectificationPictures pictures =
      drawRectification({wall, wall}, before, after, up, descent("wide", 10, 8));
  const auto darkRows = [](const RgbImage& image) {
    int rows = 0;
    for (int row = 0; row < image.height - 40; ++row)
      rows += colorAt(image, image.width / 2, row)[0] < 128 ? 1 : 0;
    return rows;
  };
  EXPECT_EQ(darkRows(pictures.plan_before), 2) << "two walls";
  EXPECT_EQ(darkRows(pictures.plan_after), 1);
  EXPECT_EQ(pictures.plan_before.width, pictures.plan_after.width);
  EXPECT_GT(countOf(pictures.plan_before, red), 20U);
  EXPECT_GT(countOf(pictures.plan_after, blue), 20U);
  EXPECT_GT(countOf(pictures.energy, blue), 20U);
  EXPECT_THROW(drawRectification({wall}, before, after, up, {}), BadArgumentException);
  EXPECT_GT(drawRectification({}, {}, {}, up, {}).plan.width, 0);
}

TEST(Drawing, LinesThatLeaveThePictureAreCut)
{
  RgbImage image{20, 10, std::vector<std::uint8_t>(600, 255)};
  cv::Mat3b matrix = matOf(image);
  drawLine(matrix, {-1e6, 5}, {1e6, 5}, 1, red);
  EXPECT_EQ(countOf(image, red), 20U);
  drawLine(matrix, {5, std::numeric_limits<double>::infinity()}, {5, 0}, 1, blue);
  drawLine(matrix, {-50, -50}, {-60, 300}, 3, blue);
  drawLine(matrix, {50, -50}, {60, 300}, 3, blue);
  drawDot(matrix, {1e300, 5}, 3, blue);
  drawText(matrix, {-3, -12}, "left", blue);
  EXPECT_EQ(countOf(image, red), 20U);
  drawLine(matrix, {3, 1e300}, {3, -1e300}, 2, blue);
  EXPECT_GE(countOf(image, blue), 20U);
  drawText(matrix, {18, 8}, "right", black);
  EXPECT_LE(countOf(image, black), 4U);
}

TEST(Drawing, RoundLengthsAreOneTwoOrFive)
{
  for (const auto& [maximum, length] :
       {std::pair{1.0, 1.0}, {1.99, 1.0}, {2.0, 2.0}, {49.0, 20.0}, {0.07, 0.05}})
    EXPECT_NEAR(roundLength(maximum), length, 1e-12 * length) << maximum;
}

TEST(EnergyPicture, HasAColourForEachSearch)
{
  std::vector<RectificationStep> steps = descent("wide", 10, 80);
  const std::size_t blue_of_one = countOf(energyPicture(steps), blue);
  EXPECT_GT(blue_of_one, 300U);
  EXPECT_EQ(countOf(energyPicture(steps), red), 0U);
  const std::vector<RectificationStep> more = descent("fine", 10.5, 80);
  steps.insert(steps.end(), more.begin(), more.end());
  EXPECT_GT(countOf(energyPicture(steps), red), 200U);
}

TEST(EnergyPicture, OfWildEnergiesCanBeDrawn)
{
  const RgbImage none = energyPicture({});
  EXPECT_GT(countOf(none, black), 100U);
  std::vector<RectificationStep> steps = descent("s", 10, 80);
  const std::size_t blue_before = countOf(energyPicture(steps), blue);
  steps[20].energy = 1e300; // outside of the picture; the others remain visible
  steps[60].energy = std::numeric_limits<double>::quiet_NaN();
  EXPECT_GT(countOf(energyPicture(steps), blue), blue_before / 2);
  for (RectificationStep& step : steps)
    step.energy = std::numeric_limits<double>::infinity();
  EXPECT_EQ(energyPicture(steps).width, none.width);
}

/** Adds a search with one bin size and the given energies. */
void
addSearch(std::vector<RectificationStep>& steps,
          const std::string& name,
          double size,
          const std::vector<double>& energies)
{
  for (const double energy : energies) {
    RectificationStep step;
    step.search = name;
    step.bin_size = size;
    step.energy = energy;
    steps.push_back(step);
  }
}

/** Rows and columns of the pixels in which a color dominates, below the names of the
 * searches. */
struct Place {
  int highest_row = std::numeric_limits<int>::max();
  int lines = 0; // ranges of columns, with gaps between them
};

/** \param[in] channel that is much brighter than the other two: 0 red, 2 blue */
Place
placeOf(const RgbImage& image, int channel)
{
  constexpr int first_row = 25, minimum_difference = 60;
  Place place;
  int last_column = -1000;
  for (int column = 0; column < image.width; ++column)
    for (int row = first_row; row < image.height; ++row) {
      const Color color = colorAt(image, column, row);
      if (color[channel] - color[(channel + 1) % 3] < minimum_difference ||
          color[channel] - color[(channel + 2) % 3] < minimum_difference)
        continue;
      place.highest_row = std::min(place.highest_row, row);
      place.lines += column > last_column + 10 ? 1 : 0;
      last_column = column;
    }
  return place;
}

TEST(EnergyPicture, BreaksTheLineWhereEnergiesAreNotComparable)
{
  std::vector<RectificationStep> steps;
  addSearch(steps, "wide", 0.4, {10, 9, 8});
  addSearch(steps, "wide", 0.1, {5, 4});
  addSearch(steps, "fine", 0.1, {7, 6.5});
  EXPECT_EQ(placeOf(energyPicture(steps), 2).lines, 2); // blue
  EXPECT_EQ(placeOf(energyPicture(steps), 0).lines, 1); // red
}

TEST(EnergyPicture, OnlyAFewOfManyLeaveIt)
{
  std::vector<RectificationStep> few;
  addSearch(few, "high", 0.1, {9, 1});
  addSearch(few, "low", 0.1, {5, 4});
  std::vector<RectificationStep> many = few;
  for (int i = 0; i < 100; ++i)
    addSearch(many, "low" + std::to_string(i), 0.1, {5, 4});
  // With few steps, all are in the picture, the first of "low" at an eighth of it.
  EXPECT_LT(placeOf(energyPicture(few), 2).highest_row, 100);
  EXPECT_GT(placeOf(energyPicture(few), 0).highest_row, 400);
  EXPECT_LT(placeOf(energyPicture(many), 0).highest_row, 100);
}

TEST(EnergyPicture, OfInfiniteEnergiesAndOfOneStepCanBeDrawn)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<RectificationStep> wild, one;
  addSearch(wild, "a", 0.1, {5, 4, 1e300, 3, std::nan(""), -infinity, 2, 1e90, 1});
  EXPECT_GT(countOf(energyPicture(wild), blue), 0U);
  addSearch(one, "a", 0.1, {5});
  EXPECT_EQ(placeOf(energyPicture(one), 2).lines, 1);
}

} // namespace
} // namespace pcl::acmap::test
