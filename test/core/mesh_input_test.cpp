#include <pcl/core/impl/mesh_input.h>
#include <pcl/exceptions.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

using Triangles = TriangleMesh::Triangles;

Vertices
polygonOf(const Indices& corners)
{
  Vertices polygon;
  polygon.vertices = corners;
  return polygon;
}

TEST(TrianglesOf, splitsPolygonsIntoFans)
{
  EXPECT_TRUE(trianglesOf({}).empty());
  EXPECT_EQ(trianglesOf({polygonOf({4, 2, 9})}), Triangles({{4, 2, 9}}));
  EXPECT_EQ(trianglesOf({polygonOf({0, 1, 2, 3}), polygonOf({8, 7, 6, 5, 4})}),
            Triangles({{0, 1, 2}, {0, 2, 3}, {8, 7, 6}, {8, 6, 5}, {8, 5, 4}}));
}

TEST(TrianglesOf, leavesOutWhatIsNoFace)
{
  EXPECT_EQ(
      trianglesOf(
          {polygonOf({}), polygonOf({1}), polygonOf({1, 2}), polygonOf({1, 2, 3})}),
      Triangles({{1, 2, 3}}));
}

TEST(RequireCornersInside, letsWholeMeshesPass)
{
  EXPECT_NO_THROW(requireCornersInside({}, 0));
  EXPECT_NO_THROW(requireCornersInside({{0, 1, 2}, {2, 2, 0}}, 3));
}

TEST(RequireCornersInside, namesTheCornerThatIsNot)
{
  for (const std::int32_t wrong : {-1, 3, 2147483647, -2147483647 - 1})
    for (const Triangles& triangles :
         {Triangles{{0, 1, 2}, {0, wrong, 1}}, Triangles{{wrong, 0, 0}}})
      EXPECT_THAT([&] { requireCornersInside(triangles, 3); },
                  testing::ThrowsMessage<InitFailedException>(testing::AllOf(
                      testing::HasSubstr("corner " + std::to_string(wrong)),
                      testing::HasSubstr("3 points"))))
          << wrong;
}

} // namespace
} // namespace pcl::acmap::test
