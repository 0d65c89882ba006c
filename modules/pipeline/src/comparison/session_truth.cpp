#include <pcl/core/file_format.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/session_truth.h>

#include <Eigen/Geometry>

#include <cmath>

namespace pcl {

using namespace acmap;

namespace {

constexpr double farthest = 1e6; // metres
constexpr std::size_t max_planes = 100000;

template <int Rows>
Eigen::Matrix<double, Rows, 1>
vectorOf(const YamlNode& node)
{
  Eigen::Matrix<double, Rows, 1> vector;
  const auto& values = node.list(Rows, Rows);
  for (int row = 0; row < Rows; ++row)
    vector[row] = values[static_cast<std::size_t>(row)].number(-farthest, farthest);
  return vector;
}

Eigen::Vector4d
coefficientsOf(const YamlNode& node)
{
  constexpr double slack = 1e-6;
  const auto coefficients = vectorOf<4>(node);
  if (std::abs(coefficients.head<3>().norm() - 1) > slack)
    node.fail("has a normal that is not of unit length");
  return coefficients;
}

/** \param[in] node four corners in order along the rim */
ChartClip
rectangleOf(const YamlNode& node)
{
  constexpr double shortest = 1e-3;     // metres
  constexpr double largest_cosine = .1; // between its edges
  constexpr int texels = 1000;          // the tolerance of the clip is 1e-5 of an edge
  const auto& corners = node.list(4, 4);
  const Eigen::Vector3d corner = vectorOf<3>(corners[0]);
  const Eigen::Vector3d edge_u = vectorOf<3>(corners[1]) - corner;
  const Eigen::Vector3d edge_v = vectorOf<3>(corners[3]) - corner;
  const double u = edge_u.norm(), v = edge_v.norm();
  if (!(u >= shortest && v >= shortest &&
        std::abs(edge_u.dot(edge_v)) <= largest_cosine * u * v))
    node.fail("is no rectangle");
  TextureChart chart;
  chart.origin = corner;
  chart.texel_u = edge_u / texels;
  chart.texel_v = edge_v / texels;
  chart.colors.width = chart.colors.height = texels;
  return ChartClip(chart);
}

TruePlane
planeOf(const YamlNode& node)
{
  constexpr std::size_t max_points = 1000000000000000;
  constexpr std::size_t max_rectangles = 100000;
  TruePlane plane;
  plane.name = node.at("name").text();
  plane.coefficients = coefficientsOf(node.at("coefficients"));
  plane.points = node.at("points").count(0, max_points);
  for (const YamlNode& rectangle : node.at("rectangles").list(1, max_rectangles))
    plane.rectangles.push_back(rectangleOf(rectangle));
  return plane;
}

std::size_t
pointsOf(const std::vector<TruePlane>& planes)
{
  std::size_t points = 0;
  for (const TruePlane& plane : planes)
    points += plane.points;
  return points;
}

} // namespace

std::vector<std::size_t>
SessionTruth::mainPlanes() const
{
  constexpr std::size_t parts = 100;
  const std::size_t points = pointsOf(planes);
  std::vector<std::size_t> main;
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (planes[i].points > 0 && parts * planes[i].points >= points)
      main.push_back(i);
  return main;
}

std::vector<TruePlane>
acmap::readTruePlanes(const YamlNode& file)
{
  requireFormat(file, file_formats::truth);
  std::vector<TruePlane> planes;
  for (const YamlNode& plane : file.at("planes").list(1, max_planes))
    planes.push_back(planeOf(plane));
  return planes;
}

SessionTruth
loadSessionTruth(const std::string& folder)
{
  const std::string path = folder + "/truth.json";
  SessionTruth truth;
  truth.planes = readTruePlanes(loadYaml(path)); // JSON is a subset of YAML
  if (pointsOf(truth.planes) == 0)
    throw InputFileException(path + ": none of its planes has points");
  truth.trajectory_path = folder + "/" + trajectory_name;
  truth.trajectory = loadTrajectory(truth.trajectory_path);
  return truth;
}

} // namespace pcl
