#include "calibrations/camera_values.h"

#include "files/rig_text.h"
#include "files/text_number.h"

#include <pcl/core/trajectory.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace pcl::acmap {

namespace {

constexpr double largest_calibration_number = 1e9;
constexpr std::size_t most_numbers = 64;
constexpr double printed_digits = 1e-3; // of rotations

void
appendNumbers(const YamlNode& node, int depth, std::vector<double>& numbers)
{
  if (node.kind() == YamlNode::Kind::list && depth < 3) {
    for (const YamlNode& value : node.list(0, most_numbers))
      appendNumbers(value, depth + 1, numbers);
    return;
  }
  if (node.kind() != YamlNode::Kind::scalar)
    node.fail("numbers are needed here");
  Words words(node.text(), Words::Separators::blanks_and_commas);
  std::string_view word;
  while (words.next(word)) {
    double number = 0;
    if (!parseNumber(word, number) || !(std::abs(number) <= largest_calibration_number))
      node.fail(inQuotes(word) + " is no number of a calibration");
    numbers.push_back(number);
    if (numbers.size() > most_numbers)
      node.fail("has more numbers than a calibration");
  }
}

Eigen::Matrix3d
exactRotation(const Eigen::Matrix3d& printed, const YamlNode& node)
{
  if (!(printed * printed.transpose()).isIdentity(printed_digits) ||
      !(printed.determinant() > 0.0))
    node.fail("is no rotation");
  if (printed.isIdentity(0.0))
    return printed;
  return Eigen::Quaterniond(printed).normalized().toRotationMatrix();
}

std::string
loweredModel(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return c == '-' || c == ' ' ? '_' : static_cast<char>(std::tolower(c));
  });
  return text;
}

bool
isBrownConrady(const std::string& model)
{
  for (const char* name : {"",
                           "none",
                           "null",
                           "pinhole",
                           "plumb_bob",
                           "radtan",
                           "radial_tangential",
                           "rational_polynomial",
                           "brown_conrady",
                           "distortion.brown_conrady",
                           "opencv"})
    if (model == name)
      return true;
  return false;
}

/** Models of the RealSense whose coefficients mean something else. */
bool
isRealSense(const std::string& model)
{
  return model.find("brown_conrady") != std::string::npos;
}

} // namespace

std::vector<double>
numbersOf(const YamlNode& node)
{
  std::vector<double> numbers;
  if (node.kind() != YamlNode::Kind::map) {
    appendNumbers(node, 0, numbers);
    return numbers;
  }
  appendNumbers(node.at("data"), 0, numbers);
  const std::size_t rows = node.at("rows").count(0, most_numbers);
  const std::size_t columns = node.at("cols").count(0, most_numbers);
  if (numbers.size() != rows * columns)
    node.fail("has " + std::to_string(numbers.size()) + " numbers for " +
              std::to_string(rows) + " x " + std::to_string(columns));
  return numbers;
}

Eigen::MatrixXd
matrixOf(const YamlNode& node, int rows, int columns)
{
  const std::vector<double> numbers = numbersOf(node);
  if (numbers.size() != static_cast<std::size_t>(rows * columns))
    node.fail(std::to_string(rows) + " x " + std::to_string(columns) +
              " numbers are needed here, not " + std::to_string(numbers.size()));
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const Rows>(numbers.data(), rows, columns);
}

Eigen::Matrix3d
rotationOf(const YamlNode& node)
{
  return exactRotation(matrixOf(node, 3, 3), node);
}

Eigen::Isometry3d
motionOf(const YamlNode& node)
{
  const bool has_last_row = numbersOf(node).size() == 16;
  const Eigen::MatrixXd printed = matrixOf(node, has_last_row ? 4 : 3, 4);
  if (has_last_row && printed.row(3) != Eigen::RowVector4d(0, 0, 0, 1))
    node.fail("is no rigid motion: its last row is not 0 0 0 1");
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = exactRotation(printed.topLeftCorner<3, 3>(), node);
  motion.translation() = printed.topRightCorner<3, 1>();
  return motion;
}

CalibratedView
viewOf(double fx, double fy, double cx, double cy, const YamlNode& node)
{
  constexpr double farthest_center = 1e6;
  const auto isFocal = [](double f) {
    return f >= 1.0 && f <= longest_camera_focal_length;
  };
  if (!isFocal(fx) || !isFocal(fy))
    node.fail("focal lengths " + textOf(fx) + " and " + textOf(fy) +
              " are refused: they must be within [1, 1e+06] px");
  if (!(std::abs(cx) <= farthest_center && std::abs(cy) <= farthest_center))
    node.fail("the principal point is farther than 1e+06 px away");
  CalibratedView view;
  view.camera.is_there = true;
  view.camera.focal_x = fx;
  view.camera.focal_y = fy;
  view.camera.center_x = cx;
  view.camera.center_y = cy;
  return view;
}

CalibratedView
viewOf(const Eigen::Matrix3d& matrix, const YamlNode& node)
{
  constexpr double largest_skew = 1e-3; // of the focal length
  const Eigen::RowVector3d last(0, 0, 1);
  if (matrix(1, 0) != 0.0 || matrix.row(2) != last ||
      !(std::abs(matrix(0, 1)) <= largest_skew * std::abs(matrix(0, 0))))
    node.fail("is no camera matrix fx 0 cx, 0 fy cy, 0 0 1");
  return viewOf(matrix(0, 0), matrix(1, 1), matrix(0, 2), matrix(1, 2), node);
}

std::optional<CalibratedView>
rectifiedView(const YamlNode& projection)
{
  const ProjectionMatrix matrix = matrixOf(projection, 3, 4);
  const Eigen::Matrix3d camera = matrix.leftCols<3>();
  if (camera.isZero(0.0))
    return std::nullopt;
  CalibratedView view = viewOf(camera, projection);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = -(camera.inverse() * matrix.col(3));
  setPose(pose, view);
  return view;
}

void
setDistortion(const std::string& model,
              const std::vector<double>& coefficients,
              const YamlNode& node,
              CameraCalibration& camera)
{
  const std::string name = loweredModel(model);
  const auto from = [&](std::size_t first) {
    return std::any_of(coefficients.begin() + static_cast<std::ptrdiff_t>(
                                                  std::min(first, coefficients.size())),
                       coefficients.end(),
                       [](double value) { return value != 0.0; });
  };
  if (!isBrownConrady(name) && !(isRealSense(name) && !from(0)))
    node.fail(
        "the camera model " + inQuotes(model) +
        " is not read: a pinhole with Brown-Conrady distortion (radtan, plumb_bob) "
        "is needed; undistort the images with the program that calibrated them");
  if (from(camera.distortion.size()))
    node.fail(
        "has more coefficients than k1, k2, p1, p2, k3 of the Brown-Conrady model "
        "(a rational or thin prism model), which are not read; calibrate with five");
  for (const double value : coefficients)
    if (!(std::abs(value) <= largest_camera_distortion))
      node.fail(textOf(value) + " is no coefficient of a distortion");
  std::copy_n(coefficients.begin(),
              std::min(coefficients.size(), camera.distortion.size()),
              camera.distortion.begin());
}

void
setPose(const Eigen::Isometry3d& T_shared_camera, CalibratedView& view)
{
  view.camera.T_reference_camera = T_shared_camera;
  view.has_pose = true;
}

void
readSize(const YamlNode& map,
         const std::string& width,
         const std::string& height,
         CalibratedView& view)
{
  if (!map.find(width) || !map.find(height))
    return;
  const auto side = [&](const std::string& key) {
    // Written as 1.242000e+03 by KITTI, and 0 where it is not known.
    return static_cast<int>(
        std::lround(map.at(key).number(0, static_cast<double>(longest_camera_side))));
  };
  view.width = side(width);
  view.height = side(height);
  if (view.width == 0 || view.height == 0)
    view.width = view.height = 0;
}

void
readSize(const YamlNode& list, CalibratedView& view)
{
  const std::vector<double> sides = numbersOf(list);
  const auto isSide = [](double side) {
    return side >= 1 && side <= static_cast<double>(longest_camera_side);
  };
  if (sides.size() != 2 || !isSide(sides[0]) || !isSide(sides[1]))
    list.fail("width and height are needed here, within [1, 32768] px");
  view.width = static_cast<int>(std::lround(sides[0]));
  view.height = static_cast<int>(std::lround(sides[1]));
}

void
addNeighbour(double baseline, Calibration& calibration)
{
  CalibratedView& reference = *calibration.cameras.front().rectified;
  setPose(Eigen::Isometry3d::Identity(), reference);
  CalibratedView neighbour = reference;
  setPose(Eigen::Isometry3d(Eigen::Translation3d(baseline, 0, 0)), neighbour);
  calibration.cameras.push_back({"its right neighbour", {}, neighbour});
}

} // namespace pcl::acmap
