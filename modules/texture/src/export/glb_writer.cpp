#include "export/map_writers.h"

#include <pcl/core/output_file.h>

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>

namespace pcl::acmap {

namespace {

/** Shares of the emitted and of the reflected colour. Their sum is 1, so that uniform
 * light shows the observed colours. KHR_materials_unlit would express this directly,
 * but VTK 9.1, and therefore f3d, shows the textures of such materials white. Readers
 * that do not support emission show the reflected share only. */
constexpr double emitted = 0.7, lit = 1 - emitted;

/** Middle of all points, rounded to whole metres; relative to it float precision
 * suffices. */
Eigen::Vector3d
middleOf(const std::vector<ChartSurface>& surfaces)
{
  Eigen::AlignedBox3d box;
  for (const ChartSurface& surface : surfaces)
    for (const Eigen::Vector3d& point : surface.points)
      box.extend(point);
  return box.isEmpty() ? Eigen::Vector3d::Zero()
                       : Eigen::Vector3d(box.center().array().round());
}

/** \brief The surfaces of one page of the atlas. */
struct PageMesh {
  std::vector<Eigen::Vector3f> points; ///< relative to the middle
  std::vector<Eigen::Vector2f> places; ///< texture coordinates, from the top left
  std::vector<std::uint32_t> corners;  ///< three of each triangle
};

/** Appends the triangles of a surface. */
void
append(const ChartSurface& surface, const Eigen::Vector3d& middle, PageMesh& mesh)
{
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  for (const Eigen::Vector3d& point : surface.points)
    mesh.points.emplace_back((point - middle).cast<float>());
  for (const TriangleMesh::Triangle& triangle : surface.triangles)
    for (const std::int32_t corner : triangle)
      mesh.corners.push_back(first + static_cast<std::uint32_t>(corner));
}

std::vector<PageMesh>
meshesOf(const std::vector<ChartSurface>& surfaces,
         const TextureAtlas& atlas,
         const Eigen::Vector3d& middle)
{
  std::vector<PageMesh> meshes(atlas.pages.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const ChartSurface& surface = surfaces[i];
    PageMesh& mesh = meshes[atlas.places[i].page];
    append(surface, middle, mesh);
    for (const Eigen::Vector2d& place : surface.places)
      mesh.places.emplace_back(atlas.coordinates(i, place).cast<float>());
  }
  return meshes;
}

/** All surfaces as one mesh without texture coordinates. */
PageMesh
meshOf(const std::vector<ChartSurface>& surfaces, const Eigen::Vector3d& middle)
{
  PageMesh mesh;
  for (const ChartSurface& surface : surfaces)
    append(surface, middle, mesh);
  return mesh;
}

/** \brief Fills a glTF model with the pages of an atlas, one by one. */
class GlbModel {
public:
  GlbModel(const CompactMap& map,
           const std::vector<ChartSurface>& surfaces,
           const std::vector<ChartSurface>& proposed,
           const TextureAtlas& atlas,
           int jpeg_quality)
  : map_(map)
  , quality_(jpeg_quality)
  , middle_(middleOf(surfaces))
  {
    model_.asset.version = "2.0";
    model_.asset.generator = "acmap";
    model_.asset.extras = tinygltf::Value(
        tinygltf::Value::Object{{"exposure", tinygltf::Value(map.exposure)}});
    model_.buffers.emplace_back();
    model_.meshes.emplace_back();
    const std::vector<PageMesh> meshes = meshesOf(surfaces, atlas, middle_);
    for (std::size_t page = 0; page < meshes.size(); ++page)
      if (!meshes[page].corners.empty())
        append(meshes[page], atlas.pages[page], page);
    if (model_.meshes[0].primitives.empty()) { // glTF forbids empty arrays
      model_.meshes.clear();
      model_.buffers.clear();
      return;
    }
    appendNode("map", 0);
    if (const PageMesh mesh = meshOf(proposed, middle_); !mesh.corners.empty())
      appendProposed(mesh);
    if (!map.details.mesh.triangles.empty())
      appendDetails(map.details);
    appendScene();
  }

  std::string
  bytes(const std::string& path)
  {
    constexpr std::size_t room_for_text = std::size_t{1} << 28;
    if (!model_.buffers.empty() &&
        model_.buffers[0].data.size() >
            std::numeric_limits<std::uint32_t>::max() - room_for_text)
      throw OutputFileException(shownPath(path) +
                                ": a GLB cannot be longer than 4 GiB");
    std::ostringstream stream;
    const bool is_written =
        tinygltf::TinyGLTF().WriteGltfSceneToStream(&model_, stream, false, true);
    if (!is_written || !stream) // a stream that runs out of memory becomes bad without
                                // throwing
      throw OutputFileException(shownPath(path) + ": could not be composed");
    return stream.str();
  }

private:
  void
  append(const PageMesh& mesh, const RgbImage& page, std::size_t number)
  {
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.attributes["POSITION"] = appendPoints(mesh.points);
    primitive.attributes["TEXCOORD_0"] = appendAccessor(mesh.places.data(),
                                                        mesh.places.size(),
                                                        TINYGLTF_COMPONENT_TYPE_FLOAT,
                                                        TINYGLTF_TYPE_VEC2);
    primitive.indices = appendCorners(mesh);
    primitive.material = appendMaterial(page, number);
    model_.meshes[0].primitives.push_back(primitive);
  }

  void
  appendProposed(const PageMesh& mesh)
  {
    using namespace proposed_layer;
    tinygltf::Material material;
    material.name = name;
    material.doubleSided = true;
    material.alphaMode = "BLEND";
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.roughnessFactor = 1;
    material.pbrMetallicRoughness.baseColorFactor = {red, green, blue, opacity};
    model_.materials.push_back(material);
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.attributes["POSITION"] = appendPoints(mesh.points);
    primitive.indices = appendCorners(mesh);
    primitive.material = static_cast<int>(model_.materials.size()) - 1;
    model_.meshes.emplace_back();
    model_.meshes.back().primitives.push_back(primitive);
    appendNode(name, static_cast<int>(model_.meshes.size()) - 1);
  }

  /** The colours of vertices are linear in glTF, and multiply the reflected colour only. */
  void
  appendDetails(const MapDetails& details)
  {
    tinygltf::Material material;
    material.name = "details";
    material.doubleSided = true;
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.roughnessFactor = 1;
    model_.materials.push_back(material);
    PageMesh mesh;
    for (const Eigen::Vector3f& point : details.vertices)
      mesh.points.emplace_back((point.cast<double>() - middle_).cast<float>());
    for (const TriangleMesh::Triangle& triangle : details.mesh.triangles)
      mesh.corners.insert(mesh.corners.end(), triangle.begin(), triangle.end());
    std::vector<std::array<std::uint16_t, 4>> colors;
    for (const auto& [red, green, blue] : details.colors)
      colors.push_back({linear(red), linear(green), linear(blue), opaque});
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.attributes["POSITION"] = appendPoints(mesh.points);
    primitive.attributes["COLOR_0"] =
        appendAccessor(colors.data(),
                       colors.size(),
                       TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                       TINYGLTF_TYPE_VEC4);
    model_.accessors.back().normalized = true;
    primitive.indices = appendCorners(mesh);
    primitive.material = static_cast<int>(model_.materials.size()) - 1;
    model_.meshes.emplace_back();
    model_.meshes.back().primitives.push_back(primitive);
    appendNode(material.name, static_cast<int>(model_.meshes.size()) - 1);
  }

  /** A level of sRGB, with the exposure of the map, as a linear share of 65535. */
  std::uint16_t
  linear(std::uint8_t level) const
  {
    const double share = std::min(map_.exposure * level / 255, 1.0);
    // IEC 61966-2-1
    const double light =
        share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    return static_cast<std::uint16_t>(std::lround(light * opaque));
  }

  int
  appendPoints(const std::vector<Eigen::Vector3f>& points)
  {
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3f& point : points)
      box.extend(point);
    const int accessor = appendAccessor(points.data(),
                                        points.size(),
                                        TINYGLTF_COMPONENT_TYPE_FLOAT,
                                        TINYGLTF_TYPE_VEC3);
    tinygltf::Accessor& limits = model_.accessors.back();
    limits.minValues.assign(box.min().data(), box.min().data() + 3);
    limits.maxValues.assign(box.max().data(), box.max().data() + 3);
    return accessor;
  }

  int
  appendCorners(const PageMesh& mesh)
  {
    if (mesh.points.size() >= std::numeric_limits<std::uint16_t>::max())
      return appendAccessor(mesh.corners.data(),
                            mesh.corners.size(),
                            TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                            TINYGLTF_TYPE_SCALAR);
    const std::vector<std::uint16_t> corners(mesh.corners.begin(), mesh.corners.end());
    return appendAccessor(corners.data(),
                          corners.size(),
                          TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                          TINYGLTF_TYPE_SCALAR);
  }

  /** Appends bytes to the buffer, aligned to a multiple of four. */
  int
  appendView(const void* data, std::size_t bytes, int target)
  {
    std::vector<unsigned char>& buffer = model_.buffers[0].data;
    buffer.resize((buffer.size() + 3) / 4 * 4);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = buffer.size();
    view.byteLength = bytes;
    view.target = target;
    const auto* const begin = static_cast<const unsigned char*>(data);
    buffer.insert(buffer.end(), begin, begin + bytes);
    model_.bufferViews.push_back(view);
    return static_cast<int>(model_.bufferViews.size()) - 1;
  }

  int
  appendAccessor(const void* data, std::size_t count, int component, int type)
  {
    const auto bytes_each = static_cast<std::size_t>(
        tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type)) *
        tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component)));
    tinygltf::Accessor accessor;
    accessor.bufferView =
        appendView(data,
                   count * bytes_each,
                   type == TINYGLTF_TYPE_SCALAR ? TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER
                                                : TINYGLTF_TARGET_ARRAY_BUFFER);
    accessor.componentType = component;
    accessor.type = type;
    accessor.count = count;
    model_.accessors.push_back(accessor);
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  int
  appendMaterial(const RgbImage& page, std::size_t number)
  {
    const int texture = appendTexture(page);
    tinygltf::Material material;
    material.name = "page_" + std::to_string(number);
    material.doubleSided = true;
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.roughnessFactor = 1;
    material.pbrMetallicRoughness.baseColorFactor = {lit, lit, lit, 1};
    material.pbrMetallicRoughness.baseColorTexture.index = texture;
    material.emissiveFactor.assign(3, emitted);
    material.emissiveTexture.index = texture;
    model_.materials.push_back(material);
    return static_cast<int>(model_.materials.size()) - 1;
  }

  int
  appendTexture(const RgbImage& page)
  {
    const std::vector<std::uint8_t> jpeg = encodeJpeg(page, quality_);
    tinygltf::Image image;
    image.mimeType = "image/jpeg";
    image.bufferView = appendView(jpeg.data(), jpeg.size(), 0);
    model_.images.push_back(image);
    if (model_.samplers.empty()) {
      tinygltf::Sampler sampler;
      sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
      sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
      sampler.wrapS = TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
      sampler.wrapT = TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
      model_.samplers.push_back(sampler);
    }
    tinygltf::Texture texture;
    texture.sampler = 0;
    texture.source = static_cast<int>(model_.images.size()) - 1;
    model_.textures.push_back(texture);
    return static_cast<int>(model_.textures.size()) - 1;
  }

  void
  appendNode(const std::string& name, int mesh)
  {
    const Eigen::Matrix3d turn = turnToYUp(map_);
    const Eigen::Quaterniond rotation(turn);
    const Eigen::Vector3d translation = turn * middle_;
    tinygltf::Node node;
    node.name = name;
    node.mesh = mesh;
    node.rotation.assign(rotation.coeffs().data(), rotation.coeffs().data() + 4);
    node.translation.assign(translation.data(), translation.data() + 3);
    model_.nodes.push_back(node);
  }

  void
  appendScene()
  {
    model_.scenes.emplace_back();
    for (std::size_t node = 0; node < model_.nodes.size(); ++node)
      model_.scenes[0].nodes.push_back(static_cast<int>(node));
    model_.defaultScene = 0;
  }

  static constexpr std::uint16_t opaque = std::numeric_limits<std::uint16_t>::max();

  const CompactMap& map_;
  int quality_;
  Eigen::Vector3d middle_;
  tinygltf::Model model_;
};

} // namespace

void
writeGlb(const std::string& path,
         const CompactMap& map,
         const std::vector<ChartSurface>& surfaces,
         const std::vector<ChartSurface>& proposed,
         const TextureAtlas& atlas,
         int quality)
{
  OutputFile file(path);
  const std::string bytes =
      GlbModel(map, surfaces, proposed, atlas, quality).bytes(path);
  file.write(bytes.data(), bytes.size());
  file.commit();
}

} // namespace pcl::acmap
