#include "dewall_runs.h"

#include <pcl/search/kdtree.h>

#include <functional>
#include <limits>
#include <stdexcept>

namespace pcl::acmap::test {
namespace {

using Distances = std::vector<float>;

/** PCL's tree with modified distances. */
class Teller : public search::KdTree<PointXYZ> {
public:
  explicit Teller(std::function<void(Distances&)> change)
  : change_(std::move(change))
  {}

  int
  nearestKSearch(const PointXYZ& point,
                 int k,
                 Indices& indices,
                 Distances& squared) const override
  {
    search::KdTree<PointXYZ>::nearestKSearch(point, k, indices, squared);
    change_(squared);
    return static_cast<int>(squared.size());
  }

private:
  std::function<void(Distances&)> change_;
};

DeWallResult
triangulateWith(const search::Search<PointXYZ>::Ptr& search,
                const Cloud& cloud,
                const IndicesPtr& indices = {})
{
  DeWallTriangulation<PointXYZ> dewall;
  dewall.setInputCloud(cloud.makeShared());
  if (indices)
    dewall.setIndices(indices);
  dewall.setSearchMethod(search);
  DeWallResult result;
  dewall.reconstruct(result.mesh);
  result.report = dewall.getReport();
  return result;
}

search::Search<PointXYZ>::Ptr
telling(std::function<void(Distances&)> change)
{
  return std::make_shared<Teller>(std::move(change));
}

TEST(DeWallSearchMethod, treeOfPclSaysWhatTheCellsSay)
{
  const Cloud cloud =
      doubled(lacedWithNan(makeGradedPlane({40, 60, 0.01, 0.2, 0.05, 3}, 10).cloud, 3));
  const DeWallResult own = triangulateWith({}, cloud);
  const DeWallResult asked = triangulateWith(telling([](Distances&) {}), cloud);
  // As each position exists twice, only half of the 9 neighbours are at other
  // positions.
  EXPECT_LT(asked.report.largest_maximum_edge, own.report.largest_maximum_edge);

  const auto once = std::make_shared<Indices>();
  for (std::size_t i = 0; i < cloud.size() / 2; ++i)
    once->push_back(static_cast<index_t>(i));
  const DeWallResult own_half = triangulateWith({}, cloud, once);
  const DeWallResult asked_half =
      triangulateWith(telling([](Distances&) {}), cloud, once);
  EXPECT_NEAR(
      asked_half.report.min_maximum_edge, own_half.report.min_maximum_edge, 1e-5);
  EXPECT_NEAR(asked_half.report.largest_maximum_edge,
              own_half.report.largest_maximum_edge,
              1e-5);
  EXPECT_EQ(asked_half.report.remarks, own_half.report.remarks);
}

TEST(DeWallSearchMethod, decidesHowLongEdgesMayBe)
{
  const Cloud cloud = makeJitteredPlane({30, 30, 1, 0.25, 0.05, 3}).cloud;
  const DeWallResult own = triangulateWith({}, cloud);
  const DeWallResult wide = triangulateWith(telling([](Distances& squared) {
                                              for (float& d : squared)
                                                d *= 4;
                                            }),
                                            cloud);
  EXPECT_NEAR(wide.report.min_maximum_edge, 2 * own.report.min_maximum_edge, 1e-3);
  EXPECT_NEAR(wide.report.median_spacing, 2 * own.report.median_spacing, 1e-3);
}

TEST(DeWallSearchMethod, nonsenseIsSaidAndPassedOver)
{
  const Cloud cloud = makeJitteredPlane({30, 30, 1, 0.25, 0.05, 3}).cloud;
  const DeWallResult own = triangulateWith({}, cloud);
  const auto spoil = [](Distances& squared) {
    squared = {-1, 0, std::numeric_limits<float>::quiet_NaN()};
  };
  for (const auto& search :
       {telling([](Distances& squared) { squared.clear(); }), telling(spoil)}) {
    const DeWallResult result = triangulateWith(search, cloud);
    EXPECT_EQ(result.mesh.triangles, own.mesh.triangles);
    ASSERT_EQ(result.report.remarks.size(), own.report.remarks.size() + 1);
    EXPECT_NE(result.report.remarks[0].find("found no neighbour"), std::string::npos);
  }
}

TEST(DeWallSearchMethod, itsExceptionsReachTheCaller)
{
  DeWallTriangulation<PointXYZ> dewall;
  dewall.setInputCloud(makeGrid(10, 10, 1, ExactPlane::Level).makeShared());
  dewall.setSearchMethod(telling([](Distances&) { throw std::length_error("no"); }));
  TriangleMesh mesh;
  mesh.triangles = {{1, 2, 3}};
  EXPECT_THROW(dewall.reconstruct(mesh), std::length_error);
  EXPECT_EQ(mesh.triangles.size(), 1U);
  dewall.setSearchMethod({});
  dewall.reconstruct(mesh);
  EXPECT_EQ(mesh.triangles.size(), 162U);
}

} // namespace
} // namespace pcl::acmap::test
