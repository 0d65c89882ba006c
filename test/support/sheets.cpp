#include "clouds.h"

#include <pcl/core/random.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

/** Samples a sheet; \a place maps (u, v, height) to a 3D point. */
template <typename Place>
SheetCloud
sampleSheet(const SheetSampling& sampling, const Place& place)
{
  Random random(sampling.seed);
  SheetCloud sheet;
  sheet.spacing = sampling.spacing;
  sheet.maximum =
      Eigen::Vector2d(sampling.columns - 1, sampling.rows - 1) / 2 * sampling.spacing;
  sheet.minimum = -sheet.maximum;
  const double reach = sampling.jitter * sampling.spacing;
  for (int row = 0; row < sampling.rows; ++row)
    for (int column = 0; column < sampling.columns; ++column) {
      const double u =
          sheet.minimum.x() + column * sampling.spacing + random.uniform(-reach, reach);
      const double v =
          sheet.minimum.y() + row * sampling.spacing + random.uniform(-reach, reach);
      const double height = sampling.noise * sampling.spacing * random.normal();
      sheet.parameters.emplace_back(u, v);
      sheet.cloud.push_back(toPoint(place(u, v, height)));
    }
  return sheet;
}

} // namespace

SheetCloud
makeJitteredPlane(const SheetSampling& sampling)
{
  return makeFoldedPlane(sampling, 0);
}

SheetCloud
makeFoldedPlane(const SheetSampling& sampling, double fold)
{
  return sampleSheet(sampling, [&](double u, double v, double height) {
    const double angle = u > 0 ? fold : 0;
    return Eigen::Vector3d(u * std::cos(angle) - height * std::sin(angle),
                           v,
                           u * std::sin(angle) + height * std::cos(angle));
  });
}

SheetCloud
makeGradedPlane(const SheetSampling& sampling, double growth)
{
  Random random(sampling.seed);
  SheetCloud sheet;
  const double width = sampling.rows * sampling.spacing;
  double u = 0;
  for (int column = 0; column < sampling.columns; ++column) {
    const double spacing =
        sampling.spacing * std::pow(growth, double(column) / (sampling.columns - 1));
    const int rows = static_cast<int>(std::lround(width / spacing));
    const double reach = sampling.jitter * spacing;
    for (int row = 0; row < rows; ++row) {
      const double v = (row + 0.5) * width / rows + random.uniform(-reach, reach);
      const Eigen::Vector2d place(u + random.uniform(-reach, reach), v);
      sheet.parameters.push_back(place);
      sheet.cloud.push_back(
          toPoint({place.x(), place.y(), sampling.noise * spacing * random.normal()}));
    }
    sheet.maximum = {u, width};
    sheet.spacing = spacing;
    u += spacing;
  }
  return sheet;
}

SheetCloud
makeSphereCap(const SheetSampling& sampling, double radius)
{
  return sampleSheet(sampling, [&](double u, double v, double height) {
    const double angle = std::hypot(u, v) / radius;
    const double azimuth = std::atan2(v, u);
    return Eigen::Vector3d((radius + height) *
                           Eigen::Vector3d(std::sin(angle) * std::cos(azimuth),
                                           std::sin(angle) * std::sin(azimuth),
                                           std::cos(angle)));
  });
}

Cloud
makeParallelSheets(const SheetSampling& sampling, double distance)
{
  Cloud cloud = makeJitteredPlane(sampling).cloud;
  SheetSampling other = sampling;
  other.seed += 1000;
  Eigen::Isometry3d up = Eigen::Isometry3d::Identity();
  up.translation().z() = distance;
  return cloud += moved(makeJitteredPlane(other).cloud, up);
}

Cloud
makeCorner(const SheetSampling& sampling)
{
  Cloud corner;
  for (int side = 0; side < 3; ++side) {
    SheetSampling each = sampling;
    each.seed += static_cast<std::uint64_t>(side);
    const SheetCloud sheet = makeJitteredPlane(each);
    const Eigen::Vector2d center =
        sheet.maximum + Eigen::Vector2d::Constant(each.spacing / 2);
    for (const PointXYZ& p : sheet.cloud) {
      const float place[3] = {p.x + static_cast<float>(center.x()),
                              p.y + static_cast<float>(center.y()),
                              p.z};
      corner.push_back({place[side], place[(side + 1) % 3], place[(side + 2) % 3]});
    }
  }
  return corner;
}

Cloud
makeRoom(double spacing, double noise, std::uint64_t seed)
{
  const Eigen::Vector3d half(2.0, 1.5, 1.25);
  Cloud room;
  const auto addSide = [&](int normal, double sign, std::uint64_t side) {
    const int along = (normal + 1) % 3;
    const int across = (normal + 2) % 3;
    const SheetCloud sheet =
        makeJitteredPlane({static_cast<int>(2 * half[along] / spacing),
                           static_cast<int>(2 * half[across] / spacing),
                           spacing,
                           0.25,
                           noise,
                           seed + side});
    for (std::size_t i = 0; i < sheet.cloud.size(); ++i) {
      Eigen::Vector3d place;
      place[along] = sheet.parameters[i].x();
      place[across] = sheet.parameters[i].y();
      place[normal] = sign * half[normal] + static_cast<double>(sheet.cloud[i].z);
      room.push_back(toPoint(place));
    }
  };
  addSide(2, -1, 0);
  addSide(0, -1, 1);
  addSide(0, 1, 2);
  addSide(1, -1, 3);
  addSide(1, 1, 4);
  return room;
}

} // namespace pcl::acmap::test
