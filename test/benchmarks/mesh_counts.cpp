// Instructions and mispredicted branches of the mesh step, which do not depend on what
// else the machine does.
#include "event_counts.h"

#include "clouds.h"
#include "figure_clouds.h"
#include "markdown_row.h"
#include "raw_mesh.h"
#include "simulated_clouds.h"
#include "temporary_folder.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iostream>
#include <numeric>

namespace pcl::acmap::bench {
namespace {

constexpr double voxel = 0.05; // metres

using Positions = std::vector<Eigen::Vector3f>;

/** The points around the middle one of a cloud, in the order of the cloud. */
Positions
middlePart(const Positions& all, std::size_t size)
{
  if (all.size() <= size)
    return all;
  const Eigen::Vector3f middle = all[all.size() / 2];
  std::vector<std::pair<float, std::size_t>> by_distance;
  for (std::size_t i = 0; i < all.size(); ++i)
    by_distance.emplace_back((all[i] - middle).squaredNorm(), i);
  const auto end = by_distance.begin() + static_cast<std::ptrdiff_t>(size);
  std::nth_element(by_distance.begin(), end, by_distance.end());
  std::vector<std::size_t> chosen;
  for (auto point = by_distance.begin(); point != end; ++point)
    chosen.push_back(point->second);
  std::sort(chosen.begin(), chosen.end());
  Positions part;
  for (const std::size_t i : chosen)
    part.push_back(all[i]);
  return part;
}

/** One counted mesh. */
struct CountedMesh {
  DeWallRule rule;
  double maximum_edge_length; ///< metres; 0: automatic
};

void
mesh(const Positions& points, const CountedMesh& counted)
{
  DeWallSettings settings;
  settings.rule = counted.rule;
  settings.maximum_edge_length = counted.maximum_edge_length;
  settings.threads = 1;
  DeWallReport report;
  triangulateDeWall(PointView(points.data(), sizeof(Eigen::Vector3f), points.size()),
                    settings,
                    Progress(),
                    report);
}

/** In a run of this program under callgrind: the points are in a file. */
EventCounts
countInChild(const Positions& points, const CountedMesh& counted)
{
  const test::TemporaryFolder folder;
  const std::string path = folder.path("points");
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(points.data()),
             static_cast<std::streamsize>(points.size() * sizeof(Eigen::Vector3f)));
  return countByCallgrind("pcl::acmap::triangulateDeWall*",
                          {"--mesh",
                           counted.rule == DeWallRule::Paper ? "paper" : "dense",
                           std::to_string(counted.maximum_edge_length),
                           path});
}

void
printRow(const std::string& name, const Positions& cloud, const CountedMesh& counted)
{
  constexpr std::size_t part_size = 20000;
  const Positions points = middlePart(cloud, part_size);
  mesh(points, counted); // what is done only once in a process is not counted
  const auto by_processor = countByProcessor([&] { mesh(points, counted); });
  const EventCounts counts =
      by_processor ? *by_processor : countInChild(points, counted);
  const auto size = static_cast<double>(points.size());
  MarkdownRow()
      .text(name)
      .count(points.size())
      .text(ruleName(counted.rule))
      .number(static_cast<double>(counts.instructions) / size, 0)
      .number(static_cast<double>(counts.mispredictions) / size, 0)
      .text(by_processor ? "processor" : "callgrind")
      .print();
}

Positions
positionsOf(const test::Cloud& cloud)
{
  Positions positions;
  for (const PointXYZ& point : cloud)
    positions.emplace_back(point.getVector3fMap());
  return positions;
}

Positions
representatives(const SimulatedCloud& cloud)
{
  ConsolidationReport report;
  Positions positions;
  for (const Representative& representative :
       consolidate(cloud, voxel, report).representatives)
    positions.push_back(representative.point);
  return positions;
}

void
printCounts()
{
  printHead({"cloud",
             "points",
             "mesher",
             "instructions a point",
             "mispredicted branches a point",
             "counted by"});
  SceneData corridor("corridor");
  const SimulatedCloud view = makeViewCloud(corridor.scene(), 0);
  std::vector<std::pair<std::string, Positions>> raw{{"view 0", view.merged.points}};
  for (const FigureCloud& cloud : singleViews())
    raw.emplace_back(cloud.name, positionsOf(cloud.cloud));
  for (const auto& [name, points] : raw)
    for (const DeWallRule rule : {DeWallRule::Paper, DeWallRule::Dense})
      printRow(name, points, {rule, 0});
  printRow("corridor, consolidated at 5 cm",
           representatives(corridor.whole()),
           {DeWallRule::Paper, 2.5 * voxel});
}

/** What is counted in the child: the mesh of the points of a file. */
void
meshFile(const std::string& rule, double maximum_edge_length, const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  Positions points(bytes.size() / sizeof(Eigen::Vector3f));
  std::memcpy(static_cast<void*>(points.data()),
              bytes.data(),
              points.size() * sizeof(Eigen::Vector3f));
  mesh(points,
       {rule == "paper" ? DeWallRule::Paper : DeWallRule::Dense, maximum_edge_length});
}

} // namespace
} // namespace pcl::acmap::bench

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  if (argc == 5 && std::string(argv[1]) == "--mesh") {
    meshFile(argv[2], std::stod(argv[3]), argv[4]);
    return 0;
  }
  if (argc > 1) {
    std::cerr
        << "Usage: acmap_bench_mesh_counts\n"
           "Prints the instructions and mispredicted branches of a mesh for each of "
           "its points, as\n"
           "a Markdown table: counted by the processor, or by valgrind's callgrind "
           "where it does not count.\n"
           "Real clouds are read from the folder named by the environment variable "
           "ACMAP_TEST_DATA.\n";
    return std::string(argv[1]) == "--help" ? 0 : 2;
  }
  try {
    printCounts();
  }
  catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
