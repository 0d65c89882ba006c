#include <pcl/core/impl/vertex_neighbours.h>
#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <set>

namespace pcl::acmap::test {
namespace {

using Triangles = TriangleMesh::Triangles;

void
compareWithBruteForce(std::size_t vertices, const Triangles& triangles)
{
  std::vector<std::set<std::int32_t>> wanted(vertices);
  for (const TriangleMesh::Triangle& triangle : triangles)
    for (const std::int32_t a : triangle)
      for (const std::int32_t b : triangle)
        if (a != b)
          wanted[static_cast<std::size_t>(a)].insert(b);
  const VertexNeighbours found(vertices, triangles);
  ASSERT_EQ(found.vertices(), vertices);
  std::size_t all = 0;
  for (std::size_t v = 0; v < vertices; ++v) {
    EXPECT_EQ(std::vector<std::int32_t>(found[v].begin(), found[v].end()),
              std::vector<std::int32_t>(wanted[v].begin(), wanted[v].end()))
        << "ascending, vertex " << v;
    EXPECT_EQ(found[v].size(), wanted[v].size());
    all += found[v].size();
  }
  EXPECT_EQ(found.size(), all);
}

TEST(VertexNeighbours, areThoseOfAllTriangles)
{
  compareWithBruteForce(4, {{0, 1, 2}, {2, 1, 3}});
  Random random(1);
  for (const std::size_t vertices : {3U, 10U, 100U}) {
    Triangles triangles;
    for (int k = 0; k < 200; ++k) {
      TriangleMesh::Triangle triangle;
      for (std::int32_t& corner : triangle)
        corner = static_cast<std::int32_t>(random.bits() % vertices);
      triangles.push_back(triangle);
    }
    compareWithBruteForce(vertices,
                          triangles); // with repeated corners and crowded edges
  }
}

TEST(VertexNeighbours, mayBeMissing)
{
  EXPECT_EQ(VertexNeighbours().vertices(), 0U);
  EXPECT_EQ(VertexNeighbours().size(), 0U);
  compareWithBruteForce(0, {});
  compareWithBruteForce(5, {});
  compareWithBruteForce(5, {{3, 3, 3}, {1, 1, 4}});
}

TEST(VertexNeighbours, mayBeGiven)
{
  const VertexNeighbours given({0, 2, 2, 3}, {1, 2, 0});
  EXPECT_EQ(given.vertices(), 3U);
  EXPECT_EQ(given.size(), 3U);
  EXPECT_EQ(given[0].size(), 2U);
  EXPECT_EQ(given[1].size(), 0U);
  EXPECT_EQ(*given[2].begin(), 0);
}

} // namespace
} // namespace pcl::acmap::test
