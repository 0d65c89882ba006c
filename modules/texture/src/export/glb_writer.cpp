#include "export/map_writers.h"

#include <pcl/core/output_file.h>

#include <tiny_gltf.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>

namespace pcl::acmap {

namespace {

constexpr double linear_grey = 0.2159; // linear value of 128 in sRGB

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

/** \brief Fills a glTF model with surfaces, one by one. */
class GlbModel {
public:
  GlbModel(const CompactMap& map,
           const std::vector<ChartSurface>& surfaces,
           int jpeg_quality)
  : map_(map)
  , quality_(jpeg_quality)
  , middle_(middleOf(surfaces))
  {
    model_.asset.version = "2.0";
    model_.asset.generator = "acmap";
    model_.buffers.emplace_back();
    model_.meshes.emplace_back();
    for (const ChartSurface& surface : surfaces)
      if (!surface.triangles.empty())
        append(surface);
    if (model_.meshes[0].primitives.empty()) { // glTF forbids empty arrays
      model_.meshes.clear();
      model_.buffers.clear();
      return;
    }
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
  append(const ChartSurface& surface)
  {
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.attributes["POSITION"] = appendPoints(surface);
    if (surface.chart != ChartSurface::no_chart)
      primitive.attributes["TEXCOORD_0"] = appendPlaces(surface);
    primitive.indices = appendAccessor(surface.triangles.data(),
                                       surface.triangles.size() * 3,
                                       TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                                       TINYGLTF_TYPE_SCALAR);
    primitive.material = surface.chart == ChartSurface::no_chart
                             ? greyMaterial()
                             : appendTexture(map_.charts[surface.chart]);
    model_.meshes[0].primitives.push_back(primitive);
  }

  int
  appendPoints(const ChartSurface& surface)
  {
    std::vector<Eigen::Vector3f> points;
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3d& point : surface.points) {
      points.emplace_back((point - middle_).cast<float>());
      box.extend(points.back());
    }
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
  appendPlaces(const ChartSurface& surface)
  {
    const RgbImage& image = map_.charts[surface.chart].colors;
    const Eigen::Array2d size(image.width, image.height);
    std::vector<Eigen::Vector2f> places;
    for (const Eigen::Vector2d& place : surface.places)
      places.emplace_back((place.array() / size).cast<float>());
    return appendAccessor(places.data(),
                          places.size(),
                          TINYGLTF_COMPONENT_TYPE_FLOAT,
                          TINYGLTF_TYPE_VEC2);
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

  /** \param[in] level linear grey value, or factor of the texture, within [0, 1] */
  int
  appendMaterial(const std::string& name, double level)
  {
    tinygltf::Material material;
    material.name = name;
    material.doubleSided = true;
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.roughnessFactor = 1;
    material.pbrMetallicRoughness.baseColorFactor = {
        lit * level, lit * level, lit * level, 1};
    material.emissiveFactor.assign(3, emitted * level);
    model_.materials.push_back(material);
    return static_cast<int>(model_.materials.size()) - 1;
  }

  int
  greyMaterial()
  {
    if (grey_ < 0)
      grey_ = appendMaterial("untextured", linear_grey);
    return grey_;
  }

  int
  appendTexture(const TextureChart& chart)
  {
    const std::vector<std::uint8_t> jpeg = encodeJpeg(withGrey(chart), quality_);
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
    const int index = static_cast<int>(model_.textures.size()) - 1;
    const int material = appendMaterial(chart.image, 1);
    model_.materials.back().pbrMetallicRoughness.baseColorTexture.index = index;
    model_.materials.back().emissiveTexture.index = index;
    return material;
  }

  void
  appendScene()
  {
    const Eigen::Matrix3d turn = turnToYUp(map_);
    const Eigen::Quaterniond rotation(turn);
    const Eigen::Vector3d translation = turn * middle_;
    tinygltf::Node node;
    node.name = "map";
    node.mesh = 0;
    node.rotation.assign(rotation.coeffs().data(), rotation.coeffs().data() + 4);
    node.translation.assign(translation.data(), translation.data() + 3);
    model_.nodes.push_back(node);
    model_.scenes.emplace_back();
    model_.scenes[0].nodes = {0};
    model_.defaultScene = 0;
  }

  const CompactMap& map_;
  int quality_;
  Eigen::Vector3d middle_;
  int grey_ = -1;
  tinygltf::Model model_;
};

} // namespace

void
writeGlb(const std::string& path,
         const CompactMap& map,
         const std::vector<ChartSurface>& surfaces,
         int quality)
{
  OutputFile file(path);
  const std::string bytes = GlbModel(map, surfaces, quality).bytes(path);
  file.write(bytes.data(), bytes.size());
  file.commit();
}

} // namespace pcl::acmap
