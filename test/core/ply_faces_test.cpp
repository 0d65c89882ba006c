#include "temporary_folder.h"

#include <pcl/core/mesh_file.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

using Triangle = TriangleMesh::Triangle;

std::string
header(const std::string& format,
       const std::string& faces,
       const std::string& face_properties = "property list uchar int vertex_indices\n")
{
  return "ply\nformat " + format +
         " 1.0\nelement vertex 4\nproperty float x\nproperty uchar red\nelement face " +
         faces + "\n" + face_properties + "end_header\n";
}

const std::string text_vertices = "0 1\n1 2\n2 3\n3 4\n";
const std::string binary_vertices(20, '\1');

class PlyFaces : public testing::Test {
protected:
  TriangleMesh
  load(const std::string& text) const
  {
    return loadTriangleMesh(folder_.write("in.ply", text));
  }

  TemporaryFolder folder_;
};

TEST_F(PlyFaces, TextWithPolygonsAsFans)
{
  const TriangleMesh mesh =
      load(header("ascii", "3") + text_vertices + "3 0 1 2\n4 3 2 1 0\n2 0 1\n");
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {3, 2, 1}, {3, 1, 0}}));
}

TEST_F(PlyFaces, BothByteOrders)
{
  const std::string little("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
  const std::string big("\3\0\0\0\0\0\0\0\1\0\0\0\2", 13);
  for (const std::string& text :
       {header("binary_little_endian", "1") + binary_vertices + little,
        header("binary_big_endian", "1") + binary_vertices + big})
    EXPECT_EQ(load(text).triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST_F(PlyFaces, OtherPropertiesArePassedOver)
{
  const std::string properties = "property uchar flag\nproperty list uchar float "
                                 "texcoord\nproperty list uchar ushort "
                                 "vertex_index\nproperty double quality\n";
  const TriangleMesh text = load(header("ascii", "1", properties) + text_vertices +
                                 "7 2 .5 .5 3 3 1 0 0.25\n");
  EXPECT_EQ(text.triangles, (std::vector<Triangle>{{3, 1, 0}}));
  const std::string row("\7\1\0\0\0\0\3\3\0\1\0\0\0\0\0\0\0\0\0\0\0", 21);
  EXPECT_EQ(
      load(header("binary_little_endian", "1", properties) + binary_vertices + row)
          .triangles,
      (std::vector<Triangle>{{3, 1, 0}}));
}

TEST_F(PlyFaces, NoFacesIsAnEmptyMesh)
{
  EXPECT_TRUE(load(header("ascii", "0") + text_vertices).triangles.empty());
  EXPECT_TRUE(load("ply\nformat ascii 1.0\nelement vertex 1\nproperty float "
                   "x\nend_header\n0\n")
                  .triangles.empty());
}

TEST_F(PlyFaces, RefusesFacesThatLie)
{
  const std::string binary = header("binary_little_endian", "2") + binary_vertices;
  for (const std::string& text :
       {header("ascii", "1") + text_vertices + "3 0 1 4\n",
        header("ascii", "1") + text_vertices + "3 0 1 -1\n",
        header("ascii", "1") + text_vertices + "3 0 1 1.5\n",
        header("ascii", "1") + text_vertices + "3 0 1\n",
        header("ascii", "1") + text_vertices + "-3 0 1 2\n",
        header("ascii", "1") + text_vertices + "nan 0 1 2\n",
        header("ascii", "2") + text_vertices + "3 0 1 2\n",
        header("ascii", "4000000000") + text_vertices,
        binary + std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13),
        binary + std::string(1, '\xff'),
        header("binary_little_endian", "1", "property list uint int vertex_indices\n") +
            binary_vertices + "\xff\xff\xff\xff",
        header("binary_little_endian", "1", "property list int int vertex_indices\n") +
            binary_vertices + "\xff\xff\xff\xff"})
    EXPECT_THROW(load(text), InputFileException) << text;
  EXPECT_THROW(loadTriangleMesh(folder_.write("in.vtk", "x")), InputFileException);
  EXPECT_THROW(loadTriangleMesh(folder_.path("missing.ply")), InputFileException);
}

TEST_F(PlyFaces, ReadsWhatSaveTriangleMeshWrote)
{
  PCLPointCloud2 cloud;
  const char* const names[] = {"x", "y", "z"};
  for (std::uint32_t i = 0; i < 3; ++i) {
    cloud.fields.emplace_back();
    cloud.fields.back().name = names[i];
    cloud.fields.back().offset = 4 * i;
    cloud.fields.back().datatype = PCLPointField::FLOAT32;
    cloud.fields.back().count = 1;
  }
  cloud.width = 5;
  cloud.height = 1;
  cloud.point_step = 12;
  cloud.data.resize(60);
  TriangleMesh mesh;
  mesh.triangles = {{4, 0, 1}, {2, 3, 4}};
  mesh.wall_depth = {0, TriangleMesh::no_wall};
  saveTriangleMesh(folder_.path("out.ply"), cloud, mesh);
  const TriangleMesh read = loadTriangleMesh(folder_.path("out.ply"));
  EXPECT_EQ(read.triangles, mesh.triangles);
  EXPECT_EQ(read.wall_depth, mesh.wall_depth);
}

TEST_F(PlyFaces, GivesEachTriangleOfAPolygonItsWallDepth)
{
  const auto withDepths = [&](const std::string& first, const std::string& second) {
    return folder_.write("in.ply",
                         "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                         "property float y\nproperty float z\nelement face 2\n"
                         "property int wall_depth\nproperty list uchar int "
                         "vertex_indices\nend_header\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n" +
                             first + " 4 0 1 2 3\n" + second + " 3 0 1 2\n");
  };
  EXPECT_EQ(loadTriangleMesh(withDepths("7", "255")).wall_depth,
            (std::vector<std::uint8_t>{7, 7, TriangleMesh::no_wall}));
  for (const char* depth : {"256", "-1", "0.5", "nan"})
    EXPECT_THROW(loadTriangleMesh(withDepths("0", depth)), InputFileException) << depth;
}

} // namespace
} // namespace pcl::acmap::test
