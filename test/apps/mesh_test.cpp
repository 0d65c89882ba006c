#include "clouds.h"
#include "temporary_folder.h"
#include "tool_cases.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkSmartPointer.h>

namespace pcl::acmap::test {
namespace {

/** \brief Reads a mesh with VTK, an independent reader. */
template <typename Reader>
vtkSmartPointer<vtkPolyData>
readBack(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

/** \brief Maximum side length of the bounding box. */
double
widthOf(vtkPolyData* mesh)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  return bounds[1] - bounds[0];
}

std::string
coloredPly()
{
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty "
      "float y\nproperty float z\nproperty uchar red\nproperty uchar "
      "green\nproperty uchar blue\nend_header\n";
  return text + "0 0 2 255 0 0\n1 0 2 0 255 0\n0 1 2 0 0 255\n1 1 2 9 8 7\n";
}

class Mesh : public testing::Test {
protected:
  std::string
  output(const std::string& name) const
  {
    return folder_.path(name);
  }

  TemporaryFolder folder_;
  std::string input_ = folder_.write("in.pcd", planePcd());
};

TEST_F(Mesh, OtherLibrariesReadIt)
{
  runSurface({input_, output("a.ply")}).succeeded();
  runSurface({input_, output("a.vtk")}).succeeded();
  const auto ply = readBack<vtkPLYReader>(output("a.ply"));
  const auto vtk = readBack<vtkPolyDataReader>(output("a.vtk"));
  for (const auto& mesh : {ply, vtk}) {
    EXPECT_EQ(mesh->GetNumberOfPoints(), 400);
    EXPECT_GT(mesh->GetNumberOfPolys(), 600);
    EXPECT_EQ(mesh->GetPolys()->GetMaxCellSize(), 3);
  }
  EXPECT_EQ(ply->GetNumberOfPolys(), vtk->GetNumberOfPolys());
}

TEST_F(Mesh, SummaryIsOnStdoutAndQuietIsQuiet)
{
  const ToolRun run = runSurface({input_, output("a.ply")});
  EXPECT_EQ(run.err, "");
  for (const char* word : {"points:      400\n",
                           "used:",
                           "triangles:",
                           "components:",
                           "boundary:",
                           "seconds:",
                           "a.ply\n"})
    EXPECT_NE(run.out.find(word), std::string::npos) << word << "\n" << run.out;
  const ToolRun quiet = runSurface({input_, output("a.ply"), "--quiet"});
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST_F(Mesh, MemoryLimitRefuses)
{
  const ToolRun run = runSurface({input_, output("a.ply"), "--memory-limit", "500KB"});
  EXPECT_EQ(run.exit_code, 6);
  EXPECT_EQ(run.errorLines(), 1U) << run.err;
  EXPECT_NE(run.err.find("--memory-limit"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(output("a.ply")));
  EXPECT_EQ(runSurface({input_, output("a.ply"), "-memory_limit", "1GB"}).exit_code, 0);
  EXPECT_EQ(runSurface({input_, output("b.ply"), "--memory-limit", "much"}).exit_code,
            2);
}

TEST_F(Mesh, ScaleMakesMetres)
{
  runSurface({input_, output("a.ply")}).succeeded();
  runSurface({input_, output("b.ply"), "--scale", "0.001"}).succeeded();
  const double width = widthOf(readBack<vtkPLYReader>(output("a.ply")));
  const double small = widthOf(readBack<vtkPLYReader>(output("b.ply")));
  EXPECT_NEAR(small, width / 1000, width * 1e-9);
}

TEST_F(Mesh, MaximumEdgeIsKeptInBothSpellings)
{
  runSurface({input_, output("a.ply"), "--max-edge", "0.012"}).succeeded();
  runSurface({input_, output("b.ply"), "-max_edge", "0.012"}).succeeded();
  runSurface({input_, output("c.ply")}).succeeded();
  EXPECT_EQ(contentOf(output("a.ply")), contentOf(output("b.ply")));
  EXPECT_LT(readBack<vtkPLYReader>(output("a.ply"))->GetNumberOfPolys(),
            readBack<vtkPLYReader>(output("c.ply"))->GetNumberOfPolys());
}

TEST_F(Mesh, RulesAndWallDepth)
{
  EXPECT_EQ(runSurface({input_, output("a.ply"), "--rule", "guarded"}).exit_code, 0);
  EXPECT_EQ(runSurface({input_, output("d.ply"), "--rule", "paper"}).exit_code, 0);
  EXPECT_EQ(contentOf(output("a.ply")), contentOf(output("d.ply")))
      << "its former name";
  EXPECT_EQ(runSurface({input_, output("b.ply"), "-rule", "dense"}).exit_code, 0);
  EXPECT_EQ(runSurface({input_, output("c.ply"), "-wall_depth"}).exit_code, 0);
  EXPECT_EQ(contentOf(output("a.ply")).find("wall_depth"), std::string::npos);
  EXPECT_NE(contentOf(output("c.ply")).find("property uchar wall_depth"),
            std::string::npos);
}

TEST_F(Mesh, KeepsColoursAndTakesEveryFormat)
{
  const std::string ply = folder_.write("color.ply", coloredPly());
  runSurface({ply, output("a.ply")}).succeeded();
  const auto mesh = readBack<vtkPLYReader>(output("a.ply"));
  ASSERT_NE(mesh->GetPointData()->GetScalars(), nullptr);
  EXPECT_EQ(mesh->GetPointData()->GetScalars()->GetTuple3(3)[0], 9);
  EXPECT_EQ(mesh->GetPointData()->GetScalars()->GetTuple3(2)[2], 255);

  const std::string obj = folder_.write("in.obj", "v 0 0 2\nv 1 0 2\nv 0 1 2\n");
  const std::string xyz = folder_.write("in.XYZ", "0 0 2\n1 0 2\n0 1 2\n");
  EXPECT_EQ(runSurface({obj, output("b.ply")}).exit_code, 0);
  EXPECT_EQ(runSurface({xyz, output("c.ply")}).exit_code, 0);
  EXPECT_EQ(contentOf(output("b.ply")), contentOf(output("c.ply")));
}

} // namespace
} // namespace pcl::acmap::test
