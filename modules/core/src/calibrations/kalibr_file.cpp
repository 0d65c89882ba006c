#include "calibrations/calibration_kinds.h"
#include "calibrations/camera_values.h"

#include <algorithm>

namespace pcl::acmap {

namespace {

constexpr std::size_t most_kalibr_cameras = 16;

std::string
optionalText(const YamlNode& map, const char* key)
{
  const YamlNode* const node = map.find(key);
  return node ? node->text() : std::string();
}

bool
isKalibr(const YamlNode& map)
{
  const YamlNode* const first = map.find("cam0");
  return first && first->kind() == YamlNode::Kind::map;
}

/** \brief The camera of Kalibr and of EuRoC without its pose.
 * \param[in] distortion key of the coefficients */
CalibratedView
readKalibrCamera(const YamlNode& map, const char* distortion)
{
  // Both names, as the other models have other numbers of intrinsics.
  CameraCalibration unused;
  setDistortion(optionalText(map, "camera_model"), {}, map.at("camera_model"), unused);
  const YamlNode& intrinsics = map.at("intrinsics");
  const Eigen::MatrixXd four = matrixOf(intrinsics, 1, 4);
  CalibratedView view = viewOf(four(0), four(1), four(2), four(3), intrinsics);
  setDistortion(map.at("distortion_model").text(),
                numbersOf(map.at(distortion)),
                map.at("distortion_model"),
                view.camera);
  if (const YamlNode* const size = map.find("resolution"))
    readSize(*size, view);
  return view;
}

void
readKalibr(const YamlNode& map, Calibration& calibration)
{
  Eigen::Isometry3d T_first_camera = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < most_kalibr_cameras; ++i) {
    const std::string name = "cam" + std::to_string(i);
    const YamlNode* const camera = map.find(name);
    if (!camera)
      break;
    CalibratedView view = readKalibrCamera(*camera, "distortion_coeffs");
    if (i > 0)
      T_first_camera = T_first_camera * motionOf(camera->at("T_cn_cnm1")).inverse();
    setPose(T_first_camera, view);
    calibration.cameras.push_back({name, view, {}});
  }
}

bool
isEuroc(const YamlNode& map)
{
  return map.find("T_BS") && map.find("intrinsics");
}

void
readEuroc(const YamlNode& map, Calibration& calibration)
{
  CalibratedView view = readKalibrCamera(map, "distortion_coefficients");
  setPose(motionOf(map.at("T_BS")), view);
  calibration.cameras.push_back({"camera", view, {}});
}

} // namespace

const CalibrationKind kalibr_kind{
    "Kalibr's camchain",
    "T_cn_cnm1 maps points of the camera before to this one, metres",
    isKalibr,
    readKalibr};

const CalibrationKind euroc_kind{
    "EuRoC's sensor.yaml",
    "T_BS is the camera's pose in the body's frame, metres",
    isEuroc,
    readEuroc};

} // namespace pcl::acmap
