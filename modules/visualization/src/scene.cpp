#include "scene.h"

#include "camera_fit.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/cloud_fields.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

namespace pcl::acmap {
namespace {

/** \brief Reads positions and colours from the bytes of a cloud. */
class CloudBytes {
public:
  explicit CloudBytes(const PCLPointCloud2& cloud)
  : data_(cloud.data.data())
  , step_(cloud.point_step)
  , size_(std::size_t{cloud.width} * cloud.height)
  {
    const char* const names[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
      const PCLPointField* const field = findField(cloud, names[axis]);
      if (!field || field->datatype != PCLPointField::FLOAT32)
        throw acmap::BadArgument(std::string("the cloud has no float32 field ") +
                                 names[axis]);
      place_[axis] = requireInside(*field);
    }
    const PCLPointField* color = findField(cloud, "rgb");
    if (!color)
      color = findField(cloud, "rgba");
    has_color_ = color != nullptr;
    if (has_color_)
      color_ = requireInside(*color);
    if (cloud.data.size() < size_ * step_)
      throw acmap::BadArgument("the cloud has fewer bytes than its points need");
  }

  std::size_t
  size() const
  {
    return size_;
  }

  bool
  hasColor() const
  {
    return has_color_;
  }

  Eigen::Vector3f
  point(std::size_t i) const
  {
    Eigen::Vector3f p;
    for (int axis = 0; axis < 3; ++axis)
      std::memcpy(&p[axis], data_ + i * step_ + place_[axis], sizeof(float));
    return p;
  }

  std::array<std::uint8_t, 3>
  color(std::size_t i) const
  {
    const std::uint8_t* const bgr = data_ + i * step_ + color_;
    return {bgr[2], bgr[1], bgr[0]};
  }

private:
  std::size_t
  requireInside(const PCLPointField& field) const
  {
    if (field.offset + sizeof(float) > step_)
      throw acmap::BadArgument("field " + field.name + " lies outside of the points");
    return field.offset;
  }

  const std::uint8_t* data_;
  std::size_t step_;
  std::size_t size_;
  std::array<std::size_t, 3> place_{};
  std::size_t color_ = 0;
  bool has_color_ = false;
};

void
requireInside(const TriangleMesh& mesh, std::size_t size)
{
  for (const TriangleMesh::Triangle& triangle : mesh.triangles)
    for (const std::int32_t corner : triangle)
      if (corner < 0 || static_cast<std::size_t>(corner) >= size)
        throw acmap::BadArgument("a triangle has the corner " + std::to_string(corner) +
                                 " in a cloud of " + std::to_string(size) + " points");
  if (!mesh.wall_depth.empty() && mesh.wall_depth.size() != mesh.triangles.size())
    throw acmap::BadArgument("the mesh has " + std::to_string(mesh.wall_depth.size()) +
                             " wall depths for " +
                             std::to_string(mesh.triangles.size()) + " triangles");
}

/** \brief For each point, is it drawn? */
std::vector<bool>
drawnPoints(const CloudBytes& cloud, const TriangleMesh& mesh)
{
  std::vector<bool> drawn(cloud.size(), mesh.triangles.empty());
  for (const TriangleMesh::Triangle& triangle : mesh.triangles)
    for (const std::int32_t corner : triangle)
      drawn[static_cast<std::size_t>(corner)] = true;
  for (std::size_t i = 0; i < drawn.size(); ++i)
    drawn[i] = drawn[i] && cloud.point(i).allFinite();
  return drawn;
}

/** \brief A file may have a colour field that contains only zeros. */
bool
allBlack(const Scene& scene)
{
  return std::all_of(scene.colors.begin(), scene.colors.end(), [](const auto& color) {
    return color == std::array<std::uint8_t, 3>{0, 0, 0};
  });
}

} // namespace

Scene
makeScene(const PCLPointCloud2& cloud, const TriangleMesh& mesh)
{
  const CloudBytes bytes(cloud);
  requireInside(mesh, bytes.size());
  const std::vector<bool> drawn = drawnPoints(bytes, mesh);
  std::vector<std::int32_t> place(bytes.size(), -1);
  Scene scene;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (!drawn[i])
      continue;
    place[i] = static_cast<std::int32_t>(scene.points.size());
    scene.points.push_back(bytes.point(i));
    if (bytes.hasColor())
      scene.colors.push_back(bytes.color(i));
  }
  if (scene.points.empty())
    throw acmap::InitFailed("nothing to show: no point is finite");
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const TriangleMesh::Triangle triangle = {place[a], place[b], place[c]};
    if (*std::min_element(triangle.begin(), triangle.end()) < 0)
      continue;
    scene.triangles.push_back(triangle);
    if (!mesh.wall_depth.empty())
      scene.wall_depth.push_back(mesh.wall_depth[i]);
  }
  if (allBlack(scene))
    scene.colors.clear();
  return scene;
}

Eigen::Vector3d
meanNormal(const Scene& scene)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double area = 0;
  for (const auto& [a, b, c] : scene.triangles) {
    const Eigen::Vector3d origin = scene.points[a].cast<double>();
    const Eigen::Vector3d normal = (scene.points[b].cast<double>() - origin)
                                       .cross(scene.points[c].cast<double>() - origin);
    sum += normal;
    area += normal.norm();
  }
  return area > 0 ? Eigen::Vector3d(sum / area) : sum;
}

TriangleMesh
trianglesOf(const PolygonMesh& mesh)
{
  TriangleMesh triangles;
  for (const Vertices& polygon : mesh.polygons) {
    const Indices& corners = polygon.vertices;
    for (std::size_t i = 2; i < corners.size(); ++i)
      triangles.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
  return triangles;
}

std::vector<std::array<Eigen::Vector3f, 2>>
normalLines(const Scene& scene)
{
  constexpr std::size_t max_lines = 3000;
  constexpr float length_share = 0.03F;
  std::vector<Eigen::Vector3f> normals(scene.points.size(), Eigen::Vector3f::Zero());
  for (const auto& [a, b, c] : scene.triangles) {
    const Eigen::Vector3f normal =
        (scene.points[b] - scene.points[a]).cross(scene.points[c] - scene.points[a]);
    for (const std::int32_t corner : {a, b, c})
      normals[static_cast<std::size_t>(corner)] += normal;
  }
  const auto length =
      static_cast<float>(RobustBox(scene.points).half.norm()) * length_share;
  std::vector<std::array<Eigen::Vector3f, 2>> lines;
  const std::size_t step = (normals.size() + max_lines - 1) / max_lines;
  for (std::size_t i = 0; i < normals.size(); i += step)
    if (const float norm = normals[i].norm(); norm > 0 && std::isfinite(norm))
      lines.push_back(
          {scene.points[i], scene.points[i] + normals[i] * (length / norm)});
  return lines;
}

std::vector<std::array<std::int32_t, 2>>
boundaryEdges(const TriangleMesh::Triangles& triangles)
{
  std::vector<std::array<std::int32_t, 2>> edges;
  edges.reserve(triangles.size() * 3);
  for (const TriangleMesh::Triangle& triangle : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [minimum, maximum] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
      edges.push_back({minimum, maximum});
    }
  std::sort(edges.begin(), edges.end());
  std::vector<std::array<std::int32_t, 2>> single;
  for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
    while (next < edges.size() && edges[next] == edges[i])
      ++next;
    if (next == i + 1)
      single.push_back(edges[i]);
  }
  return single;
}

} // namespace pcl::acmap
