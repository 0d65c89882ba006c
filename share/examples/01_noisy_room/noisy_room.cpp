// Creates a simulated depth image of a room, and a mesh of it.
// Usage: noisy_room ROOM.pcd [MESH.ply]

#include <pcl/conversions.h>
#include <pcl/core/mesh_file.h>
#include <pcl/core/output_file.h>
#include <pcl/core/random.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/surface/dewall_triangulation.h>

#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <optional>
#include <sstream>
#include <vector>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZRGB>;
using Eigen::Vector3d;

constexpr int width = 320;             // rays
constexpr int height = 240;            // rays
constexpr double focal_length = 165.0; // pixels: a field of view of 88 x 72 degrees
constexpr double noise = 0.1;          // fraction of the distance between neighbouring
                                       // rays
constexpr std::uint64_t seed = 1;

using Color = std::array<std::uint8_t, 3>;

// A wall, floor or side of a box: a rectangle perpendicular to one axis.
struct Rectangle {
  int axis;         // 0 = x, 1 = y, 2 = z
  double at;        // metres along that axis
  Vector3d minimum; // metres; the component along the axis is ignored
  Vector3d maximum;
  Color color;
};

// The room is 4 m wide and 2.5 m high and ends 3.5 m in front of the camera, which is
// 1.3 m above the floor. Metres, y down.
constexpr double left = -2.0, right = 2.0, ceiling = -1.2, ground = 1.3, end = 3.5;

void
addBox(std::vector<Rectangle>& scene,
       const Vector3d& minimum,
       const Vector3d& maximum,
       Color c)
{
  for (int axis = 0; axis < 3; ++axis) {
    scene.push_back({axis, minimum[axis], minimum, maximum, c});
    scene.push_back({axis, maximum[axis], minimum, maximum, c});
  }
}

std::vector<Rectangle>
makeRoom()
{
  const Color wall = {226, 219, 200}, side = {205, 212, 190}, wood = {150, 105, 70};
  const double door_left = 0.5, door_right = 1.4, door_top = -0.75, door_depth = 0.25;
  const double recess = end + door_depth;
  std::vector<Rectangle> scene = {
      {1, ground, {left, 0, 0}, {right, 0, end}, {140, 120, 100}},
      {1, ceiling, {left, 0, 0}, {right, 0, end}, {240, 240, 235}},
      {0, left, {0, ceiling, 0}, {0, ground, end}, side},
      {0, right, {0, ceiling, 0}, {0, ground, end}, side},
      // the wall in front, around the door
      {2, end, {left, ceiling, 0}, {door_left, ground, 0}, wall},
      {2, end, {door_right, ceiling, 0}, {right, ground, 0}, wall},
      {2, end, {door_left, ceiling, 0}, {door_right, door_top, 0}, wall},
      // the recess with the door at its back
      {2, recess, {door_left, door_top, 0}, {door_right, ground, 0}, wood},
      {0, door_left, {0, door_top, end}, {0, ground, recess}, wall},
      {0, door_right, {0, door_top, end}, {0, ground, recess}, wall},
      {1, door_top, {door_left, 0, end}, {door_right, 0, recess}, wall},
      {1, ground, {door_left, 0, end}, {door_right, 0, recess}, {140, 120, 100}}};
  addBox(scene, {-1.3, 0.65, 2.1}, {-0.5, ground, 2.7}, {70, 110, 160});
  return scene;
}

// Distance along the ray (direction with z = 1) to the rectangle, if they intersect.
std::optional<double>
distanceTo(const Rectangle& rectangle, const Vector3d& ray)
{
  const double t = rectangle.at / ray[rectangle.axis];
  if (!std::isfinite(t) || t <= 0)
    return {};
  const Vector3d p = ray * t;
  for (int axis = 0; axis < 3; ++axis)
    if (axis != rectangle.axis &&
        (p[axis] < rectangle.minimum[axis] || p[axis] > rectangle.maximum[axis]))
      return {};
  return t;
}

pcl::PointXYZRGB
seenAlong(const Vector3d& ray, const std::vector<Rectangle>& room, double deviation)
{
  double nearest = std::numeric_limits<double>::infinity();
  Color color = {0, 0, 0};
  for (const Rectangle& rectangle : room)
    if (const auto t = distanceTo(rectangle, ray); t && *t < nearest) {
      nearest = *t;
      color = rectangle.color;
    }
  pcl::PointXYZRGB point;
  // at this depth, neighbouring rays are nearest / focal_length metres apart
  const double noisy = nearest * (1.0 + deviation * noise / focal_length);
  point.getVector3fMap() = (ray * noisy).cast<float>();
  point.r = color[0];
  point.g = color[1];
  point.b = color[2];
  return point;
}

Cloud::Ptr
makeCloud()
{
  const std::vector<Rectangle> room = makeRoom();
  pcl::acmap::Random random(seed);
  Cloud::Ptr cloud(new Cloud(width, height));
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const Vector3d ray((column - (width - 1) / 2.0) / focal_length,
                         (row - (height - 1) / 2.0) / focal_length,
                         1.0);
      cloud->at(column, row) = seenAlong(ray, room, random.normal());
    }
  return cloud;
}

void
writePcd(const std::string& path, const Cloud& cloud)
{
  std::ostringstream header;
  header
      << "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z rgb\n"
      << "SIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH " << cloud.width
      << "\nHEIGHT " << cloud.height << "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS "
      << cloud.size() << "\nDATA binary\n";
  pcl::acmap::OutputFile file(path);
  const std::string text = header.str();
  file.write(text.data(), text.size());
  for (const pcl::PointXYZRGB& point : cloud) {
    const float values[] = {point.x, point.y, point.z, point.rgb};
    file.write(values, sizeof(values));
  }
  file.commit();
}

void
meshAndReport(const Cloud::Ptr& cloud, const std::string& path)
{
  pcl::DeWallTriangulation<pcl::PointXYZRGB> dewall;
  dewall.setInputCloud(cloud);
  pcl::TriangleMesh mesh;
  dewall.reconstruct(mesh);

  pcl::PCLPointCloud2 vertices;
  pcl::toPCLPointCloud2(*cloud, vertices);
  pcl::saveTriangleMesh(path, vertices, mesh);

  const pcl::DeWallReport& report = dewall.getReport();
  std::cout << report.used_points << " of " << report.points << " points became "
            << report.triangles << " triangles in " << report.components
            << " components; " << report.boundary_edges << " of " << report.edges
            << " edges are boundary\n";
  for (const auto& [step, seconds] : report.seconds)
    std::cout << "  " << step << ": " << seconds << " s\n";
  for (const std::string& remark : report.remarks)
    std::cout << "  " << remark << "\n";
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc < 2 || argc > 3) {
    std::cerr << "usage: noisy_room ROOM.pcd [MESH.ply]\n";
    return 2;
  }
  try {
    const Cloud::Ptr cloud = makeCloud();
    writePcd(argv[1], *cloud);
    if (argc == 3)
      meshAndReport(cloud, argv[2]);
  }
  catch (const std::exception& e) {
    std::cerr << "noisy_room" << e.what() << "\n";
    return 1;
  }
}
