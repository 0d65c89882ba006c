#include <pcl/pipeline/detail_mesh.h>
#include <pcl/pipeline/map_sizes.h>

#include <filesystem>
#include <system_error>

namespace pcl {

namespace {

std::size_t
geometryBytes(const CompactMap& map)
{
  constexpr std::size_t bytes_of_plane = 16, bytes_of_corner = 12;
  std::size_t bytes = bytes_of_plane * map.planes.size();
  for (const PlanePatch& plane : map.planes)
    for (const PlanePolygon& polygon : plane.polygons) {
      bytes += bytes_of_corner * polygon.outer.size();
      for (const std::vector<Eigen::Vector3f>& hole : polygon.holes)
        bytes += bytes_of_corner * hole.size();
    }
  return bytes;
}

std::size_t
bytesOfFile(const std::string& folder, const char* name)
{
  std::error_code error;
  const auto bytes =
      std::filesystem::file_size(std::filesystem::path(folder) / name, error);
  return error ? 0 : bytes;
}

} // namespace

MapSizes
measureMap(const CompactMap& map, std::size_t points, const std::string& folder)
{
  constexpr std::size_t bytes_of_point = 16; // x y z rgb
  return {bytes_of_point * points,
          geometryBytes(map),
          detailBytes(map.details),
          bytesOfFile(folder, "map.glb"),
          bytesOfFile(folder, "map.json")};
}

} // namespace pcl
