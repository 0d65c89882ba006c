#include "cloud_values.h"
#include "sample_mesh.h"
#include "temporary_folder.h"

#include <pcl/core/mesh_file.h>

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>

namespace pcl::acmap::test {
namespace {

/** A file read by VTK. */
class VtkFile {
public:
  explicit VtkFile(const std::string& path)
  {
    reader_->SetFileName(path.c_str());
    reader_->Update();
  }

  vtkPolyData&
  data()
  {
    return *reader_->GetOutput();
  }

  /** All values of an array as floats. */
  static std::vector<float>
  valuesOf(vtkDataArray& array)
  {
    std::vector<float> values;
    for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i)
      for (int c = 0; c < array.GetNumberOfComponents(); ++c)
        values.push_back(static_cast<float>(array.GetComponent(i, c)));
    return values;
  }

private:
  vtkNew<vtkPolyDataReader> reader_;
};

/** Some fields of a cloud, point by point. */
std::vector<float>
interleaved(const PCLPointCloud2& cloud, const std::vector<std::string>& names)
{
  std::vector<std::vector<float>> columns;
  for (const std::string& name : names)
    columns.push_back(floatsOf(cloud, name));
  std::vector<float> values;
  for (std::size_t i = 0; i < columns[0].size(); ++i)
    for (const auto& column : columns)
      values.push_back(column[i]);
  return values;
}

class MeshFileVtk : public testing::Test {
protected:
  MeshFileVtk()
  {
    saveTriangleMesh(folder_.path("a b.VTK"), sample_.cloud, sample_.mesh);
  }

  TemporaryFolder folder_;
  SampleMesh sample_;
};

TEST_F(MeshFileVtk, hasTheTriangles)
{
  VtkFile file(folder_.path("a b.VTK"));
  ASSERT_EQ(file.data().GetNumberOfPolys(),
            static_cast<vtkIdType>(sample_.mesh.triangles.size()));
  vtkNew<vtkIdList> corners;
  file.data().GetPolys()->InitTraversal();
  for (const TriangleMesh::Triangle& triangle : sample_.mesh.triangles) {
    file.data().GetPolys()->GetNextCell(corners);
    ASSERT_EQ(corners->GetNumberOfIds(), 3);
    for (int c = 0; c < 3; ++c)
      ASSERT_EQ(corners->GetId(c), triangle[static_cast<std::size_t>(c)]);
  }
}

TEST_F(MeshFileVtk, hasPointsNormalsAndScalars)
{
  VtkFile file(folder_.path("a b.VTK"));
  vtkPointData& data = *file.data().GetPointData();
  EXPECT_EQ(VtkFile::valuesOf(*file.data().GetPoints()->GetData()),
            interleaved(sample_.cloud, {"x", "y", "z"}));
  ASSERT_TRUE(data.GetNormals());
  EXPECT_EQ(VtkFile::valuesOf(*data.GetNormals()),
            interleaved(sample_.cloud, {"normal_x", "normal_y", "normal_z"}));
  ASSERT_TRUE(data.GetArray("curvature"));
  EXPECT_EQ(VtkFile::valuesOf(*data.GetArray("curvature")),
            floatsOf(sample_.cloud, "curvature"));
}

TEST_F(MeshFileVtk, hasTheColours)
{
  VtkFile file(folder_.path("a b.VTK"));
  vtkDataArray* const colours = file.data().GetPointData()->GetScalars();
  ASSERT_TRUE(colours);
  ASSERT_EQ(colours->GetNumberOfComponents(), 3);
  ASSERT_EQ(colours->GetDataType(), VTK_UNSIGNED_CHAR);
  const std::vector<std::uint8_t> packed = bytesOf(sample_.cloud, "rgb");
  for (vtkIdType i = 0; i < colours->GetNumberOfTuples(); ++i)
    for (int c = 0; c < 3; ++c)
      ASSERT_EQ(colours->GetComponent(i, c),
                packed[static_cast<std::size_t>(4 * i + 2 - c)]);
}

TEST(MeshFileVtkEmpty, hasPointsWithoutTriangles)
{
  const TemporaryFolder folder;
  const SampleMesh sample(5);
  saveTriangleMesh(folder.path("a.vtk"), sample.cloud, {});
  VtkFile file(folder.path("a.vtk"));
  EXPECT_EQ(file.data().GetNumberOfPoints(), 5);
  EXPECT_EQ(file.data().GetNumberOfPolys(), 0);
  EXPECT_TRUE(file.data().GetPointData()->GetArray("curvature"));
}

} // namespace
} // namespace pcl::acmap::test
