// Classes of acmap inside PCL's own pipeline: a correspondence rejector in PCL's ICP, a
// custom search method in the mesher, and the meshes in PCL's viewer.
// Usage: inside_pcl [--show | MESHES.png]

#include <pcl/common/distances.h>
#include <pcl/core/random.h>
#include <pcl/egomotion/correspondence_rejector_worst_out.h>
#include <pcl/point_types.h>
#include <pcl/registration/icp.h>
#include <pcl/surface/dewall_triangulation.h>
#include <pcl/visualization/pcl_visualizer.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <tuple>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Eigen::AlignedBox3d;
using Eigen::Vector3d;

// The scanner rotates about z (up) and has 16 beams, 2 degrees apart.
constexpr int rings = 16, columns = 1800;
constexpr double ring_step = M_PI / 90;
constexpr double noise = 0.001; // metres along the ray

// It moves 36 cm and turns by 6 degrees; meanwhile somebody pushes the cupboard aside.
const Eigen::Isometry3d T_first_second =
    Eigen::Translation3d(0.3, -0.2, 0) * Eigen::AngleAxisd(0.1, Vector3d::UnitZ());
const AlignedBox3d room(Vector3d(-3, -2.5, -0.8), Vector3d(4, 3, 1.7)); // metres

// Distance from a position in the room along a unit ray to the cupboard or the walls,
// metres.
double
distanceAlong(const Vector3d& from, const Vector3d& ray, const AlignedBox3d& cupboard)
{
  const auto crossed = [&](const AlignedBox3d& box) {
    const Eigen::Array3d a = (box.min() - from).array() / ray.array();
    const Eigen::Array3d b = (box.max() - from).array() / ray.array();
    return std::pair(a.min(b).maxCoeff(), a.max(b).minCoeff());
  };
  const auto [enters, leaves] = crossed(cupboard);
  return enters > 0 && enters < leaves ? enters : crossed(room).second;
}

// The points of a scan in the scanner's frame, one row per ring. The cupboard moves
// along x.
Cloud::Ptr
scan(const Eigen::Isometry3d& T_room_scanner, double cupboard_at, std::uint64_t seed)
{
  const AlignedBox3d cupboard(Vector3d(cupboard_at, 1.8, -0.8),
                              Vector3d(cupboard_at + 1, 2.4, 0.6));
  pcl::acmap::Random random(seed);
  Cloud::Ptr cloud(new Cloud(columns, rings));
  for (int ring = 0; ring < rings; ++ring)
    for (int column = 0; column < columns; ++column) {
      const double up = (ring - (rings - 1) / 2.0) * ring_step;
      const double about = 2 * M_PI * column / columns;
      const Vector3d ray(
          std::cos(up) * std::cos(about), std::cos(up) * std::sin(about), std::sin(up));
      const double seen = distanceAlong(
          T_room_scanner.translation(), T_room_scanner.linear() * ray, cupboard);
      cloud->at(column, ring).getVector3fMap() =
          (ray * (seen + noise * random.normal())).cast<float>();
    }
  return cloud;
}

// Translation error of PCL's ICP between two scans, metres.
double
errorOfIcp(const Cloud::Ptr& first, const Cloud::Ptr& second, bool leaves_worst_out)
{
  pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> icp;
  icp.setInputTarget(first);
  icp.setInputSource(second);
  icp.setMaximumIterations(25);
  icp.setMaxCorrespondenceDistance(1);
  if (leaves_worst_out) {
    using pcl::registration::CorrespondenceRejectorWorstOut;
    icp.addCorrespondenceRejector(std::make_shared<CorrespondenceRejectorWorstOut>());
  }
  Cloud aligned;
  icp.align(aligned);
  const Eigen::Affine3f found(icp.getFinalTransformation());
  const double error =
      (found.translation().cast<double>() - T_first_second.translation()).norm();
  std::cout << "ICP " << (leaves_worst_out ? "leaving the worst out" : "alone")
            << ": off by " << 1000 * error << " mm\n";
  return error;
}

// A custom search method. The points of a ring are 1 cm apart, but the rings are 10 cm
// apart, so the nearest eight points are all on one ring. This class uses neighbours in
// the scanner's image instead.
class ScanNeighbours : public pcl::search::Search<pcl::PointXYZ> {
public:
  int
  nearestKSearch(const pcl::PointXYZ& point,
                 int k,
                 pcl::Indices& indices,
                 std::vector<float>& squared) const override
  {
    const double up = std::atan2(point.z, std::hypot(point.x, point.y));
    const double about = std::atan2(point.y, point.x);
    const long ring = std::lround(up / ring_step + (rings - 1) / 2.0);
    const long column = std::lround(about / (2 * M_PI) * columns) + columns;
    std::vector<std::pair<float, pcl::index_t>> found;
    for (long r = std::max(0L, ring - 1); r <= std::min(rings - 1L, ring + 1); ++r)
      for (long c = column - 1; c <= column + 1; ++c) {
        const auto i = static_cast<pcl::index_t>(r * columns + c % columns);
        found.emplace_back(pcl::squaredEuclideanDistance((*input_)[i], point), i);
      }
    std::sort(found.begin(), found.end());
    const auto size = std::min<std::size_t>(found.size(), k);
    indices.resize(size);
    squared.resize(size);
    for (std::size_t i = 0; i < size; ++i)
      std::tie(squared[i], indices[i]) = found[i];
    return static_cast<int>(size);
  }

  int
  radiusSearch(const pcl::PointXYZ&,
               double,
               pcl::Indices&,
               std::vector<float>&,
               unsigned int) const override
  {
    throw std::logic_error("the mesher does not ask for this");
  }
};

struct Meshed {
  pcl::PolygonMesh mesh;
  double area = 0; // square metres
};

Meshed
meshOf(const Cloud::Ptr& cloud, const pcl::search::Search<pcl::PointXYZ>::Ptr& search)
{
  pcl::DeWallTriangulation<pcl::PointXYZ> dewall;
  dewall.setInputCloud(cloud);
  dewall.setAcceptanceRule(pcl::DeWallRule::Dense);
  dewall.setSearchMethod(search);
  Meshed meshed;
  dewall.reconstruct(meshed.mesh);
  for (const pcl::Vertices& face : meshed.mesh.polygons) {
    const auto corner = [&](int i) {
      return (*cloud)[face.vertices[i]].getVector3fMap();
    };
    meshed.area += (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2;
  }
  std::cout << "mesh by neighbours in " << (search ? "the scan: " : "space: ")
            << meshed.area << " square metres\n";
  return meshed;
}

// Shows both meshes side by side in PCL's viewer until q is pressed, or saves a
// picture.
void
show(const Meshed& usual, const Meshed& own, const std::string& how)
{
  pcl::visualization::PCLVisualizer viewer("inside PCL");
  viewer.setSize(1280, 480);
  const auto add = [&](const Meshed& meshed, const char* id, double left) {
    int half = 0;
    viewer.createViewPort(left, 0, left + 0.5, 1, half);
    viewer.setBackgroundColor(1, 1, 1, half);
    viewer.addPolygonMesh(meshed.mesh, id, half);
    viewer.setPointCloudRenderingProperties(
        pcl::visualization::PCL_VISUALIZER_COLOR, 0.5, 0.65, 0.8, id, half);
  };
  add(usual, "usual", 0);
  add(own, "own", 0.5);
  viewer.setCameraPosition(-4, -7, 9, 0.5, 0.1, -0.8, 0, 0, 1);
  viewer.spinOnce(50, true);
  how == "--show" ? viewer.spin() : viewer.saveScreenshot(how);
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc > 2) {
    std::cerr << "usage: inside_pcl [--show | MESHES.png]\n";
    return 2;
  }
  const Cloud::Ptr first = scan(Eigen::Isometry3d::Identity(), 0, 1);
  const Cloud::Ptr second = scan(T_first_second, 1, 2);
  const double alone = errorOfIcp(first, second, false);
  const double without_worst = errorOfIcp(first, second, true);

  const Meshed usual = meshOf(first, {});
  const Meshed own = meshOf(first, std::make_shared<ScanNeighbours>());
  if (argc == 2)
    show(usual, own, argv[1]);
  if (without_worst > 0.5 * alone || own.area < 1.2 * usual.area) {
    std::cerr << "inside_pcl: rejector or search method did not help\n";
    return 1;
  }
}
