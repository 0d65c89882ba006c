#include "temporary_folder.h"
#include "textured_map.h"

#include <pcl/core/mesh_file.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/texture/compact_map_folder.h>

#include <assimp/Importer.hpp>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tiny_gltf.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTriangle.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

Eigen::Vector3d
vectorOf(const aiVector3D& v)
{
  return {v.x, v.y, v.z};
}

/** From glTF's frame into the map's. */
Eigen::Vector3d
turnedBack(const Eigen::Vector3d& v)
{
  return {v.x(), -v.y(), -v.z()};
}

class MapFormats : public testing::Test {
protected:
  void
  save(const CompactMapOutputs& outputs = {})
  {
    names_ = saveCompactMap(path(), map_, outputs);
  }

  /** With a space, as folders of users have. */
  std::string
  path(const std::string& name = "") const
  {
    return folder_.path("my map" + (name.empty() ? "" : "/" + name));
  }

  /** The image of a mesh's material, as assimp finds it; empty without one. */
  RgbImage
  imageOf(const aiScene& scene, const aiMesh& mesh) const
  {
    aiString name;
    if (scene.mMaterials[mesh.mMaterialIndex]->GetTexture(
            aiTextureType_DIFFUSE, 0, &name) != AI_SUCCESS)
      return {};
    const aiTexture* const inside = scene.GetEmbeddedTexture(name.C_Str());
    if (!inside)
      return loadRgbImage(path(name.C_Str()));
    EXPECT_EQ(inside->mHeight, 0u); // compressed
    const std::string bytes(reinterpret_cast<const char*>(inside->pcData),
                            inside->mWidth);
    return loadRgbImage(folder_.write("inside", bytes));
  }

  /** The chart whose colours those of an image are, but for so much on average. */
  std::size_t
  chartOf(const RgbImage& image, double tolerance) const
  {
    for (std::size_t i = 0; i < map_.charts.size(); ++i) {
      const RgbImage& colors = map_.charts[i].colors;
      if (image.width != colors.width || image.height != colors.height)
        continue;
      double sum = 0;
      for (std::size_t k = 0; k < colors.values.size(); ++k)
        sum += std::abs(image.values[k] - colors.values[k]);
      if (sum <= tolerance * static_cast<double>(colors.values.size()))
        return i;
    }
    ADD_FAILURE() << "an image is no chart's: " << image.width << " x " << image.height;
    return no_chart;
  }

  std::vector<ReadTriangle>
  readByAssimp(const std::string& name, double tolerance) const
  {
    Assimp::Importer importer;
    const aiScene* const scene =
        importer.ReadFile(path(name), aiProcess_PreTransformVertices);
    EXPECT_TRUE(scene) << importer.GetErrorString();
    std::vector<ReadTriangle> triangles;
    for (unsigned k = 0; scene && k < scene->mNumMeshes; ++k) {
      const aiMesh& mesh = *scene->mMeshes[k];
      const RgbImage image = imageOf(*scene, mesh);
      const std::size_t chart = image.width ? chartOf(image, tolerance) : no_chart;
      for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        EXPECT_EQ(mesh.mFaces[i].mNumIndices, 3u);
        ReadTriangle triangle;
        triangle.chart = chart;
        for (int corner = 0; corner < 3; ++corner) {
          const unsigned vertex = mesh.mFaces[i].mIndices[corner];
          triangle.corners[corner] = vectorOf(mesh.mVertices[vertex]);
          if (mesh.HasTextureCoords(0)) // assimp's begin bottom left
            triangle.places[corner] = {mesh.mTextureCoords[0][vertex].x,
                                       1 - mesh.mTextureCoords[0][vertex].y};
        }
        triangles.push_back(triangle);
      }
    }
    return triangles;
  }

  const TemporaryFolder folder_;
  CompactMap map_ = makeTexturedMap();
  std::vector<std::string> names_;
};

TEST_F(MapFormats, ObjIsReadByAssimp)
{
  save();
  expectSurfaces(readByAssimp("map.obj", 0), map_);
}

TEST_F(MapFormats, ObjWithJpegsIsReadByAssimp)
{
  CompactMapOutputs outputs;
  outputs.jpeg_images = true;
  save(outputs);
  EXPECT_THAT(names_, testing::Contains("texture_0002.jpg"));
  expectSurfaces(readByAssimp("map.obj", 3), map_);
}

TEST_F(MapFormats, ObjIsReadByVtk)
{
  save();
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(path("map.obj").c_str());
  reader->Update();
  vtkPolyData* const mesh = reader->GetOutput();
  ASSERT_TRUE(mesh->GetPointData()->GetTCoords());
  double area = 0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i) {
    ASSERT_EQ(mesh->GetCell(i)->GetNumberOfPoints(), 3);
    area += static_cast<vtkTriangle*>(mesh->GetCell(i))->ComputeArea();
  }
  double wanted = 0;
  for (const double part : areasOf(map_))
    wanted += part;
  EXPECT_NEAR(area, wanted, 1e-4);
  EXPECT_EQ(mesh->GetNumberOfPoints(),
            mesh->GetPointData()->GetTCoords()->GetNumberOfTuples());
}

TEST_F(MapFormats, ObjSharesCorners)
{
  save();
  const std::string text = contentOf(path("map.obj"));
  const auto count = [&](const std::string& word) {
    std::size_t found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos;
         at = text.find(word, at + 1))
      ++found;
    return found;
  };
  EXPECT_LE(count("\nv "), 8u + 6 + 9 + 3); // tiles cut three edges at most
  EXPECT_EQ(count("\nv "), count("\nvt "));
  EXPECT_EQ(count("usemtl untextured"), 1u);
  EXPECT_EQ(text.find(folder_.path("")), std::string::npos);
  EXPECT_THAT(contentOf(path("map.mtl")), HasSubstr("map_Kd texture_0001.png\n"));
}

TEST_F(MapFormats, GlbIsReadByAssimp)
{
  save();
  auto triangles = readByAssimp("map.glb", 3);
  for (ReadTriangle& triangle : triangles)
    for (Eigen::Vector3d& corner : triangle.corners)
      corner = turnedBack(corner);
  expectSurfaces(triangles, map_);
}

TEST_F(MapFormats, GlbIsReadByTinygltf)
{
  map_ = makeTexturedMap({3000, -40, 1e4});
  save();
  tinygltf::Model model;
  std::string error;
  std::string warning;
  ASSERT_TRUE(tinygltf::TinyGLTF().LoadBinaryFromFile(
      &model, &error, &warning, path("map.glb")))
      << error;
  EXPECT_EQ(error + warning, "");
  ASSERT_EQ(model.meshes.size(), 1u);
  EXPECT_EQ(model.meshes[0].primitives.size(), 4u);
  ASSERT_EQ(model.images.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(model.images[i].width, map_.charts[i].colors.width);
    EXPECT_EQ(model.images[i].height, map_.charts[i].colors.height);
    EXPECT_EQ(model.images[i].mimeType, "image/jpeg");
  }
  ASSERT_EQ(model.materials.size(), 4u);
  for (const tinygltf::Material& material : model.materials) {
    EXPECT_TRUE(material.doubleSided);
    EXPECT_EQ(material.extensions.count("KHR_materials_unlit"), 1u);
    EXPECT_EQ(material.pbrMetallicRoughness.metallicFactor, 0);
    EXPECT_EQ(material.pbrMetallicRoughness.roughnessFactor, 1);
  }
  EXPECT_EQ(model.extensionsUsed, std::vector<std::string>{"KHR_materials_unlit"});
}

TEST_F(MapFormats, GlbIsExactFarOut)
{
  const Eigen::Vector3d place(3000, -40, 1e4);
  map_ = makeTexturedMap(place);
  save();
  tinygltf::Model model;
  std::string text;
  ASSERT_TRUE(
      tinygltf::TinyGLTF().LoadBinaryFromFile(&model, &text, &text, path("map.glb")));
  ASSERT_EQ(model.nodes.size(), 1u);
  const tinygltf::Node& node = model.nodes[0];
  EXPECT_EQ(node.rotation, (std::vector<double>{1, 0, 0, 0}));
  const Eigen::Vector3d middle =
      turnedBack(Eigen::Vector3d::Map(node.translation.data()));
  EXPECT_LT((middle - place).norm(), 10);
  const int wall = model.meshes[0].primitives[0].attributes.at("POSITION");
  const auto& least = model.accessors[static_cast<std::size_t>(wall)].minValues;
  const auto& most = model.accessors[static_cast<std::size_t>(wall)].maxValues;
  EXPECT_EQ(Eigen::Vector3d::Map(least.data()) + middle - place,
            Eigen::Vector3d(-1, -1, 5));
  EXPECT_EQ(Eigen::Vector3d::Map(most.data()) + middle - place,
            Eigen::Vector3d(2, 1, 5));
}

TEST_F(MapFormats, PlyHasAVertexForEachKnownTexel)
{
  CompactMapOutputs outputs;
  outputs.obj = outputs.glb = false;
  outputs.vertex_ply = true;
  save(outputs);
  EXPECT_THAT(names_, testing::Not(testing::Contains("map.obj")));
  const PointCloudFile file = loadPointCloud(path("map.ply"));
  const TriangleMesh mesh = loadTriangleMesh(path("map.ply"));
  const auto areas = areasOf(map_);
  EXPECT_EQ(file.cloud.width, (areas[0] + areas[1] + areas[2]) * 100 - 1);
  double area = 0;
  const auto corner = [&](std::int32_t i) {
    Eigen::Vector3f p;
    std::memcpy(p.data(),
                &file.cloud.data[static_cast<std::size_t>(i) * file.cloud.point_step],
                sizeof(p));
    return p;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3f turn = (corner(b) - corner(a)).cross(corner(c) - corner(a));
    area += 0.5 * turn.norm();
    // Towards the room: the wall's to -z, the floor's to -y.
    EXPECT_LT(turn.y() + turn.z(), 0);
  }
  EXPECT_GT(area, 0.8 * (areas[0] + areas[1] + areas[2]));
  EXPECT_LT(area, areas[0] + areas[1] + areas[2]);
}

TEST_F(MapFormats, EmptyMap)
{
  map_ = {};
  CompactMapOutputs outputs;
  outputs.vertex_ply = true;
  save(outputs);
  EXPECT_EQ(names_.size(), 5u);
  tinygltf::Model model;
  std::string error;
  std::string warning;
  EXPECT_TRUE(tinygltf::TinyGLTF().LoadBinaryFromFile(
      &model, &error, &warning, path("map.glb")))
      << error;
  EXPECT_TRUE(model.meshes.empty());
  EXPECT_TRUE(loadCompactMap(path()).planes.empty());
}

} // namespace
} // namespace pcl::acmap::test
