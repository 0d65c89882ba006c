#include "calibrations/calibration_kinds.h"
#include "calibrations/camera_values.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl::acmap {

namespace {

constexpr double millimetre = 1e-3;

bool
isMiddlebury(const YamlNode& map)
{
  return map.find("cam0") && map.find("cam1");
}

/** The rows of both are the same, the principal points may differ by doffs. */
void
readMiddlebury(const YamlNode& map, Calibration& calibration)
{
  const double baseline = map.at("baseline").number(0.0, 1e6) * millimetre;
  for (const char* const name : {"cam0", "cam1"}) {
    const YamlNode& matrix = map.at(name);
    CalibratedView view = viewOf(Eigen::Matrix3d(matrixOf(matrix, 3, 3)), matrix);
    readSize(map, "width", "height", view);
    const double place = calibration.cameras.empty() ? 0.0 : baseline;
    setPose(Eigen::Isometry3d(Eigen::Translation3d(place, 0, 0)), view);
    calibration.cameras.push_back({name, {}, view});
  }
  const double between = calibration.cameras[1].rectified->camera.center_x -
                         calibration.cameras[0].rectified->camera.center_x;
  constexpr double printed_digits = 0.01; // px
  if (const YamlNode* const doffs = map.find("doffs"))
    if (!(std::abs(doffs->number(-1e6, 1e6) - between) <= printed_digits))
      doffs->fail("is not the difference of the principal points of cam1 and cam0");
}

bool
isPlain(const YamlNode& map)
{
  return map.find("numbers") != nullptr;
}

Eigen::Matrix3d
squareInNumbers(const std::vector<double>& numbers, std::size_t stride)
{
  Eigen::Matrix3d matrix;
  for (Eigen::Index row = 0; row < 3; ++row)
    for (Eigen::Index column = 0; column < 3; ++column)
      matrix(row, column) = numbers[static_cast<std::size_t>(row) * stride +
                                    static_cast<std::size_t>(column)];
  return matrix;
}

/** A matrix of 3 x 3, 3 x 4 or 4 x 4, or fx fy cx cy; the first may have a baseline. */
void
readPlain(const YamlNode& map, Calibration& calibration)
{
  const YamlNode& node = map.at("numbers");
  const std::vector<double> numbers = numbersOf(node);
  const std::size_t count = numbers.size();
  CalibratedView view;
  if (count == 4)
    view = viewOf(numbers[0], numbers[1], numbers[2], numbers[3], node);
  else if (count == 9 || count == 10)
    view = viewOf(squareInNumbers(numbers, 3), node);
  else if (count == 12 || count == 16)
    view = viewOf(squareInNumbers(numbers, 4), node);
  else
    node.fail("has " + std::to_string(count) +
              " numbers; a camera has 4 (fx fy cx cy), 9 (3 x 3), 10 (and a baseline), "
              "12 (3 x 4) or 16 (4 x 4)");
  calibration.cameras.push_back({"camera", {}, view});
  if (count == 10 && numbers.back() != 0.0)
    addNeighbour(numbers.back(), calibration);
  for (const std::size_t i : {3U, 7U, 11U})
    if (count >= 12 && numbers[i] != 0.0)
      node.fail("has a fourth column that is not 0: give the camera matrix alone");
}

} // namespace

std::string
yamlOfMiddlebury(const std::string& text)
{
  std::istringstream lines(text);
  std::string yaml;
  std::string line;
  while (std::getline(lines, line)) {
    std::replace(line.begin(), line.end(), '\r', ' ');
    std::replace(line.begin(), line.end(), ';', ',');
    for (const char bracket : {'[', ']'})
      std::replace(line.begin(), line.end(), bracket, ' ');
    const std::size_t sign = line.find('=');
    yaml += (sign == std::string::npos ? line : line.replace(sign, 1, ": ")) + "\n";
  }
  return yaml;
}

std::string
yamlOfNumbers(const std::string& text)
{
  std::istringstream lines(text);
  std::string yaml = "numbers:";
  std::string line;
  while (std::getline(lines, line)) {
    line.resize(std::min(line.size(), line.find('#')));
    std::replace_if(
        line.begin(),
        line.end(),
        [](char c) { return c == '[' || c == ']' || c == '\r' || c == '\t'; },
        ' ');
    yaml += " " + line;
  }
  return yaml + "\n";
}

const CalibrationKind middlebury_kind{
    "Middlebury's calib.txt",
    "baseline in millimetres, cam1 is right of cam0, rectified, doffs is cx1 - cx0",
    isMiddlebury,
    readMiddlebury};

const CalibrationKind plain_matrix_kind{
    "a camera matrix as text",
    "row by row, then the baseline to the right neighbour in metres, rectified",
    isPlain,
    readPlain};

} // namespace pcl::acmap
