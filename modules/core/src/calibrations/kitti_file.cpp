#include "calibrations/calibration_kinds.h"
#include "calibrations/camera_values.h"

#include <array>

namespace pcl::acmap {

namespace {

constexpr std::array<const char*, 4> kitti_numbers = {"0", "1", "2", "3"};

bool
isKitti(const YamlNode& map)
{
  const auto isText = [&](const char* key) {
    const YamlNode* const node = map.find(key);
    return node && node->kind() == YamlNode::Kind::scalar;
  };
  return isText("P0") || isText("P2");
}

void
readKitti(const YamlNode& map, Calibration& calibration)
{
  for (const char* const number : kitti_numbers) {
    const std::string name = std::string("P") + number;
    if (const YamlNode* const projection = map.find(name))
      if (const auto view = rectifiedView(*projection))
        calibration.cameras.push_back({name, {}, view});
  }
}

bool
isKittiRaw(const YamlNode& map)
{
  return map.find("P_rect_00") || map.find("P_rect_02");
}

/** \brief The pose in the rectified frame of camera 0: T_02 and R_02 map its points,
 * before rectification, to camera 2. */
CalibratedView
readKittiCamera(const YamlNode& map, const std::string& id)
{
  const YamlNode& matrix = map.at("K_" + id);
  CalibratedView view = viewOf(Eigen::Matrix3d(matrixOf(matrix, 3, 3)), matrix);
  setDistortion("", numbersOf(map.at("D_" + id)), map.at("D_" + id), view.camera);
  Eigen::Isometry3d T_camera_first = Eigen::Isometry3d::Identity();
  T_camera_first.linear() = rotationOf(map.at("R_" + id));
  T_camera_first.translation() = matrixOf(map.at("T_" + id), 3, 1);
  setPose(T_camera_first.inverse(), view);
  if (const YamlNode* const size = map.find("S_" + id))
    readSize(*size, view);
  return view;
}

void
readKittiRaw(const YamlNode& map, Calibration& calibration)
{
  for (const char* const number : kitti_numbers) {
    const std::string id = std::string("0") + number;
    const YamlNode* const projection = map.find("P_rect_" + id);
    if (!projection)
      continue;
    std::optional<CalibratedView> rectified = rectifiedView(*projection);
    if (const YamlNode* const size = map.find("S_rect_" + id); size && rectified)
      readSize(*size, *rectified);
    std::optional<CalibratedView> built;
    if (map.find("K_" + id))
      built = readKittiCamera(map, id);
    calibration.cameras.push_back({std::string("P") + number, built, rectified});
  }
}

} // namespace

const CalibrationKind kitti_kind{
    "KITTI's calib.txt",
    "P has -fx times the camera's place along x, metres, for rectified images",
    isKitti,
    readKitti};

const CalibrationKind kitti_raw_kind{
    "KITTI's calib_cam_to_cam.txt",
    "P_rect has -fx times the camera's place along x, metres, for rectified images",
    isKittiRaw,
    readKittiRaw};

} // namespace pcl::acmap
