#include "figure_table.h"

#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/core/planar_pose.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/trajectory_error.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace pcl::acmap {

namespace {

constexpr double camera_rate = 14;           // frames a second
constexpr std::size_t bytes_of_a_point = 16; // x y z rgb

std::string
grouped(std::size_t number)
{
  std::string text = std::to_string(number);
  for (std::size_t i = text.size(); i > 3; i -= 3)
    text.insert(i - 3, ",");
  return text;
}

std::string
fixed(double number, int digits)
{
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, number);
  return text;
}

std::string
row(const std::string& what, const std::string& paper, const std::string& here)
{
  return "| " + what + " | " + paper + " | " + here + " |\n";
}

double
ateOf(const Trajectory& found, const Trajectory& truth)
{
  const auto onFloor = [](const Trajectory& trajectory) {
    std::vector<PlanarPose> poses;
    for (const Eigen::Isometry3d& pose : trajectory.poses)
      poses.push_back(planarPartOf(pose));
    return poses;
  };
  return absoluteTrajectoryError(onFloor(found), onFloor(truth)).unaligned;
}

std::string
tableOf(const FigureNumbers& n)
{
  const std::size_t shots = n.observations * n.patterns;
  std::string table = "| | paper | here |\n|---|---|---|\n";
  const RandomLinePattern pattern;
  table += row("observations", "106", grouped(n.observations));
  table += row("patterns an observation", "10", grouped(n.patterns));
  table += row("lines a pattern",
               "200",
               grouped(static_cast<std::size_t>(pattern.getNumberOfLines())));
  table += row("pattern, px",
               "1024 x 768",
               std::to_string(pattern.getWidth()) + " x " +
                   std::to_string(pattern.getHeight()));
  table += row("image, px",
               "640 x 480",
               std::to_string(n.width) + " x " + std::to_string(n.height));
  table += row("points an observation", "138,653", grouped(n.points / n.observations));
  table += row("points in all", "14,697,233", grouped(n.points));
  table += row("shots under patterns, and what a camera of 14 a second takes for them",
               "1,060 in 75.7 s",
               grouped(shots) + " in " +
                   fixed(static_cast<double>(shots) / camera_rate, 1) + " s");
  table += row("planes", "not told", grouped(n.planes));
  table += row("area of all planes, m2", "not told", fixed(n.area, 1));
  table += row(
      "map.glb, bytes; points of 16 bytes to one of it",
      "not told",
      grouped(n.map_bytes) + "; " +
          grouped(bytes_of_a_point * n.points / std::max<std::size_t>(n.map_bytes, 1)) +
          " : 1");
  table += row("places of the robot off the truth before rectification, m rms",
               "not told",
               fixed(n.ate_before, 3));
  table += row("the same after", "not told", fixed(n.ate_after, 3));
  return table;
}

std::string
figure(const std::string& number, const std::string& caption)
{
  return "\n## Fig. " + number + "\n\n" + "![Fig. " + number + "](fig" + number +
         ".png)\n\n" + caption + "\n";
}

} // namespace

FigureNumbers
numbersOf(const FilmedSession& session,
          const MappedSession& mapped,
          const CompactMap& map)
{
  FigureNumbers n;
  n.observations = mapped.observations.size();
  n.patterns = session.patterns;
  for (const std::string& path : mapped.observations) {
    const PointCloudFile file = loadPointCloud(path);
    n.width = static_cast<int>(file.cloud.width);
    n.height = static_cast<int>(file.cloud.height);
    const PointView points = file.points();
    for (std::size_t i = 0; i < points.size(); ++i)
      n.points += points[i].allFinite() ? 1 : 0;
  }
  n.planes = map.planes.size();
  for (const PlanePatch& plane : map.planes)
    n.area += plane.area;
  n.ate_before = ateOf(mapped.before, session.trajectory);
  n.ate_after = ateOf(mapped.after, session.trajectory);
  std::error_code error;
  const auto bytes = std::filesystem::file_size(mapped.folder + "/map.glb", error);
  n.map_bytes = error ? 0 : bytes;
  return n;
}

std::string
figurePage(const FigureNumbers& numbers, const FigurePlan& plan)
{
  const auto observation = [](const ObservationFigure& figure) {
    return "observation " + std::to_string(figure.observation);
  };
  std::string page =
      "# The paper's figures again\n\n"
      "Of a simulated building: nothing here is a photograph. Colours are "
      "2.5 times as light as the cameras saw them.\n\n";
  page += tableOf(numbers);
  page +=
      figure("2",
             "Above: the reference image of " + observation(plan.fusion) +
                 " with the projector off, then under three patterns. Middle: what "
                 "stereo finds in each of them alone; red is near, blue far, black "
                 "nothing. Below: the median of the disparities of all patterns, as "
                 "in the paper; the disparities of all patterns matched together, of "
                 "which the map is made; the surface that these are, in the colours "
                 "of the first image.");
  page +=
      figure("3",
             "Acquisitions in the corridor, one a row: reference image, disparities "
             "of all patterns, the surface in the colours of the image.");
  page +=
      figure("4",
             "From the top: the true plan of what was filmed, with the robot's way; "
             "the points of the walls from above before rectification and after it, "
             "upon the true plan in red; the points after it from two places, "
             "without the ceiling.");
  page +=
      figure("5",
             "How the mesh of " + observation(plan.walls) +
                 " grows, row by row: the triangles that the first splitting plane "
                 "cuts, then those of the planes that divide the halves, and so on; "
                 "those of earlier steps are pale.");
  page += figure("7", "The mesh of " + observation(plan.mesh) + ".");
  page +=
      figure("8",
             "The planes with their textures as the robot sees them; on the top "
             "right without textures, each plane in a colour of its own. Plain grey "
             "is what no camera saw, white what lies on no plane.");
  page += figure("9",
                 "The textured planes from outside; planes that look away from the "
                 "eye are left out.");
  page += figure("10", "The same from the other end.");
  return page;
}

} // namespace pcl::acmap
