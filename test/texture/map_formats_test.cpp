#include "temporary_folder.h"
#include "textured_map.h"

#include <pcl/core/impl/rigid_alignment.h>
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
#include <sstream>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

Eigen::Vector3d
vectorOf(const aiVector3D& v)
{
  return {v.x, v.y, v.z};
}

/** From the frame of OBJ and glTF (y up) to that of the map (y down). */
Eigen::Vector3d
turnedBack(const Eigen::Vector3d& v)
{
  return {v.x(), -v.y(), -v.z()};
}

class MapFormats : public testing::Test {
protected:
  void
  save(CompactMapOutputs outputs = {})
  {
    outputs.color_tolerance = 0;
    names_ = saveCompactMap(path(), map_, outputs);
  }

  /** The folder name contains a space, as users' folders do. */
  std::string
  path(const std::string& name = "") const
  {
    return folder_.path("my map" + (name.empty() ? "" : "/" + name));
  }

  /** The image of a mesh's material according to assimp; empty if there is none. */
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

  /** Checks that an image is a page with all charts; all charts are on the first page.
   * \param[in] tolerance of the mean difference of the colours */
  void
  expectPage(const RgbImage& page, double tolerance) const
  {
    for (const TextureChart& chart : map_.charts) {
      const Eigen::Vector2i place = chart.image_place.value();
      double sum = 0;
      for (std::int32_t row = 0; row < chart.colors.height; ++row)
        for (std::int32_t column = 0; column < chart.colors.width; ++column)
          for (std::size_t k = 0; k < 3; ++k)
            sum += std::abs(page.at(place.x() + column, place.y() + row)[k] -
                            chart.colors.at(column, row)[k]);
      EXPECT_LE(sum, tolerance * static_cast<double>(chart.colors.values.size()));
    }
  }

  /** The chart in whose part of the page the middle of a triangle is, whose coordinates
   * become those in the chart. */
  std::size_t
  enterChart(const RgbImage& page, ReadTriangle& triangle) const
  {
    const Eigen::Vector2d size(page.width, page.height);
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& place : triangle.places)
      middle += place.cwiseProduct(size) / 3;
    for (std::size_t i = 0; i < map_.charts.size(); ++i) {
      const RgbImage& colors = map_.charts[i].colors;
      const Eigen::Vector2d first = map_.charts[i].image_place.value().cast<double>();
      const Eigen::Vector2d own(colors.width, colors.height);
      if ((middle.array() < first.array()).any() ||
          (middle.array() > (first + own).array()).any())
        continue;
      for (Eigen::Vector2d& place : triangle.places)
        place = (place.cwiseProduct(size) - first).cwiseQuotient(own);
      return i;
    }
    return no_chart;
  }

  /** Triangles in the frame of the map. */
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
      const RgbImage page = imageOf(*scene, mesh);
      EXPECT_GT(page.width, 0) << "without an image";
      expectPage(page, tolerance);
      for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        EXPECT_EQ(mesh.mFaces[i].mNumIndices, 3u);
        ReadTriangle triangle;
        for (int corner = 0; corner < 3; ++corner) {
          const unsigned vertex = mesh.mFaces[i].mIndices[corner];
          triangle.corners[corner] = turnedBack(vectorOf(mesh.mVertices[vertex]));
          if (mesh.HasTextureCoords(0)) // assimp's origin is bottom left
            triangle.places[corner] = {mesh.mTextureCoords[0][vertex].x,
                                       1 - mesh.mTextureCoords[0][vertex].y};
        }
        triangle.chart = enterChart(page, triangle);
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
  EXPECT_THAT(names_, testing::Contains("texture_0.jpg"));
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
  EXPECT_LE(count("\nv "), 8u + 6 + 9 + 3); // tiles add at most three vertices
  EXPECT_EQ(count("\nv "), count("\nvt "));
  EXPECT_EQ(count("usemtl page_0\n"), 1u);
  EXPECT_EQ(count("usemtl"), 1u);
  EXPECT_EQ(text.find(folder_.path("")), std::string::npos);
  EXPECT_THAT(contentOf(path("map.mtl")), HasSubstr("map_Kd texture_0.png\n"));
}

TEST_F(MapFormats, CylindersAreDrawnAsFacets)
{
  save();
  const std::string before = contentOf(path("map.obj"));
  CylinderPatch column;
  column.axis_direction = Eigen::Vector3d::UnitY();
  column.axis_u = Eigen::Vector3d::UnitZ();
  column.axis_v = Eigen::Vector3d::UnitX();
  column.radius = 0.25;
  column.low = -1;
  column.high = 1;
  column.arc = 2 * M_PI;
  map_.cylinders = {column};
  save();
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(path("map.obj").c_str());
  reader->Update();
  vtkPolyData* const mesh = reader->GetOutput();
  double area = 0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
    area += static_cast<vtkTriangle*>(mesh->GetCell(i))->ComputeArea();
  double wanted = 2 * M_PI * 0.25 * 2;
  for (const double part : areasOf(map_))
    wanted += part;
  EXPECT_NEAR(area, wanted, 0.02);
  EXPECT_THAT(contentOf(path("map.obj")), HasSubstr("# cylinder 0\n"));
  EXPECT_EQ(loadCompactMap(path()).cylinders.size(), 1U);

  TexturePicture& picture = map_.cylinder_pictures.emplace_back();
  picture.colors = {16, 8, std::vector<std::uint8_t>(3 * 16 * 8, 90)};
  for (std::size_t i = 0; i < 8; ++i) // the left half is red
    for (std::size_t column = 0; column < 8; ++column)
      picture.colors.values[3 * (16 * i + column)] = 200;
  picture.kinds.assign(16 * 8, TexelKind::Seen);
  picture.kinds[0] = TexelKind::None;
  save();
  const TexturePicture back = loadCompactMap(path()).cylinder_pictures.at(0);
  ASSERT_EQ(back.colors.values.size(), picture.colors.values.size());
  EXPECT_EQ(back.kinds, picture.kinds);
  for (const int column : {1, 14})
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(back.colors.at(column, 4)[k], picture.colors.at(column, 4)[k], 2);
  reader->Modified();
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), mesh->GetNumberOfCells());

  map_.cylinders.clear();
  map_.cylinder_pictures.clear();
  save();
  EXPECT_EQ(contentOf(path("map.obj")), before);
}

/** Viewers add ambient and diffuse light: frontal surfaces must not be too bright. */
TEST_F(MapFormats, MaterialsOfObjAddUpToTheColours)
{
  save();
  std::istringstream lines(contentOf(path("map.mtl")));
  double ambient = 0, diffuse = 0;
  std::size_t materials = 0;
  for (std::string word; lines >> word;) {
    if (word == "Ka")
      lines >> ambient;
    if (word != "Kd")
      continue;
    lines >> diffuse;
    ++materials;
    EXPECT_NEAR(ambient + diffuse, 1, 1e-9);
    EXPECT_GT(diffuse, 0.3);
  }
  EXPECT_EQ(materials, 1U);
}

TEST_F(MapFormats, GlbIsReadByAssimp)
{
  save();
  expectSurfaces(readByAssimp("map.glb", 3), map_);
}

TEST_F(MapFormats, GlbIsReadByTinygltf)
{
  map_ = makeTexturedMap({3000, -40, 1e4});
  map_.exposure = 1.25;
  save();
  tinygltf::Model model;
  std::string error;
  std::string warning;
  ASSERT_TRUE(tinygltf::TinyGLTF().LoadBinaryFromFile(
      &model, &error, &warning, path("map.glb")))
      << error;
  EXPECT_EQ(error + warning, "");
  ASSERT_EQ(model.meshes.size(), 1u);
  EXPECT_EQ(model.meshes[0].primitives.size(), 1u);
  ASSERT_EQ(model.images.size(), 1u);
  const RgbImage page = loadRgbImage(path("texture_0.png"));
  EXPECT_EQ(model.images[0].width, page.width);
  EXPECT_EQ(model.images[0].height, page.height);
  EXPECT_EQ(model.images[0].mimeType, "image/jpeg");
  EXPECT_EQ(model.asset.extras.Get("exposure").GetNumberAsDouble(), map_.exposure);
  ASSERT_EQ(model.materials.size(), 1u);
  for (const tinygltf::Material& material : model.materials) {
    EXPECT_TRUE(material.doubleSided);
    EXPECT_EQ(material.pbrMetallicRoughness.metallicFactor, 0);
    EXPECT_EQ(material.pbrMetallicRoughness.roughnessFactor, 1);
  }
}

/** Uniform light shows the observed colours, and they are visible without light. VTK
 * 9.1 shows the textures of KHR_materials_unlit white. */
TEST_F(MapFormats, GlbShowsItsTexturesWithoutExtensions)
{
  save();
  tinygltf::Model model;
  std::string text;
  ASSERT_TRUE(
      tinygltf::TinyGLTF().LoadBinaryFromFile(&model, &text, &text, path("map.glb")));
  EXPECT_TRUE(model.extensionsUsed.empty());
  EXPECT_TRUE(model.extensionsRequired.empty());
  std::size_t textured = 0;
  for (const tinygltf::Material& material : model.materials) {
    EXPECT_TRUE(material.extensions.empty());
    const auto& surface = material.pbrMetallicRoughness;
    EXPECT_EQ(material.emissiveTexture.index, surface.baseColorTexture.index);
    textured += surface.baseColorTexture.index >= 0;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_GE(surface.baseColorFactor[i], 0.25);
      EXPECT_GE(material.emissiveFactor[i], 0.5);
      EXPECT_NEAR(surface.baseColorFactor[i] + material.emissiveFactor[i], 1, 1e-9);
    }
  }
  EXPECT_EQ(textured, 1u);
}

TEST_F(MapFormats, UpIsUpInObjAndGlb)
{
  // a scanned room with z up: its floor is larger than its walls
  const Eigen::Quaterniond turn = // from the frame of the camera
      smallestRotation(-Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ());
  const double areas[] = {5.5, 6, 6};
  map_.trajectory = {};
  map_.charts.clear();
  for (std::size_t i = 0; i < map_.planes.size(); ++i) {
    PlanePatch& plane = map_.planes[i];
    plane.area = areas[i];
    plane.coefficients.head<3>() = turn * plane.coefficients.head<3>().eval();
    for (Eigen::Vector3f& point : plane.polygons[0].outer)
      point = turn.cast<float>() * point;
    plane.polygons[0].holes.clear();
  }
  save();
  for (const char* name : {"map.obj", "map.glb"}) {
    double floor = 0, ceiling = 0;
    for (const ReadTriangle& triangle : readByAssimp(name, 0)) {
      const auto& c = triangle.corners;
      const Eigen::Vector3d facing =
          turnedBack((c[1] - c[0]).cross(c[2] - c[0])).normalized();
      if (std::abs(facing.y()) < 0.5)
        continue;
      (facing.y() > 0 ? floor : ceiling) = turnedBack(c[0]).y();
    }
    EXPECT_NEAR(floor, -1, 1e-5) << name;
    EXPECT_NEAR(ceiling, 1, 1e-5) << name;
  }
  EXPECT_THAT(contentOf(path("map.obj")), HasSubstr("y up: these are x, z, -y of"));
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
  const auto& minimum = model.accessors[static_cast<std::size_t>(wall)].minValues;
  const auto& maximum = model.accessors[static_cast<std::size_t>(wall)].maxValues;
  EXPECT_EQ(Eigen::Vector3d::Map(minimum.data()) + middle - place,
            Eigen::Vector3d(-1, -1, 1));
  EXPECT_EQ(Eigen::Vector3d::Map(maximum.data()) + middle - place,
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
    // Towards the room: -z for the wall, -y for the floor.
    EXPECT_LT(turn.y() + turn.z(), 0);
  }
  EXPECT_GT(area, 0.8 * (areas[0] + areas[1] + areas[2]));
  EXPECT_LT(area, areas[0] + areas[1] + areas[2]);
}

/** A layer of its own: half transparent, without texture, beside the same surfaces. */
TEST_F(MapFormats, ProposedSurfacesAreALayer)
{
  save();
  const std::string plain = contentOf(path("map.obj"));
  map_.planes[0].proposed = {
      {{{0, 0, 5}, {0, 0.5F, 5}, {1, 0.5F, 5}, {1, 0, 5}}, {}}}; // its hole
  save();
  const std::string text = contentOf(path("map.obj"));
  ASSERT_EQ(text.substr(0, plain.size()), plain);
  const std::string layer = text.substr(plain.size());
  EXPECT_THAT(layer, testing::StartsWith("g proposed\nusemtl proposed\n"));
  EXPECT_THAT(layer, testing::Not(HasSubstr("vt ")));
  EXPECT_THAT(contentOf(path("map.mtl")), HasSubstr("newmtl proposed\n"));
  EXPECT_THAT(contentOf(path("map.mtl")), HasSubstr("\nd 0.35\n"));
  EXPECT_EQ(loadCompactMap(path()).planes[0].proposed.size(), 1u);

  tinygltf::Model model;
  std::string fault;
  ASSERT_TRUE(
      tinygltf::TinyGLTF().LoadBinaryFromFile(&model, &fault, &fault, path("map.glb")));
  EXPECT_EQ(fault, "");
  ASSERT_EQ(model.nodes.size(), 2u);
  EXPECT_EQ(model.scenes[0].nodes, (std::vector<int>{0, 1}));
  EXPECT_EQ(model.nodes[0].name, "map");
  const tinygltf::Node& node = model.nodes[1];
  EXPECT_EQ(node.name, "proposed");
  EXPECT_EQ(node.translation, model.nodes[0].translation);
  const auto& primitive =
      model.meshes[static_cast<std::size_t>(node.mesh)].primitives.at(0);
  EXPECT_EQ(primitive.attributes.count("TEXCOORD_0"), 0u);
  const auto& material = model.materials[static_cast<std::size_t>(primitive.material)];
  EXPECT_EQ(material.alphaMode, "BLEND");
  EXPECT_LT(material.pbrMetallicRoughness.baseColorFactor[3], 0.5);

  for (const char* name : {"map.obj", "map.glb"}) {
    Assimp::Importer importer;
    const aiScene* const scene =
        importer.ReadFile(path(name), aiProcess_PreTransformVertices);
    ASSERT_TRUE(scene) << importer.GetErrorString();
    double area = 0;
    for (unsigned k = 0; k < scene->mNumMeshes; ++k) {
      const aiMesh& mesh = *scene->mMeshes[k];
      float opacity = 1;
      scene->mMaterials[mesh.mMaterialIndex]->Get(AI_MATKEY_OPACITY, opacity);
      const auto corner = [&](unsigned face, unsigned i) {
        return vectorOf(mesh.mVertices[mesh.mFaces[face].mIndices[i]]);
      };
      for (unsigned i = 0; opacity < 1 && i < mesh.mNumFaces; ++i)
        area +=
            (corner(i, 1) - corner(i, 0)).cross(corner(i, 2) - corner(i, 0)).norm() / 2;
    }
    EXPECT_NEAR(area, 0.5, 1e-5) << name;
  }
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
