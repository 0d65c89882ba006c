#include "rgbd/camera_file.h"

#include "rgbd/text_rows.h"

#include <pcl/core/impl/yaml_node.h>

namespace pcl::acmap {

namespace {

constexpr double minimum_focus = 1e-6, maximum_pixels = 1e6;

} // namespace

SizedCamera
loadOpen3dCamera(const std::string& path)
{
  const YamlNode file = loadYaml(path); // JSON is YAML
  const std::vector<YamlNode>& matrix = file.at("intrinsic_matrix").list(9, 9);
  SizedCamera camera{{matrix[0].number(minimum_focus, maximum_pixels),
                      matrix[4].number(minimum_focus, maximum_pixels),
                      matrix[6].number(-maximum_pixels, maximum_pixels),
                      matrix[7].number(-maximum_pixels, maximum_pixels)},
                     {}};
  const YamlNode* const width = file.find("width");
  const YamlNode* const height = file.find("height");
  if (width && height)
    camera.size = {static_cast<std::int32_t>(width->number(1, maximum_pixels)),
                   static_cast<std::int32_t>(height->number(1, maximum_pixels))};
  return camera;
}

Pinhole
loadMatrixCamera(const std::string& path)
{
  const std::vector<TextRow> rows = loadTextRows(path);
  if (rows.size() < 3 || rows[0].words.size() < 3 || rows[1].words.size() < 3)
    throw InputFileException(path +
                             ": is no matrix of a camera: fx 0 cx, 0 fy cy, 0 0 1 "
                             "is needed");
  const Pinhole camera{numberOf(path, rows[0], 0),
                       numberOf(path, rows[1], 1),
                       numberOf(path, rows[0], 2),
                       numberOf(path, rows[1], 2)};
  if (!(camera.fx >= minimum_focus && camera.fy >= minimum_focus &&
        camera.fx <= maximum_pixels && camera.fy <= maximum_pixels))
    throw InputFileException(path + ": has a focal length that is none");
  return camera;
}

} // namespace pcl::acmap
