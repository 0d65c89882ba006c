#include "plane_runs.h"

#include "clouds.h"
#include "temporary_folder.h"
#include "tool_cases.h"

#include <pcl/core/point_cloud_file.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace pcl::acmap::test {

Eigen::Vector4d
coefficientsOf(const nlohmann::json& plane)
{
  return Eigen::Vector4d(plane.at("coefficients").get<std::vector<double>>().data());
}

Eigen::Vector3d
pointOf(const nlohmann::json& point)
{
  return Eigen::Vector3d(point.get<std::vector<double>>().data());
}

double
angleBetween(const Eigen::Vector4d& a, const Eigen::Vector4d& b)
{
  const Eigen::Vector3d n = a.head<3>();
  const Eigen::Vector3d m = b.head<3>();
  return std::atan2(n.cross(m).norm(), n.dot(m)) * 180 / M_PI;
}

nlohmann::json
matchOf(const nlohmann::json& planes,
        const Eigen::Vector4d& truth,
        double degrees,
        double metres)
{
  nlohmann::json best;
  for (const auto& plane : planes) {
    const double angle = angleBetween(coefficientsOf(plane), truth);
    const double off = truth.dot(pointOf(plane.at("center")).homogeneous());
    if (angle <= degrees && std::abs(off) <= metres) {
      degrees = angle;
      best = plane;
    }
  }
  return best;
}

std::vector<std::uint32_t>
labelsOfFile(const std::string& path)
{
  const PointCloudFile file = loadPointCloud(path);
  std::vector<std::uint32_t> labels;
  for (const PCLPointField& field : file.cloud.fields) {
    if (field.name != "label")
      continue;
    EXPECT_EQ(field.datatype, PCLPointField::UINT32);
    labels.resize(file.points().size());
    for (std::size_t i = 0; i < labels.size(); ++i)
      std::memcpy(&labels[i],
                  &file.cloud.data[i * file.cloud.point_step + field.offset],
                  sizeof(std::uint32_t));
  }
  return labels;
}

std::string
roomPcd()
{
  return pcdText(makeRoom(0.03, 0.2, 1));
}

std::vector<Eigen::Vector4d>
roomPlanes()
{
  return {
      {0, 0, 1, 1.25}, {1, 0, 0, 2}, {-1, 0, 0, 2}, {0, 1, 0, 1.5}, {0, -1, 0, 1.5}};
}

std::string
cubeObj()
{
  constexpr int squares = 20;
  std::string points, faces;
  int first = 1;
  for (const double sign : {-1.0, 1.0})
    for (int normal = 0; normal < 3; ++normal, first += (squares + 1) * (squares + 1))
      for (int i = 0; i <= squares; ++i)
        for (int j = 0; j <= squares; ++j) {
          Eigen::Vector3d p;
          p[normal] = sign / 2;
          p[(normal + 1) % 3] = static_cast<double>(i) / squares - 0.5;
          p[(normal + 2) % 3] = sign * (static_cast<double>(j) / squares - 0.5);
          points += "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
                    std::to_string(p.z()) + "\n";
          const int at = first + i * (squares + 1) + j;
          if (i < squares && j < squares)
            faces += "f " + std::to_string(at) + " " +
                     std::to_string(at + squares + 1) + " " +
                     std::to_string(at + squares + 2) + " " + std::to_string(at + 1) +
                     "\n";
        }
  return points + faces;
}

} // namespace pcl::acmap::test
