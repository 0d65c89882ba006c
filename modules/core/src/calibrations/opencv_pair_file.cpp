#include "calibrations/calibration_kinds.h"
#include "calibrations/camera_values.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace pcl::acmap {

namespace {

/** OpenCV names no keys: these are the names that programs give, in lower case and
 * without separators; one of a camera has a side before or after it. */
using OpenCvNames = std::vector<std::string>;
const OpenCvNames matrix_names = {"m",
                                  "k",
                                  "cameramatrix",
                                  "cammatrix",
                                  "camera",
                                  "cm",
                                  "mtx",
                                  "matrix",
                                  "intrinsic",
                                  "intrinsics",
                                  "intrinsicmatrix",
                                  "intrinsicsmatrix"};
const OpenCvNames distortion_names = {"d",
                                      "dist",
                                      "distcoeff",
                                      "distcoeffs",
                                      "distcoef",
                                      "distcoefs",
                                      "distortion",
                                      "distortioncoefficients",
                                      "distortioncoeffs",
                                      "distortionparameters",
                                      "distortionvector"};
const OpenCvNames rectification_names = {
    "r", "rect", "rectification", "rectificationmatrix", "rectificationtransform"};
const OpenCvNames projection_names = {
    "p", "proj", "projection", "projectionmatrix", "newcameramatrix"};
const OpenCvNames rotation_names = {
    "r", "rot", "rotation", "rotationmatrix", "rmat", "rstereo"};
const OpenCvNames translation_names = {
    "t", "trans", "translation", "translationvector", "tvec", "tmat", "tstereo"};

/** How the two cameras are told apart, the reference first. */
struct Sides {
  std::array<const char*, 2> marks;
};
constexpr std::array<Sides, 4> all_sides = {
    {{{"left", "right"}}, {{"l", "r"}}, {{"1", "2"}}, {{"0", "1"}}}};

std::string
plainKey(const std::string& key)
{
  std::string plain;
  for (const char c : key)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return plain;
}

/** \brief The value whose key is one of the names with a mark before or after it. */
const YamlNode*
findOpenCv(const YamlNode& map, const OpenCvNames& names, const std::string& mark)
{
  for (const std::string& name : names)
    for (const YamlNode& key : map.keys())
      if (const std::string plain = plainKey(key.text());
          plain == name + mark || plain == mark + name)
        return map.find(key.text());
  return nullptr;
}

const Sides*
sidesOf(const YamlNode& map)
{
  for (const Sides& sides : all_sides)
    if (std::all_of(sides.marks.begin(), sides.marks.end(), [&](const char* mark) {
          return findOpenCv(map, matrix_names, mark) ||
                 findOpenCv(map, projection_names, mark);
        }))
      return &sides;
  return nullptr;
}

bool
isOpenCvPair(const YamlNode& map)
{
  return sidesOf(map) != nullptr;
}

void
readSizeOfPair(const YamlNode& map, CalibratedView& view)
{
  for (const YamlNode& key : map.keys()) {
    const std::string plain = plainKey(key.text());
    const YamlNode* const value = map.find(key.text());
    if ((plain == "imagesize" || plain == "size" || plain == "resolution") &&
        value->kind() == YamlNode::Kind::list)
      readSize(*value, view);
  }
  readSize(map, "width", "height", view);
  readSize(map, "image_width", "image_height", view);
  readSize(map, "imageWidth", "imageHeight", view);
  readSize(map, "LEFT.width", "LEFT.height", view);
}

CalibratedCamera
readOpenCvCamera(const YamlNode& map, const char* mark)
{
  CalibratedCamera camera{mark, {}, {}};
  if (const YamlNode* const matrix = findOpenCv(map, matrix_names, mark)) {
    CalibratedView view = viewOf(Eigen::Matrix3d(matrixOf(*matrix, 3, 3)), *matrix);
    if (const YamlNode* const distortion = findOpenCv(map, distortion_names, mark))
      setDistortion("", numbersOf(*distortion), *distortion, view.camera);
    readSizeOfPair(map, view);
    camera.built = view;
  }
  if (const YamlNode* const projection = findOpenCv(map, projection_names, mark))
    camera.rectified = rectifiedView(*projection);
  if (camera.rectified)
    readSizeOfPair(map, *camera.rectified);
  return camera;
}

/** stereoCalibrate's R and T map points of the first camera to the second. */
void
setPosesByMotion(const YamlNode& rotation,
                 const YamlNode& translation,
                 Calibration& calibration)
{
  Eigen::Isometry3d T_second_first = Eigen::Isometry3d::Identity();
  const bool is_vector = numbersOf(rotation).size() == 3;
  if (is_vector) {
    const Eigen::Vector3d turn = matrixOf(rotation, 3, 1);
    T_second_first.linear() =
        Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()).toRotationMatrix();
  }
  else
    T_second_first.linear() = rotationOf(rotation);
  T_second_first.translation() = matrixOf(translation, 3, 1);
  setPose(Eigen::Isometry3d::Identity(), *calibration.cameras[0].built);
  setPose(T_second_first.inverse(), *calibration.cameras[1].built);
}

/** Without R and T, the rectification tells how the cameras are turned and where. */
void
setPoseByRectification(const YamlNode& map, CalibratedCamera& camera)
{
  const YamlNode* const rectification =
      findOpenCv(map, rectification_names, camera.name.c_str());
  if (!rectification || !camera.rectified)
    return;
  Eigen::Isometry3d T_shared_camera = camera.rectified->camera.T_reference_camera;
  T_shared_camera.linear() = rotationOf(*rectification).transpose();
  setPose(T_shared_camera, *camera.built);
}

void
readOpenCvPair(const YamlNode& map, Calibration& calibration)
{
  const Sides& sides = *sidesOf(map);
  for (const char* const mark : sides.marks)
    calibration.cameras.push_back(readOpenCvCamera(map, mark));
  if (!calibration.cameras[0].built || !calibration.cameras[1].built)
    return;
  const YamlNode* const rotation = findOpenCv(map, rotation_names, "");
  const YamlNode* const translation = findOpenCv(map, translation_names, "");
  if (rotation && translation)
    setPosesByMotion(*rotation, *translation, calibration);
  else
    for (CalibratedCamera& camera : calibration.cameras)
      setPoseByRectification(map, camera);
  const bool has_places =
      calibration.cameras[0].built->has_pose && calibration.cameras[1].built->has_pose;
  const bool has_rectified =
      calibration.cameras[0].rectified && calibration.cameras[1].rectified;
  if (!has_places && !has_rectified)
    map.fail(
        std::string(!rotation      ? "R, the rotation from the first camera to "
                                     "the second,"
                    : !translation ? "T, the translation from the first camera "
                                     "to the second,"
                                   : "P1 and P2") +
        " is missing; where it is in a file of its own, --rig INTRINSICS EXTRINSICS "
        "names both");
}

} // namespace

bool
areOpenCvHalves(const YamlNode& intrinsics, const YamlNode& extrinsics)
{
  return sidesOf(intrinsics) && !findOpenCv(intrinsics, translation_names, "") &&
         findOpenCv(extrinsics, translation_names, "");
}

const CalibrationKind opencv_pair_kind{
    "OpenCV's stereo calibration",
    "R and T map points of the first camera to the second, P2 has -fx times the "
    "baseline, metres",
    isOpenCvPair,
    readOpenCvPair};

} // namespace pcl::acmap
