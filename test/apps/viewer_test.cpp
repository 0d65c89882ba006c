#include "temporary_folder.h"
#include "tool_cases.h"
#include "virtual_display.h"

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

const std::string png_signature = "\x89PNG";

class Viewer : public testing::Test {
protected:
  void
  SetUp() override
  {
    if (!display_.exists())
      GTEST_SKIP() << "there is no X server, and Xvfb is not installed";
  }

  std::string
  shoot(const std::string& input, std::vector<std::string> more = {})
  {
    std::vector<std::string> arguments =
        joined({input, "--screenshot", picture_}, more);
    const ToolRun run = runViewer(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const std::string png = contentOf(picture_);
    EXPECT_EQ(png.substr(0, 4), png_signature);
    return png;
  }

  const VirtualDisplay& display_ = VirtualDisplay::shared();
  TemporaryFolder folder_;
  std::string cloud_ = folder_.write("in.pcd", planePcd());
  std::string picture_ = folder_.path("out.png");
};

TEST_F(Viewer, DrawsCloudsAndMeshes)
{
  const std::string cloud = shoot(cloud_);
  for (const char* ending : {".ply", ".vtk"}) {
    const std::string mesh = folder_.path(std::string("mesh") + ending);
    runSurface({cloud_, mesh}).succeeded();
    const std::string drawn = shoot(mesh);
    EXPECT_NE(drawn, cloud);
    EXPECT_NE(shoot(mesh, {"--boundary"}), drawn);
  }
}

TEST_F(Viewer, LooksFromWhereItIsTold)
{
  const std::string oblique = shoot(cloud_);
  const std::string front = shoot(cloud_, {"--from", "0", "0", "-1"});
  EXPECT_NE(front, oblique);
  EXPECT_NE(shoot(cloud_, {"-from", "0", "0", "-1", "-up", "x"}), front);
  EXPECT_NE(shoot(cloud_, {"-from", "0", "0", "-1", "-look", "0.1", "0", "0"}), front);
  // width and height are big-endian numbers in the first chunk
  EXPECT_EQ(shoot(cloud_, {"--size", "320x200"}).substr(16, 8),
            std::string("\0\0\1\x40\0\0\0\xc8", 8));
}

TEST_F(Viewer, HidesBacksOfMeshes)
{
  const std::string mesh = folder_.path("mesh.ply");
  runSurface({cloud_, mesh}).succeeded();
  const std::string behind = shoot(mesh, {"--from", "0", "0", "1"});
  const std::string before = shoot(mesh, {"--from", "0", "0", "-1"});
  EXPECT_NE(shoot(mesh, {"--from", "0", "0", "1", "--hide-backs"}) == behind,
            shoot(mesh, {"--from", "0", "0", "-1", "--hide-backs"}) == before);
}

TEST_F(Viewer, DrawsFacesOfAnObj)
{
  const std::string points = "v 0 0 2\nv 1 0 2\nv 0 1 2\nv 1 1 3\n";
  const std::string faces = "f 1 2 3\nf 2 4 3\n";
  EXPECT_NE(shoot(folder_.write("mesh.obj", points + faces)),
            shoot(folder_.write("points.obj", points)));
}

TEST_F(Viewer, RefusesViewsThatCannotBe)
{
  for (const char* size : {"0x10", "-5x5", "10", "axb", "10x10x10", "99999999x1"})
    expectRefused(runViewer({cloud_, "-screenshot", picture_, "-size", size}), 2, "");
  expectRefused(runViewer({cloud_, "-screenshot", picture_, "-up", "0,0,0"}), 2, "up");
  expectRefused(runViewer({cloud_, "-screenshot", picture_, "-up", "0,0"}), 2, "--up");
  EXPECT_EQ(folder_.count(), 1);
}

TEST_F(Viewer, RefusesFacesOutsideOfTheVertices)
{
  const std::string vertices =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float "
      "y\nproperty float z\nelement face 1\nproperty list uchar int "
      "vertex_indices\nend_header\n0 0 1\n1 0 1\n0 1 1\n";
  for (const char* face :
       {"3 0 1 3\n", "3 0 1 -1\n", "3 0 1\n", "200 0 1 2\n", "-3 0\n"}) {
    const std::string input = folder_.write("in.ply", vertices + face);
    expectRefused(runViewer({input, "--screenshot", picture_}), 3, input);
  }
}

TEST_F(Viewer, RefusesDamagedVtk)
{
  const std::string head = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n";
  const std::string points = "POINTS 3 float\n0 0 1 1 0 1 0 1 1\n";
  for (const std::string& text : {std::string(),
                                  std::string("garbage"),
                                  head,
                                  head + "POINTS -3 float\n0 0 0\n",
                                  head + points + "POLYGONS 1 4\n3 0 1 7\n",
                                  head + points + "POLYGONS 1 4\n300 0 1 2\n",
                                  head + points + "POLYGONS -1 -4\n3 0 1 2\n"}) {
    SCOPED_TRACE(text);
    const std::string input = folder_.write("in.vtk", text);
    expectRefused(runViewer({input, "--screenshot", picture_}), 3, input);
  }
}

TEST_F(Viewer, RefusesVtkThatClaimsBillions)
{
  const std::string head = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n";
  const std::string points = "POINTS 3 float\n0 0 1 1 0 1 0 1 1\n";
  for (const std::string& text :
       {head + "POINTS 4000000000 float\n0 0 0\n",
        head + points + "POLYGONS 4000000000 16000000000\n3 0 1 2\n",
        head + points + "POLYGONS 1 16000000000\n3 0 1 2\n",
        head + points + "TRIANGLE_STRIPS 4000000000 4\n3 0 1 2\n",
        head + points + "POINT_DATA 4000000000\nSCALARS c float\n1 2 3\n"}) {
    SCOPED_TRACE(text);
    const std::string input = folder_.write("in.vtk", text);
    expectRefused(runViewer({input, "--memory-limit", "2GB", "--screenshot", picture_}),
                  3,
                  "in.vtk: claims more");
  }
}

TEST_F(Viewer, AsksForAnXServer)
{
  RunSettings blind;
  blind.environment = {{"DISPLAY", std::nullopt}};
  expectRefused(runViewer({cloud_, "-screenshot", picture_}, blind), 1, "xvfb-run");
  blind.environment = {{"DISPLAY", ":987654"}};
  expectRefused(runViewer({cloud_, "-screenshot", picture_}, blind), 1, "xvfb-run");
  EXPECT_EQ(folder_.count(), 1);
}

} // namespace
} // namespace pcl::acmap::test
