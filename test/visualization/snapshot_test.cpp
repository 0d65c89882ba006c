#include "clouds.h"
#include "shown_picture.h"
#include "temporary_folder.h"
#include "virtual_display.h"

#include <pcl/conversions.h>
#include <pcl/visualization/mesh_snapshot.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

class Snapshot : public testing::Test {
protected:
  void
  SetUp() override
  {
    if (!display_.exists())
      GTEST_SKIP() << "there is no X server, and Xvfb is not installed";
    const Cloud grid = makeGrid(20, 20, 0.125, ExactPlane::Level);
    Cloud wavy = grid;
    for (PointXYZ& p : wavy)
      p.z = 4 + 0.1F * std::sin(5 * p.x);
    toPCLPointCloud2(wavy, cloud_);
    for (int row = 0; row < 19; ++row)
      for (int column = 0; column < 19; ++column) {
        const int a = row * 20 + column;
        mesh_.triangles.push_back({a, a + 20, a + 1});
        mesh_.triangles.push_back({a + 1, a + 20, a + 21});
      }
  }

  const VirtualDisplay& display_ = VirtualDisplay::shared();
  TemporaryFolder folder_;
  std::string path_ = folder_.path("out.png");
  PCLPointCloud2 cloud_;
  TriangleMesh mesh_;
};

TEST_F(Snapshot, MeshFillsThePictureAndShowsItsRelief)
{
  SceneView view;
  view.width = 400;
  view.height = 300;
  saveSnapshot(path_, cloud_, mesh_, view);
  const ShownPicture picture(path_);
  EXPECT_EQ(picture.width, 400);
  EXPECT_EQ(picture.height, 300);
  EXPECT_GT(picture.covered(), 0.3);
  EXPECT_GT(picture.differentColors(), 50u);
}

TEST_F(Snapshot, PointsAreSeen)
{
  saveSnapshot(path_, cloud_, {});
  EXPECT_GT(ShownPicture(path_).covered(), 0.001);
}

TEST_F(Snapshot, PclsMeshLooksTheSame)
{
  PolygonMesh polygons;
  polygons.cloud = cloud_;
  for (const auto& [a, b, c] : mesh_.triangles) {
    polygons.polygons.emplace_back();
    polygons.polygons.back().vertices = {a, b, c};
  }
  saveSnapshot(path_, cloud_, mesh_);
  const std::string first = contentOf(path_);
  saveSnapshot(path_, polygons);
  EXPECT_EQ(contentOf(path_), first);
}

TEST_F(Snapshot, BackFacesHaveATint)
{
  SceneView view;
  view.from = Eigen::Vector3f(1, 1, 0);
  saveSnapshot(path_, cloud_, mesh_, view);
  const ShownPicture front(path_);
  for (TriangleMesh::Triangle& triangle : mesh_.triangles)
    std::swap(triangle[1], triangle[2]);
  saveSnapshot(path_, cloud_, mesh_, view);
  const ShownPicture back(path_);
  const std::size_t center = front.pixels.size() / 2 + 640;
  const auto blueness = [&](const ShownPicture& picture) {
    return picture.pixels[center][2] - picture.pixels[center][0];
  };
  EXPECT_GT(std::abs(blueness(front) - blueness(back)), 20);
}

TEST_F(Snapshot, EdgesAreLinesOnAFlatSurface)
{
  mesh_.triangles.resize(2); // two triangles are coplanar
  SceneView view;
  view.from = Eigen::Vector3f(0, 0, 3.5F);
  saveSnapshot(path_, cloud_, mesh_, view);
  const std::size_t plain = ShownPicture(path_).differentColors();
  const std::string before = contentOf(path_);
  view.show_edges = true;
  saveSnapshot(path_, cloud_, mesh_, view);
  EXPECT_NE(contentOf(path_), before);
  EXPECT_GT(ShownPicture(path_).differentColors(), plain);
}

TEST_F(Snapshot, FailsWithoutAFolderAndLeavesNothing)
{
  EXPECT_THROW(saveSnapshot(folder_.path("none/out.png"), cloud_, mesh_),
               OutputFileException);
  EXPECT_THROW(saveSnapshot(path_, PCLPointCloud2(), mesh_), BadArgumentException);
  EXPECT_EQ(folder_.count(), 0);
}

} // namespace
} // namespace pcl::acmap::test
