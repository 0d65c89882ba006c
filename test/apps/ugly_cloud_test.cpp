#include "clouds.h"
#include "temporary_folder.h"
#include "tool_cases.h"

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

/** \brief Checks that a cloud gives no triangle and no plane: code 4, the reason, no
 * files. */
void
expectNothingFound(const Cloud& cloud)
{
  const TemporaryFolder folder;
  const std::string input = folder.write("in.pcd", pcdText(cloud));
  expectRefused(
      runSurface({input, folder.path("out.ply"), "--report", folder.path("r.json")}),
      4,
      "no triangle is possible; ");
  expectRefused(runPlanes({input,
                           folder.path("out.json"),
                           "--labels",
                           folder.path("labels.pcd"),
                           "--normals",
                           folder.path("normals.ply"),
                           "--report",
                           folder.path("r.json")}),
                4,
                "no plane was found; ");
  expectRefused(runPlanes({input, folder.path("out.json"), "--paper"}),
                4,
                "no plane was found; ");
  EXPECT_EQ(folder.count(), 1);
}

/** \brief Checks that a mesh is made, and stderr has a warning. */
void
expectMeshAndWarning(const Cloud& cloud, const std::string& warning)
{
  const TemporaryFolder folder;
  const std::string input = folder.write("in.pcd", pcdText(cloud));
  const ToolRun run = runSurface({input, folder.path("out.ply")});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("warning: "), std::string::npos) << run.err;
  EXPECT_NE(run.err.find(warning), std::string::npos) << run.err;
  EXPECT_TRUE(std::filesystem::exists(folder.path("out.ply")));
}

Cloud
makePlane()
{
  SheetSampling sampling;
  sampling.spacing = 0.01;
  sampling.noise = 0.05;
  return makeJitteredPlane(sampling).cloud;
}

TEST(UglyCloud, TwoPoints)
{
  expectNothingFound(makeCollinear(2));
}

TEST(UglyCloud, ThreePointsAreATriangle)
{
  Cloud cloud;
  for (const float x : {0.0F, 1.0F})
    cloud.push_back(PointXYZ(x, 0, 2));
  cloud.push_back(PointXYZ(0, 1, 2));
  const TemporaryFolder folder;
  const ToolRun run =
      runSurface({folder.write("in.pcd", pcdText(cloud)), folder.path("out.ply")});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("triangles:   1\n"), std::string::npos) << run.out;
}

TEST(UglyCloud, Collinear)
{
  expectNothingFound(makeCollinear(1000));
}

TEST(UglyCloud, Coincident)
{
  expectNothingFound(makeCoincident(65000));
}

TEST(UglyCloud, OneTriangleIsNoPlane)
{
  const TemporaryFolder folder;
  const std::string input =
      folder.write("in.obj", "v 0 0 2\nv 1 0 2\nv 0 1 2\nf 1 2 3\n");
  expectRefused(runPlanes({input, folder.path("out.json")}), 4, "no plane was found; ");
  EXPECT_EQ(folder.count(), 1);
}

TEST(UglyCloud, CoplanarGrid)
{
  const TemporaryFolder folder;
  const Cloud grid = makeGrid(30, 30, 1.0 / 64, ExactPlane::Level);
  const ToolRun run =
      runSurface({folder.write("in.pcd", pcdText(grid)), folder.path("out.ply")});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_NE(run.out.find("triangles:   1682\n"), std::string::npos) << run.out;
}

TEST(UglyCloud, OnePointFarAway)
{
  expectMeshAndWarning(withOutlier(makePlane(), 1e9F), "one point lies far away");
}

TEST(UglyCloud, SomePointsNotFinite)
{
  expectMeshAndWarning(lacedWithNan(makePlane(), 7), "not finite");
}

} // namespace
} // namespace pcl::acmap::test
