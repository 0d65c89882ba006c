#include "calibrations/calibration_kinds.h"
#include "calibrations/camera_values.h"

#include <initializer_list>

namespace pcl::acmap {

namespace {

constexpr double largest_json_value = 1e6;

using JsonNames = std::initializer_list<const char*>;

const YamlNode*
findAny(const YamlNode& map, JsonNames names)
{
  for (const char* const name : names)
    if (const YamlNode* const node = map.find(name))
      return node;
  return nullptr;
}

double
jsonValue(const YamlNode& map, JsonNames names)
{
  const YamlNode* const node = findAny(map, names);
  return (node ? *node : map.at(*names.begin()))
      .number(-largest_json_value, largest_json_value);
}

/** \brief The map that has the camera: the document, or one in it. */
const YamlNode&
cameraInJson(const YamlNode& map)
{
  for (const char* const name : {"camera", "intrinsic", "intrinsics"})
    if (const YamlNode* const node = map.find(name);
        node && node->kind() == YamlNode::Kind::map)
      return *node;
  return map;
}

bool
isCameraJson(const YamlNode& map)
{
  const YamlNode& camera = cameraInJson(map);
  return findAny(camera, {"intrinsic_matrix", "fx", "fl_x"}) != nullptr;
}

/** Open3D writes the matrix column by column. */
CalibratedView
readOpen3dMatrix(const YamlNode& node)
{
  Eigen::Matrix3d matrix = matrixOf(node, 3, 3);
  if (matrix(2, 0) != 0.0 || matrix(2, 1) != 0.0)
    matrix.transposeInPlace();
  return viewOf(matrix, node);
}

CalibratedView
readJsonValues(const YamlNode& map)
{
  CalibratedView view = viewOf(jsonValue(map, {"fx", "fl_x"}),
                               jsonValue(map, {"fy", "fl_y"}),
                               jsonValue(map, {"cx", "ppx"}),
                               jsonValue(map, {"cy", "ppy"}),
                               map);
  const YamlNode* const model = findAny(map, {"model", "distortion_model"});
  const YamlNode* const coefficients = findAny(map, {"coeffs", "distortion"});
  setDistortion(model ? model->text() : "",
                coefficients ? numbersOf(*coefficients) : std::vector<double>(),
                map,
                view.camera);
  return view;
}

void
readCameraJson(const YamlNode& map, Calibration& calibration)
{
  const YamlNode& camera = cameraInJson(map);
  const YamlNode* const matrix = camera.find("intrinsic_matrix");
  CalibratedView view = matrix ? readOpen3dMatrix(*matrix) : readJsonValues(camera);
  readSize(camera, "width", "height", view);
  readSize(camera, "w", "h", view);
  for (const char* const key : {"depth_scale", "scale"})
    if (const YamlNode* const scale = findAny(camera, {key}))
      if (const double number = scale->number(0, largest_json_value); number >= 1.0)
        calibration.depth_scale = number;
  calibration.cameras.push_back({"camera", {}, view});
  if (view.camera.distortion != std::array<double, 5>{})
    std::swap(calibration.cameras.front().built, calibration.cameras.front().rectified);
  else if (const YamlNode* const baseline = findAny(camera, {"baseline"}))
    addNeighbour(baseline->number(-largest_json_value, largest_json_value),
                 calibration);
}

} // namespace

const CalibrationKind camera_json_kind{"JSON of one camera",
                                       "fx, fy, cx, cy in pixels, a matrix of Open3D "
                                       "column by column, baseline to the right "
                                       "in metres",
                                       isCameraJson,
                                       readCameraJson};

} // namespace pcl::acmap
