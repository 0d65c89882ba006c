#include "annotated_files.h"

#include "depth_image.h"

#include <pcl/conversions.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace pcl::acmap::bench {
namespace {

/** \param[in] mark returns the plane of a point */
template <typename PointT, typename Mark>
MarkedPoints
readMarked(const std::string& path, const Mark& mark)
{
  PointCloud<PointT> cloud;
  fromPCLPointCloud2(loadPointCloud(path).cloud, cloud);
  MarkedPoints points;
  points.reserve(cloud.size());
  for (const PointT& point : cloud)
    points.push_back({point.getVector3fMap(), mark(point)});
  return points;
}

MarkedPoints
pointsOfDepths(const DepthImage& image)
{
  constexpr float units = 5000; // depth units per metre
  const Eigen::Vector2f focal_length(481.2f, -480.0f);
  const Eigen::Vector2f center(319.5f, 239.5f);
  MarkedPoints points;
  points.reserve(image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float z = image.pixels[i] == 0 ? NAN : image.pixels[i] / units;
    const Eigen::Vector2f pixel(static_cast<float>(i % image.width),
                                static_cast<float>(i / image.width));
    const Eigen::Vector2f ray = (pixel - center).cwiseQuotient(focal_length);
    points.push_back({Eigen::Vector3f(ray.x() * z, ray.y() * z, z), -1});
  }
  return points;
}

} // namespace

MarkedPoints
readSynpeb(const std::string& path)
{
  return readMarked<PointXYZI>(path, [](const PointXYZI& point) {
    return static_cast<std::int32_t>(std::lround(point.intensity));
  });
}

MarkedPoints
readTable(const std::string& path)
{
  constexpr std::uint32_t parts_of_table = 9;
  return readMarked<PointXYZL>(path, [](const PointXYZL& point) {
    return point.label >= 1 && point.label <= parts_of_table ? 0 : -1;
  });
}

MarkedPoints
readRoomParts(const std::string& path)
{
  constexpr double max_deviation = 0.02; // metres
  constexpr double min_points = 300;
  MarkedPoints points = readMarked<PointXYZL>(path, [](const PointXYZL& point) {
    return static_cast<std::int32_t>(point.label) - 1;
  });
  const std::vector<PlaneFit> planes = fitMarkedPlanes(points);
  const auto is_planar = [&](std::int32_t plane) {
    const PlaneFit& fit = planes[static_cast<std::size_t>(plane)];
    return fit.count >= min_points && deviationOf(fit) <= max_deviation;
  };
  for (MarkedPoint& point : points)
    if (point.plane >= 0 && !is_planar(point.plane))
      point.plane = -1;
  return points;
}

MarkedPoints
readIclnuim(const std::string& path)
{
  const auto list = std::filesystem::path(path).replace_filename("planes.txt");
  MarkedPoints points = pointsOfDepths(readDepthImage(path));
  std::ifstream file(list);
  std::int32_t plane = 0;
  for (std::string line; std::getline(file, line);) {
    std::istringstream pixels(line);
    bool is_empty = true;
    for (std::size_t pixel; pixels >> pixel; is_empty = false)
      points.at(pixel).plane = plane;
    plane += !is_empty;
  }
  if (plane == 0)
    throw std::runtime_error(list.string() + " marks no plane");
  return points;
}

std::vector<PlaneFit>
fitMarkedPlanes(const MarkedPoints& points)
{
  std::vector<Moments> moments;
  for (const MarkedPoint& point : points) {
    if (point.plane < 0 || !point.place.allFinite())
      continue;
    const auto plane = static_cast<std::size_t>(point.plane);
    moments.resize(std::max(moments.size(), plane + 1));
    const Eigen::Vector3d p = point.place.cast<double>();
    moments[plane].addShifted(Moments{1}, p.x(), p.y(), p.z());
  }
  std::vector<PlaneFit> planes;
  for (const Moments& sums : moments)
    planes.push_back(sums.count > 0 ? fitPlane(sums) : PlaneFit());
  return planes;
}

double
deviationOf(const PlaneFit& plane)
{
  return std::sqrt(std::max(plane.variances[0], 0.0));
}

} // namespace pcl::acmap::bench
