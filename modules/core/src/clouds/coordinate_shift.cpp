#include "clouds/coordinate_shift.h"

#include <pcl/core/impl/map_shift.h>
#include <pcl/core/impl/size_text.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace pcl::acmap {

namespace {

/** Are these metres from the middle of the Earth, near its surface? Those of a grid have
 * heights, and are below this distance or not as high. */
bool
isGeocentric(const Eigen::Vector3d& metres)
{
  constexpr double least = 6.33e6, most = 6.41e6, highest = 1e4;
  return metres.norm() > least && metres.norm() < most &&
         std::abs(metres.z()) > highest;
}

} // namespace

void
CoordinateSample::add(const Eigen::Vector3d& point)
{
  if (!point.allFinite() || isAt<Eigen::Vector3d>(point, Eigen::Vector3d::Zero()))
    return;
  for (std::size_t axis = 0; axis < 3; ++axis)
    values_[axis].push_back(point[static_cast<Eigen::Index>(axis)]);
}

Eigen::Vector3d
CoordinateSample::shift(const CloudStatement& stated) const
{
  constexpr double farthest = 10000, step = 1000, absurd = 1e8; // metres
  if (stated.shift)
    return *stated.shift / stated.scale;
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  for (std::size_t axis = 0; axis < 3 && size() > 0; ++axis) {
    std::vector<double> values = values_[axis];
    std::sort(values.begin(), values.end());
    const std::size_t tenth = values.size() / 10;
    const double low = values[tenth] * stated.scale,
                 high = values[values.size() - 1 - tenth] * stated.scale,
                 middle = values[values.size() / 2] * stated.scale;
    if ((low > farthest || high < -farthest) && std::abs(middle) < absurd)
      shift[static_cast<Eigen::Index>(axis)] =
          step * std::floor(middle / step) / stated.scale;
  }
  return shift;
}

void
setShift(const Eigen::Vector3d& shift,
         const CloudStatement& stated,
         PointCloudFile& file)
{
  file.shift = shift;
  if (shift.isZero(0))
    return;
  const Eigen::Vector3d metres = shift * stated.scale;
  file.remarks.push_back("its coordinates are those of the file less " +
                         shiftText(metres) + ", so that they keep their millimetres");
  if (!isGeocentric(metres)) {
    if (shift.z() == 0)
      file.usual_up = Eigen::Vector3f::UnitZ(); // grids of surveys have heights
    return;
  }
  file.up = metres.normalized().cast<float>();
  file.remarks.emplace_back(
      "its coordinates are geocentric: up is away from the middle "
      "of the Earth");
}

void
remarkLostDigits(const Eigen::Vector3d& shift,
                 const CloudStatement& stated,
                 PointCloudFile& file)
{
  const double farthest = (shift * stated.scale).cwiseAbs().maxCoeff();
  if (farthest > 0)
    file.remarks.push_back(
        "its coordinates are float32 and " + shortNumber(farthest) +
        " m from the origin: they were rounded to steps of about " +
        shortNumber(farthest * double{std::numeric_limits<float>::epsilon()}) +
        " m when the file was written");
}

void
noteShift(const FieldLayout& layout, const CloudStatement& stated, PointCloudFile& file)
{
  if (layout.shift.isZero(0))
    return;
  setShift(layout.shift, stated, file);
  if (!layout.narrows)
    remarkLostDigits(layout.shift, stated, file);
}

Eigen::Vector3d
shiftOfPlaces(const std::vector<Eigen::Vector3d>& places,
              const std::optional<Eigen::Vector3d>& stated)
{
  CoordinateSample sample;
  for (const Eigen::Vector3d& place : places)
    sample.add(place);
  return sample.shift({1, stated, {}, false});
}

std::string
shiftText(const Eigen::Vector3d& shift)
{
  std::string text;
  for (const double metres : shift) {
    std::array<char, 40> number{};
    std::snprintf(number.data(), number.size(), "%.10g", metres + 0.0);
    text += (text.empty() ? "" : ", ") + std::string(number.data());
  }
  return text;
}

} // namespace pcl::acmap
