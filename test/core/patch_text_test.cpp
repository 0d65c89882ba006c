#include <pcl/core/patch_text.h>

#include <gtest/gtest.h>

#include <limits>

namespace pcl::acmap::test {
namespace {

TEST(PatchText, HasTheFiguresOfEachPatch)
{
  PlanePatch plane;
  plane.coefficients << -0.00001, -1, 0, 1.25;
  plane.area = 58.81;
  plane.rms = 0.00681;
  EXPECT_EQ(textOf(plane), "58.8 m2, rmse 6.81 mm, normal 0.000 -1.000 0.000");

  CylinderPatch cylinder;
  cylinder.radius = 0.25;
  cylinder.low = 1;
  cylinder.high = 3.5;
  cylinder.arc = 3.14159265;
  cylinder.rms = 0.002;
  cylinder.saved_bits = 1234.4;
  EXPECT_EQ(
      textOf(cylinder),
      "radius 0.25 m, 2.5 m long, 180 degrees of arc, solid, rmse 2 mm, 1234 bits "
      "saved");

  BoxPatch box;
  box.size << 1, 2, 0.5;
  box.faces[0].kind = BoxFaceKind::Seen;
  EXPECT_EQ(textOf(box).rfind("1.000 x 2.000 x 0.500 m, ", 0), 0U) << textOf(box);

  RecessPatch recess;
  recess.size << 0.9, 2, 0.1;
  recess.leaf = 4;
  recess.wall = 1;
  EXPECT_EQ(
      textOf(recess).rfind("0.900 x 2.000 m, 0.100 m deep, plane 4 behind 1, ", 0), 0U)
      << textOf(recess);
}

TEST(PatchText, OfWildFiguresIsCut)
{
  PlanePatch plane;
  plane.coefficients.setConstant(std::numeric_limits<double>::max());
  EXPECT_LT(textOf(plane).size(), 130U);
  RecessPatch recess;
  recess.size.setConstant(std::numeric_limits<double>::max());
  EXPECT_LT(textOf(recess).size(), 170U);
}

} // namespace
} // namespace pcl::acmap::test
