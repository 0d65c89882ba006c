#include "temporary_folder.h"

#include <pcl/core/mesh_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

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
  EXPECT_EQ(mesh.triangles, (TriangleMesh::Triangles{{0, 1, 2}, {3, 2, 1}, {3, 1, 0}}));
}

TEST_F(PlyFaces, BothByteOrders)
{
  const std::string little("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
  const std::string big("\3\0\0\0\0\0\0\0\1\0\0\0\2", 13);
  for (const std::string& text :
       {header("binary_little_endian", "1") + binary_vertices + little,
        header("binary_big_endian", "1") + binary_vertices + big})
    EXPECT_EQ(load(text).triangles, (TriangleMesh::Triangles{{0, 1, 2}}));
}

TEST_F(PlyFaces, OtherPropertiesArePassedOver)
{
  const std::string properties = "property uchar flag\nproperty list uchar float "
                                 "texcoord\nproperty list uchar ushort "
                                 "vertex_index\nproperty double quality\n";
  const TriangleMesh text = load(header("ascii", "1", properties) + text_vertices +
                                 "7 2 .5 .5 3 3 1 0 0.25\n");
  EXPECT_EQ(text.triangles, (TriangleMesh::Triangles{{3, 1, 0}}));
  const std::string row("\7\1\0\0\0\0\3\3\0\1\0\0\0\0\0\0\0\0\0\0\0", 21);
  EXPECT_EQ(
      load(header("binary_little_endian", "1", properties) + binary_vertices + row)
          .triangles,
      (TriangleMesh::Triangles{{3, 1, 0}}));
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
            (LargeVector<std::uint8_t>{7, 7, TriangleMesh::no_wall}));
  for (const char* depth : {"256", "-1", "0.5", "nan"})
    EXPECT_THROW(loadTriangleMesh(withDepths("0", depth)), InputFileException) << depth;
}

/** Faces of several sizes, many times as long as the buffer of a file, and their rows
 * in every encoding. */
struct ManyFaces {
  static constexpr std::int32_t vertices = 200;
  static constexpr std::size_t rows = 60000;

  ManyFaces()
  {
    for (std::size_t row = 0; row < rows; ++row) {
      polygons.emplace_back(row % 1000 == 999 ? 150 : (row * row) % 7);
      for (std::size_t i = 0; i < polygons.back().size(); ++i)
        polygons.back()[i] = static_cast<std::uint8_t>((row + 31 * i) % vertices);
    }
  }

  static std::uint8_t
  depth(std::size_t row)
  {
    return static_cast<std::uint8_t>(row % 256);
  }

  TriangleMesh
  mesh() const
  {
    TriangleMesh mesh;
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t i = 2; i < polygons[row].size(); ++i) {
        mesh.triangles.push_back(
            {polygons[row][0], polygons[row][i - 1], polygons[row][i]});
        mesh.wall_depth.push_back(depth(row));
      }
    return mesh;
  }

  /** \param[in] store (value, bytes) to text */
  template <typename Store>
  std::string
  text(const std::string& format,
       const std::string& length_type,
       std::size_t length_bytes,
       const std::string& corner_type,
       std::size_t corner_bytes,
       bool depth_first,
       const Store& store) const
  {
    const std::string list =
        "property list " + length_type + " " + corner_type + " vertex_indices\n";
    const std::string scalar = "property uchar wall_depth\n";
    std::string text =
        "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(vertices) +
        "\nproperty uchar x\nelement face " + std::to_string(rows) +
        "\nproperty short before\n" + (depth_first ? scalar + list : list + scalar) +
        "property uchar after\nend_header\n" + std::string(vertices, '\1');
    for (std::size_t row = 0; row < rows; ++row) {
      text += store(7, 2);
      if (depth_first)
        text += store(depth(row), 1);
      text += store(polygons[row].size(), length_bytes);
      for (const std::uint8_t corner : polygons[row])
        text += store(corner, corner_bytes);
      if (!depth_first)
        text += store(depth(row), 1);
      text += store(9, 1);
    }
    return text;
  }

  std::vector<std::vector<std::uint8_t>> polygons;
};

std::string
littleEndian(std::size_t value, std::size_t bytes)
{
  std::string text;
  for (std::size_t i = 0; i < bytes; ++i)
    text += static_cast<char>(value >> (8 * i) & 0xff);
  return text;
}

std::string
bigEndian(std::size_t value, std::size_t bytes)
{
  const std::string text = littleEndian(value, bytes);
  return {text.rbegin(), text.rend()};
}

TEST_F(PlyFaces, LongerThanTheBufferInEveryTypeAndByteOrder)
{
  const ManyFaces faces;
  const TriangleMesh expected = faces.mesh();
  struct Type {
    const char* name;
    std::size_t bytes;
  };
  for (const Type& length : {Type{"uchar", 1}, Type{"short", 2}, Type{"int", 4}})
    for (const Type& corner : {Type{"uchar", 1}, Type{"ushort", 2}, Type{"uint", 4}})
      for (const bool depth_first : {false, true}) {
        const auto text = [&](const char* format, const auto& store) {
          return faces.text(format,
                            length.name,
                            length.bytes,
                            corner.name,
                            corner.bytes,
                            depth_first,
                            store);
        };
        for (const TriangleMesh& mesh :
             {load(text("binary_little_endian", littleEndian)),
              load(text("binary_big_endian", bigEndian))}) {
          EXPECT_EQ(mesh.triangles, expected.triangles) << length.name << corner.name;
          EXPECT_EQ(mesh.wall_depth, expected.wall_depth) << length.name << corner.name;
        }
      }
}

/** A binary PLY of 4 vertices and 100,000 triangles, of which one can be damaged. */
std::string
manyTriangles(const std::string& corner_type, const std::string& damaged)
{
  const std::size_t size = corner_type == "int" ? 4 : corner_type == "short" ? 2 : 1;
  std::string text =
      header("binary_little_endian",
             "100000",
             "property list uchar " + corner_type + " vertex_indices\n") +
      binary_vertices;
  for (std::size_t row = 0; row < 100000; ++row) {
    if (row == 77777)
      text += damaged;
    else
      for (const std::size_t value : {3, 0, 1, 2})
        text += littleEndian(value, value == 3 ? 1 : size);
  }
  return text;
}

TEST_F(PlyFaces, RefusesOneFaultAmongManyFaces)
{
  const auto fault = [&](const std::string& type, const std::string& damaged) {
    try {
      load(manyTriangles(type, damaged));
      return std::string("none");
    }
    catch (const InputFileException& refusal) {
      return std::string(refusal.what());
    }
  };
  const std::string corner = "face 77777 has a corner outside of the vertices";
  using testing::HasSubstr;
  EXPECT_THAT(fault("int", std::string("\3\0\0\0\0\1\0\0\0\4\0\0\0", 13)),
              HasSubstr(corner));
  EXPECT_THAT(fault("int", "\3" + std::string(12, '\xff')), HasSubstr(corner));
  EXPECT_THAT(fault("short", "\3" + std::string(6, '\xff')), HasSubstr(corner));
  EXPECT_THAT(fault("char", "\3" + std::string(3, '\xff')), HasSubstr(corner));
  EXPECT_EQ(fault("int", std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13)), "none");
  // The last face lacks a byte.
  EXPECT_THAT(fault("int", std::string("\3\0\0\0\0\1\0\0\0\2\0\0", 12)),
              testing::Not("none"));
  EXPECT_THAT(fault("uchar", ""), HasSubstr("truncated"));
}

TEST_F(PlyFaces, NegativeCornersOfAByteAreRefusedAmongManyVertices)
{
  const std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex 300\n"
                           "property uchar x\nelement face 1\nproperty list uchar "
                           "char vertex_indices\nend_header\n" +
                           std::string(300, '\1');
  EXPECT_THROW(load(text + "\3\x01\x02\xc8"), InputFileException);
  EXPECT_EQ(load(text + "\3\x01\x02\x78").triangles,
            (TriangleMesh::Triangles{{1, 2, 120}}));
}

} // namespace
} // namespace pcl::acmap::test
