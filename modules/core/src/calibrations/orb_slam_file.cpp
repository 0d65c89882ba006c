#include "calibrations/calibration_kinds.h"
#include "calibrations/camera_values.h"

#include "files/rig_text.h"

namespace pcl::acmap {

namespace {

constexpr double largest_orb_slam_value = 1e6; // px, or px m

double
orbSlamValue(const YamlNode& map, const std::string& key)
{
  return map.at(key).number(-largest_orb_slam_value, largest_orb_slam_value);
}

/** \brief Camera.fx, Camera.k1 and so on; of ORB-SLAM3 Camera1.fx. */
CalibratedView
readOrbSlamCamera(const YamlNode& map, const std::string& prefix)
{
  const auto at = [&](const char* key) { return orbSlamValue(map, prefix + key); };
  CalibratedView view =
      viewOf(at("fx"), at("fy"), at("cx"), at("cy"), map.at(prefix + "fx"));
  std::vector<double> coefficients;
  for (const char* const key : {"k1", "k2", "p1", "p2", "k3", "k4"})
    coefficients.push_back(map.find(prefix + key) ? at(key) : 0.0);
  const YamlNode* const type = map.find("Camera.type");
  const std::string model = type ? type->text() : "";
  setDistortion(model == "Rectified" ? "pinhole" : model,
                coefficients,
                type ? *type : map.at(prefix + "fx"),
                view.camera);
  readSize(map, "Camera.width", "Camera.height", view);
  return view;
}

/** \brief A camera whose images are rectified: a neighbour has the same view. */
bool
isUndistorted(const CalibratedView& view)
{
  return view.camera.distortion == std::array<double, 5>{};
}

CalibratedCamera
orbSlamCamera(const CalibratedView& view)
{
  return isUndistorted(view) ? CalibratedCamera{"Camera", {}, view}
                             : CalibratedCamera{"Camera", view, {}};
}

void
readOrbSlamScale(const YamlNode& map, const char* key, Calibration& calibration)
{
  if (map.find(key) && orbSlamValue(map, key) > 0.0)
    calibration.depth_scale = orbSlamValue(map, key);
}

bool
isOrbSlam(const YamlNode& map)
{
  return map.find("Camera.fx") != nullptr;
}

/** Settings for unrectified stereo have the matrices LEFT.K, LEFT.D, LEFT.R, LEFT.P. */
void
readOrbSlam(const YamlNode& map, Calibration& calibration)
{
  readOrbSlamScale(map, "DepthMapFactor", calibration);
  if (map.find("LEFT.K")) {
    opencv_pair_kind.read(map, calibration);
    return;
  }
  const CalibratedView view = readOrbSlamCamera(map, "Camera.");
  calibration.cameras.push_back(orbSlamCamera(view));
  for (const char* const key : {"Camera.bf", "Camera.focal_x_baseline"})
    if (isUndistorted(view) && map.find(key))
      addNeighbour(orbSlamValue(map, key) / view.camera.focal_x, calibration);
}

bool
isStella(const YamlNode& map)
{
  const YamlNode* const camera = map.find("Camera");
  return camera && camera->kind() == YamlNode::Kind::map && camera->find("fx");
}

/** The keys of ORB-SLAM in a map of their own. */
void
readStella(const YamlNode& map, Calibration& calibration)
{
  const YamlNode& camera = map.at("Camera");
  CalibratedView view = readOrbSlamCamera(camera, "");
  readSize(camera, "cols", "rows", view);
  if (const YamlNode* const model = camera.find("model");
      model && model->text() != "perspective")
    setDistortion(model->text(), {}, *model, view.camera);
  calibration.cameras.push_back(orbSlamCamera(view));
  if (isUndistorted(view) && camera.find("focal_x_baseline"))
    addNeighbour(orbSlamValue(camera, "focal_x_baseline") / view.camera.focal_x,
                 calibration);
}

bool
isOrbSlam3(const YamlNode& map)
{
  return map.find("Camera1.fx") != nullptr;
}

void
readOrbSlam3(const YamlNode& map, Calibration& calibration)
{
  readOrbSlamScale(map, "RGBD.DepthMapFactor", calibration);
  CalibratedView view = readOrbSlamCamera(map, "Camera1.");
  if (const YamlNode* const T_first_second = map.find("Stereo.T_c1_c2")) {
    setPose(Eigen::Isometry3d::Identity(), view);
    CalibratedView neighbour = readOrbSlamCamera(map, "Camera2.");
    setPose(motionOf(*T_first_second), neighbour);
    calibration.cameras = {{"Camera1", view, {}}, {"Camera2", neighbour, {}}};
    return;
  }
  calibration.cameras.push_back(orbSlamCamera(view));
  if (isUndistorted(view) && map.find("Stereo.b"))
    addNeighbour(orbSlamValue(map, "Stereo.b"), calibration);
}

} // namespace

const CalibrationKind orb_slam_kind{
    "ORB-SLAM's settings",
    "Camera.bf is the baseline in metres times fx, the reference is the left camera",
    isOrbSlam,
    readOrbSlam};

const CalibrationKind stella_kind{
    "stella_vslam's settings",
    "focal_x_baseline is the baseline in metres times fx, the reference is the left "
    "camera",
    isStella,
    readStella};

const CalibrationKind orb_slam3_kind{
    "ORB-SLAM3's settings",
    "Stereo.T_c1_c2 is the pose of Camera2, Stereo.b the baseline, metres",
    isOrbSlam3,
    readOrbSlam3};

} // namespace pcl::acmap
