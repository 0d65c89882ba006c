#include <pcl/core/box_sides.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace pcl::acmap::test {
namespace {

BoxPatch
makeBox()
{
  BoxPatch box;
  box.center = {1, 2, 3};
  box.axes = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 2) / 3).toRotationMatrix();
  box.size = {3, 2, 1};
  return box;
}

TEST(BoxSides, freeSidesCloseTheBox)
{
  const BoxPatch box = makeBox();
  const auto sides = freeSidesOf(box);
  ASSERT_EQ(sides.size(), 6U);
  double area = 0, volume = 0;
  for (const PlanePatch& side : sides) {
    const Eigen::Vector3d normal = side.coefficients.head<3>();
    const auto& outer = side.polygons.at(0).outer;
    ASSERT_EQ(outer.size(), 4U);
    Eigen::Vector3d turn = Eigen::Vector3d::Zero(); // Stokes: twice the area
    for (std::size_t i = 0; i < 4; ++i) {
      const Eigen::Vector3d a = outer[i].cast<double>();
      turn += a.cross(outer[(i + 1) % 4].cast<double>());
      EXPECT_NEAR(side.coefficients[3] + normal.dot(a), 0, 1e-5);
      const Eigen::Vector3d own = box.axes.transpose() * (a - box.center);
      EXPECT_LT((own.cwiseAbs() - box.size / 2).norm(), 1e-5);
    }
    EXPECT_NEAR(turn.dot(normal) / 2, side.area, 1e-5) << "counter-clockwise";
    EXPECT_NEAR(side.axis_u.cross(side.axis_v).dot(normal), 1, 1e-12);
    area += side.area;
    volume += side.area * normal.dot(side.center - box.center) / 3;
  }
  EXPECT_NEAR(area, 22, 1e-9);
  EXPECT_NEAR(volume, 6, 1e-9) << "normals point outwards";
}

TEST(BoxSides, seenAndSnappedSidesAreLeftOut)
{
  BoxPatch box = makeBox();
  box.faces[0] = {BoxFaceKind::Seen, 3};
  box.faces[5] = {BoxFaceKind::Snapped, 0};
  const auto sides = freeSidesOf(box);
  ASSERT_EQ(sides.size(), 4U);
  for (const PlanePatch& side : sides) {
    const Eigen::Vector3d normal = side.coefficients.head<3>();
    EXPECT_LT(normal.dot(box.axes.col(0)), 0.5);
    EXPECT_GT(normal.dot(box.axes.col(2)), -0.5);
  }
}

/** A box whose slanted side falls to a middle height, and one where it meets the bottom
 * before the other end. */
TEST(BoxSides, slantedSideCutsTheOthers)
{
  BoxPatch box = makeBox();
  box.faces[4] = {BoxFaceKind::Slanted, 2};
  const auto cutBetween = [&](const Eigen::Vector3d& normal,
                              const Eigen::Vector3d& at) {
    const Eigen::Vector3d turned = box.axes * normal.normalized();
    box.slant << turned, -turned.dot(box.center + box.axes * at);
    double area = 0, volume = 0;
    std::size_t count = 0;
    for (const PlanePatch& side : freeSidesOf(box)) {
      area += side.area;
      volume +=
          side.area *
          side.coefficients.head<3>().dot(side.center - box.center - box.axes * at) / 3;
      ++count;
    }
    return std::array<double, 3>{static_cast<double>(count), area, volume};
  };
  // z from 0.5 at x = -1.5 to 0 at x = 1.5; the slanted side is seen from a place in it
  const auto [sides, area, volume] = cutBetween({0.5, 0, 3}, {-1.5, 0, 0.5});
  EXPECT_EQ(sides, 5);
  EXPECT_NEAR(area, 3 * 2 + 2 * 1 + 2 * 0.5 + 2 * (3 * 0.75), 1e-9);
  EXPECT_NEAR(volume, 3 * 2 * 0.75, 1e-9);
  const auto [left, left_area, left_volume] = cutBetween({1.2, 0, 3}, {-1.5, 0, 0.5});
  EXPECT_EQ(left, 4) << "nothing is left of the side +x";
  EXPECT_NEAR(left_area, 2.5 * 2 + 2 * 1 + 2.5 * 1, 1e-9);
  EXPECT_NEAR(left_volume, 2.5, 1e-9);
}

TEST(BoxSides, boxesThatAreNotFiniteHaveNone)
{
  BoxPatch box = makeBox();
  box.center.x() = NAN;
  EXPECT_TRUE(freeSidesOf(box).empty());
  box = makeBox();
  box.size.y() = 1e39;
  EXPECT_TRUE(freeSidesOf(box).empty());
  box = makeBox();
  box.slant.w() = NAN;
  EXPECT_TRUE(freeSidesOf(box).empty());
}

} // namespace
} // namespace pcl::acmap::test
