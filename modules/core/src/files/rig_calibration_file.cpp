#include "files/rig_text.h"
#include "files/text_number.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/file_format.h>
#include <pcl/core/output_file.h>
#include <pcl/core/rig_cameras.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace pcl {

namespace {

using acmap::camera_keys;

/** \brief Describes why a calibration does not match a rectified rig; empty if it does.
 */
std::string
faultUnder(const TrinocularRig& rig, const RigCalibration& calibration)
{
  if (rig.width != calibration.width || rig.height != calibration.height)
    return "the rectified rig and its cameras differ in size";
  for (const RigCamera camera : {RigCamera::Horizontal, RigCamera::Vertical})
    if (calibration.camera(camera).is_there != acmap::hasCamera(rig, camera))
      return "a camera must be there exactly when its baseline is not 0";
  return "";
}

using MatrixValue = std::function<double(int row, int column)>;

std::string
matrixText(const char* key, int rows, int columns, const MatrixValue& value)
{
  std::string text =
      "  " + std::string(key) + ": !!opencv-matrix\n    rows: " + std::to_string(rows) +
      "\n    cols: " + std::to_string(columns) + "\n    dt: d\n    data: [";
  for (int row = 0; row < rows; ++row) {
    text += row > 0 ? ",\n      " : " ";
    for (int column = 0; column < columns; ++column)
      text += (column > 0 ? ", " : "") + acmap::textOf(value(row, column));
  }
  return text + " ]\n";
}

Eigen::Matrix3d
cameraMatrix(const CameraCalibration& camera)
{
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  matrix(0, 0) = camera.focal_x;
  matrix(1, 1) = camera.focal_y;
  matrix(0, 2) = camera.center_x;
  matrix(1, 2) = camera.center_y;
  return matrix;
}

std::string
cameraText(const char* key, const CameraCalibration& camera)
{
  const Eigen::Matrix3d matrix = cameraMatrix(camera);
  return std::string(key) + ":\n" + matrixText("camera_matrix", 3, 3, matrix) +
         matrixText("distortion",
                    1,
                    5,
                    [&](int, int i) {
                      return camera.distortion[static_cast<std::size_t>(i)];
                    }) +
         matrixText("pose", 4, 4, camera.T_reference_camera.matrix());
}

/** \brief Reads the data of a matrix and checks its numbers of rows and columns.
 * \param[in] largest maximum magnitude of a value */
std::vector<double>
readMatrix(const acmap::YamlNode& node,
           std::size_t rows,
           std::size_t columns,
           double largest)
{
  node.at("rows").count(rows, rows);
  node.at("cols").count(columns, columns);
  std::vector<double> values;
  for (const acmap::YamlNode& value :
       node.at("data").list(rows * columns, rows * columns))
    values.push_back(value.number(-largest, largest));
  return values;
}

void
readCameraMatrix(const acmap::YamlNode& node, CameraCalibration& camera)
{
  const std::vector<double> values =
      readMatrix(node, 3, 3, acmap::longest_camera_focal_length);
  camera.focal_x = values[0];
  camera.center_x = values[2];
  camera.focal_y = values[4];
  camera.center_y = values[5];
  if (camera.focal_x < 1.0 || camera.focal_y < 1.0)
    node.fail("a focal length is below 1 px");
  const Eigen::Matrix3d rows_as_columns = Eigen::Map<const Eigen::Matrix3d>(&values[0]);
  if (rows_as_columns.transpose() != cameraMatrix(camera))
    node.fail("is not of the form fx, 0, cx, 0, fy, cy, 0, 0, 1");
}

/** \brief OpenCV writes the five coefficients as a row or as a column. */
void
readDistortion(const acmap::YamlNode& node, CameraCalibration& camera)
{
  const bool is_row = node.at("rows").count(1, 5) == 1;
  const std::vector<double> values = readMatrix(
      node, is_row ? 1 : 5, is_row ? 5 : 1, acmap::largest_camera_distortion);
  std::copy(values.begin(), values.end(), camera.distortion.begin());
}

void
readPose(const acmap::YamlNode& node, CameraCalibration& camera, bool is_reference)
{
  const std::vector<double> values =
      readMatrix(node, 4, 4, acmap::longest_camera_baseline);
  const Eigen::Matrix4d rows_as_columns = Eigen::Map<const Eigen::Matrix4d>(&values[0]);
  camera.T_reference_camera.matrix() = rows_as_columns.transpose();
  const std::string fault =
      acmap::faultOfPlace(camera.T_reference_camera, is_reference);
  if (!fault.empty())
    node.fail(fault);
}

CameraCalibration
readCamera(const acmap::YamlNode& node, bool is_reference)
{
  CameraCalibration camera;
  camera.is_there = true;
  readCameraMatrix(node.at("camera_matrix"), camera);
  readDistortion(node.at("distortion"), camera);
  readPose(node.at("pose"), camera, is_reference);
  return camera;
}

} // namespace

RigCalibration
acmap::readRigCalibration(const std::string& name, const YamlNode& map)
{
  requireFormat(map, file_formats::rig);
  RigCalibration calibration;
  calibration.width = static_cast<int>(map.at("width").count(1, longest_camera_side));
  calibration.height = static_cast<int>(map.at("height").count(1, longest_camera_side));
  for (std::size_t i = 0; i < camera_keys.size(); ++i)
    if (const YamlNode* const node = map.find(camera_keys[i]))
      calibration.cameras[i] = readCamera(*node, i == 0);
  if (!calibration.camera(RigCamera::Reference).is_there)
    throw InputFileException(name + ": has no 'camera_reference', so only a rectified "
                                    "rig; the cameras come from pcl_rig_calibration");
  const std::string fault = faultUnder(readTrinocularRig(map), calibration);
  if (!fault.empty())
    throw InputFileException(name + ": " + fault);
  return calibration;
}

RigCalibration
loadRigCalibration(const std::string& path)
{
  return acmap::readRigCalibration(path, acmap::loadYaml(path));
}

std::string
acmap::rigCalibrationText(const TrinocularRig& rig, const RigCalibration& calibration)
{
  requireSoundRig(rig);
  requireSoundCalibration(calibration);
  const std::string fault = faultUnder(rig, calibration);
  if (!fault.empty())
    throw acmap::BadArgument(fault);
  std::string text = rigText(rig);
  for (std::size_t i = 0; i < camera_keys.size(); ++i)
    if (calibration.cameras[i].is_there)
      text += cameraText(camera_keys[i], calibration.cameras[i]);
  return text;
}

void
saveRigCalibration(const std::string& path,
                   const TrinocularRig& rig,
                   const RigCalibration& calibration)
{
  const std::string text = acmap::rigCalibrationText(rig, calibration);
  acmap::OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

} // namespace pcl
