#include <pcl/core/impl/cloud_fields.h>
#include <pcl/pipeline/detail_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <set>

namespace pcl::acmap::test {
namespace {

using Eigen::Vector3f;

/** Adds a square of (n + 1)^2 vertices, lifted by a function of the place in it. */
template <typename Lift>
void
addGrid(const Vector3f& corner,
        float side,
        int n,
        std::int32_t label,
        const Lift& lift,
        std::vector<Vector3f>& points,
        MappedPlanes& found)
{
  const auto first = static_cast<std::int32_t>(points.size());
  for (int row = 0; row <= n; ++row)
    for (int column = 0; column <= n; ++column) {
      const float x = static_cast<float>(column) / static_cast<float>(n),
                  y = static_cast<float>(row) / static_cast<float>(n);
      points.emplace_back(corner + Vector3f(side * x, side * y, lift(x, y)));
      found.vertex_labels.push_back(label);
    }
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column) {
      const std::int32_t a = first + row * (n + 1) + column, b = a + 1, c = a + n + 1,
                         d = c + 1;
      found.mesh.triangles.push_back({a, b, d});
      found.mesh.triangles.push_back({a, d, c});
    }
}

constexpr float spacing = 0.005F;

/** A floor on a plane, a bump of 0.5 m beside it on none, and a speck. */
MappedPlanes
makeScene(int n = 100)
{
  MappedPlanes found;
  std::vector<Vector3f> points;
  addGrid(
      {0, 0, 0}, 1, 20, 0, [](float, float) { return 0.0F; }, points, found);
  addGrid(
      {2, 0, 0},
      0.5F,
      n,
      -1,
      [](float x, float y) { return 0.1F * std::sin(3.14F * x) * std::sin(3.14F * y); },
      points,
      found);
  addGrid(
      {4, 0, 0}, 0.02F, 2, -1, [](float, float) { return 0.0F; }, points, found);
  PCLPointCloud2 layout = layoutWith({},
                                     {{"x", PCLPointField::FLOAT32},
                                      {"y", PCLPointField::FLOAT32},
                                      {"z", PCLPointField::FLOAT32},
                                      {"rgb", PCLPointField::FLOAT32}});
  layout.width = static_cast<std::uint32_t>(points.size());
  layout.height = 1;
  LargeVector<std::uint8_t> rows(points.size() * layout.point_step);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::memcpy(&rows[i * layout.point_step], points[i].data(), sizeof(float) * 3);
    const std::uint8_t color[] = {30, 20, 10, 0}; // blue, green, red
    std::memcpy(&rows[i * layout.point_step + 12], color, sizeof(color));
  }
  found.vertices = CloudRows(std::move(layout), std::move(rows));
  found.spacing = spacing;
  return found;
}

float
heightOf(const Vector3f& place)
{
  return 0.1F * std::sin(3.14F * (place.x() - 2) / 0.5F) *
         std::sin(3.14F * place.y() / 0.5F);
}

TEST(DetailMesh, IsTheSimplifiedMeshOfWhatIsOnNoPlane)
{
  const MapDetails details = makeDetails(makeScene());
  ASSERT_GT(details.mesh.triangles.size(), 10U);
  EXPECT_LT(details.mesh.triangles.size(), 4000U); // of 20,000
  EXPECT_EQ(details.colors.size(), details.vertices.size());
  std::set<std::int32_t> used;
  for (const TriangleMesh::Triangle& triangle : details.mesh.triangles) {
    Vector3f middle = Vector3f::Zero();
    for (const std::int32_t corner : triangle) {
      ASSERT_LT(static_cast<std::size_t>(corner), details.vertices.size());
      used.insert(corner);
      middle += details.vertices[static_cast<std::size_t>(corner)] / 3;
    }
    EXPECT_GT(middle.x(), 1.9F); // nothing of the floor
    EXPECT_LT(middle.x(), 3);    // nothing of the speck
    EXPECT_NEAR(middle.z(), heightOf(middle), 2 * spacing);
  }
  EXPECT_EQ(used.size(), details.vertices.size());
  EXPECT_EQ(details.colors[0], (std::array<std::uint8_t, 3>{10, 20, 30}));
}

TEST(DetailMesh, TakesNoMoreThanItMay)
{
  const MappedPlanes found = makeScene(300);
  for (const std::size_t bytes : {100000U, 5000U, 300U}) {
    const MapDetails details = makeDetails(found, bytes);
    EXPECT_LE(detailBytes(details), bytes);
  }
  EXPECT_GT(makeDetails(found, 5000).mesh.triangles.size(), 50U);
  EXPECT_TRUE(makeDetails(found, 0).vertices.empty());
}

TEST(DetailMesh, IsTheSameEachTime)
{
  const MapDetails one = makeDetails(makeScene()), other = makeDetails(makeScene());
  EXPECT_EQ(one.mesh.triangles, other.mesh.triangles);
  EXPECT_EQ(one.vertices, other.vertices);
}

TEST(DetailMesh, NeedsAMesh)
{
  EXPECT_TRUE(makeDetails({}).vertices.empty());
  MappedPlanes found = makeScene();
  found.mesh.triangles.clear();
  EXPECT_TRUE(makeDetails(found).mesh.triangles.empty());
  found = makeScene();
  std::fill(found.vertex_labels.begin(), found.vertex_labels.end(), 0);
  EXPECT_TRUE(makeDetails(found).mesh.triangles.empty());
}

} // namespace
} // namespace pcl::acmap::test
