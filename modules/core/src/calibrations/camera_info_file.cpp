#include "calibrations/calibration_kinds.h"
#include "calibrations/camera_values.h"

namespace pcl::acmap {

namespace {

/** \brief A matrix that has one name in files of camera_calibration, and others in
 * messages of ROS 1 and ROS 2. */
const YamlNode*
findNamed(const YamlNode& map, const char* in_file, const char* ros1, const char* ros2)
{
  for (const char* const key : {in_file, ros1, ros2})
    if (const YamlNode* const node = map.find(key))
      return node;
  return nullptr;
}

bool
isCameraInfo(const YamlNode& map)
{
  return findNamed(map, "camera_matrix", "K", "k") &&
         (findNamed(map, "projection_matrix", "P", "p") ||
          map.find("distortion_model") || map.find("distortion_coefficients"));
}

std::string
cameraNameIn(const YamlNode& map)
{
  const YamlNode* const name = map.find("camera_name");
  return name ? name->text().substr(0, 40) : "camera";
}

CalibratedView
readCameraMatrixAndDistortion(const YamlNode& map)
{
  const YamlNode& matrix = *findNamed(map, "camera_matrix", "K", "k");
  CalibratedView view = viewOf(Eigen::Matrix3d(matrixOf(matrix, 3, 3)), matrix);
  const YamlNode* const model = map.find("distortion_model");
  const YamlNode* const distortion =
      findNamed(map, "distortion_coefficients", "D", "d");
  setDistortion(model && model->kind() == YamlNode::Kind::scalar ? model->text() : "",
                distortion ? numbersOf(*distortion) : std::vector<double>(),
                model ? *model : matrix,
                view.camera);
  return view;
}

/** A camera of a rectified pair knows its place by its projection, and its orientation
 * by its rectification. */
void
readCameraInfo(const YamlNode& map, Calibration& calibration)
{
  CalibratedCamera camera{cameraNameIn(map), readCameraMatrixAndDistortion(map), {}};
  const bool is_message = !map.find("image_width");
  const std::string width = is_message ? "width" : "image_width";
  const std::string height = is_message ? "height" : "image_height";
  readSize(map, width, height, *camera.built);
  if (const YamlNode* const node = findNamed(map, "projection_matrix", "P", "p"))
    camera.rectified = rectifiedView(*node);
  if (camera.rectified) {
    readSize(map, width, height, *camera.rectified);
    Eigen::Isometry3d T_shared_camera = camera.rectified->camera.T_reference_camera;
    if (const YamlNode* const node = findNamed(map, "rectification_matrix", "R", "r"))
      T_shared_camera.linear() = rotationOf(*node).transpose();
    setPose(T_shared_camera, *camera.built);
  }
  calibration.cameras.push_back(camera);
}

} // namespace

const CalibrationKind camera_info_kind{
    "ROS' camera_info",
    "projection_matrix of the right camera has -fx times the baseline, metres",
    isCameraInfo,
    readCameraInfo};

} // namespace pcl::acmap
