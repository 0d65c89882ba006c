#include "temporary_folder.h"

#include <pcl/core/mesh_file.h>

#include <gtest/gtest.h>

#include <sys/stat.h>

namespace pcl::acmap::test {
namespace {

using Triangle = TriangleMesh::Triangle;

const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

class ObjFaces : public testing::Test {
protected:
  TriangleMesh::Triangles
  load(const std::string& text) const
  {
    return loadTriangleMesh(folder_.write("in.obj", text)).triangles;
  }

  TemporaryFolder folder_;
};

TEST_F(ObjFaces, PolygonsAreFans)
{
  EXPECT_EQ(load("# a square\n" + vertices + "f 1 2 3 4 # all\nf 1 2\n"),
            (TriangleMesh::Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST_F(ObjFaces, TexturesAndNormalsArePassedOver)
{
  EXPECT_EQ(
      load("mtllib a.mtl\nvn 0 0 1\nvt 0 0\n" + vertices +
           "g wall\ns off\nf 1/1 2/1 3/1\nf 1//1 3//1 4//1\nf 2/1/1 3/1/1 4/1/1\n"),
      (TriangleMesh::Triangles{{0, 1, 2}, {0, 2, 3}, {1, 2, 3}}));
}

TEST_F(ObjFaces, MaterialsAreNeverOpened)
{
  // opening it would block forever
  ASSERT_EQ(::mkfifo(folder_.path("pipe").c_str(), 0600), 0);
  for (const std::string& name :
       {folder_.path("pipe"), std::string("pipe"), std::string("../../etc/passwd")})
    EXPECT_EQ(
        load("mtllib " + name + "\nusemtl ../" + name + "\n" + vertices + "f 1 2 3\n"),
        (TriangleMesh::Triangles{{0, 1, 2}}));
}

TEST_F(ObjFaces, NegativeCornersCountFromTheLastVertex)
{
  EXPECT_EQ(load("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 -2 -1\n"),
            (TriangleMesh::Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST_F(ObjFaces, FacesMayStandAboveTheirVertices)
{
  EXPECT_EQ(load("f 1 2 3\n" + vertices), (TriangleMesh::Triangles{{0, 1, 2}}));
}

TEST_F(ObjFaces, NoFacesIsAnEmptyMesh)
{
  EXPECT_TRUE(load(vertices).empty());
}

TEST_F(ObjFaces, RefusesCornersThatAreNone)
{
  for (const char* face : {"f 1 2 5\n",
                           "f 0 1 2\n",
                           "f 1 2 -5\n",
                           "f 1 2 x\n",
                           "f 1 2 2.5\n",
                           "f 1 2 /3\n",
                           "f 1 2 --3\n",
                           "f 1 2 4294967298\n",
                           "f 1 2 99999999999999999999\n"})
    EXPECT_THROW(load(vertices + face), InputFileException) << face;
}

} // namespace
} // namespace pcl::acmap::test
