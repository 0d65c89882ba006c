// Instructions and mispredicted branches of the mesh step, which do not depend on what
// else the machine does: this program runs itself under callgrind, which simulates the
// predictions of branches.
#include "bench.h"
#include "bench_data.h"
#include "meshes.h"
#include "run_tool.h"
#include "simulated_clouds.h"
#include "temporary_folder.h"

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace pcl::acmap::bench {
namespace {

constexpr double voxel = 0.05;                        // metres
constexpr char counted_mesh[] = "ACMAP_COUNTED_MESH"; ///< variable: rule, length, file

using Positions = std::vector<Eigen::Vector3f>;

struct EventCounts {
  std::uint64_t instructions = 0;
  std::uint64_t mispredictions = 0; ///< of branches
};

/** The numbers of callgrind's summary, in the order of its events. */
EventCounts
readSummary(const std::string& path)
{
  EventCounts counts;
  std::vector<std::string> events;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "events:")
      for (std::string event; words >> event;)
        events.push_back(event);
    else if (key == "totals:")
      for (const std::string& event : events) {
        std::uint64_t count = 0;
        words >> count;
        if (event == "Ir")
          counts.instructions = count;
        else if (event == "Bcm" || event == "Bim") // conditional, indirect
          counts.mispredictions += count;
      }
  }
  return counts;
}

/** Counts the mesh of some points, which are in a file.
 * \param[in] maximum_edge_length metres; 0: automatic */
EventCounts
countMesh(const Positions& points, DeWallRule rule, double maximum_edge_length)
{
  const test::TemporaryFolder folder;
  const std::string path = folder.path("points"), counted = folder.path("counts");
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(points.data()),
             static_cast<std::streamsize>(points.size() * sizeof(Eigen::Vector3f)));
  const std::string mesh = (rule == DeWallRule::Paper ? "paper " : "dense ") +
                           std::to_string(maximum_edge_length) + " " + path;
  ::setenv(counted_mesh, mesh.c_str(), 1);
  const test::ToolRun run =
      test::runTool("valgrind",
                    {"--tool=callgrind",
                     "--branch-sim=yes",
                     "--toggle-collect=pcl::acmap::triangulateDeWall*",
                     "--callgrind-out-file=" + counted,
                     std::filesystem::read_symlink("/proc/self/exe"),
                     "counted"});
  const EventCounts counts = readSummary(counted);
  if (run.exit_code != 0 || counts.instructions == 0)
    throw std::runtime_error("valgrind counted nothing: is it installed?\n" + run.err);
  return counts;
}

/** What is done by the run under callgrind. */
const Section counted_section(
    "counted",
    [] {
      const char* const wanted = std::getenv(counted_mesh);
      std::istringstream words(wanted ? wanted : "");
      std::string rule, path;
      DeWallSettings settings;
      words >> rule >> settings.maximum_edge_length >> path;
      const std::string bytes = contentOf(path);
      Positions points(bytes.size() / sizeof(Eigen::Vector3f));
      std::memcpy(static_cast<void*>(points.data()),
                  bytes.data(),
                  points.size() * sizeof(Eigen::Vector3f));
      settings.rule = rule == "paper" ? DeWallRule::Paper : DeWallRule::Dense;
      DeWallInput input;
      input.points = PointView(points.data(), sizeof(Eigen::Vector3f), points.size());
      input.threads = 1;
      DeWallReport report;
      triangulateDeWall(input, settings, Progress(), report);
    },
    SectionUse::WhenNamed);

/** The points around the middle one of a cloud, in the order of the cloud. */
Positions
middlePart(const Positions& all)
{
  constexpr std::size_t size = 20000;
  if (all.size() <= size)
    return all;
  const Eigen::Vector3f middle = all[all.size() / 2];
  std::vector<std::pair<float, std::size_t>> by_distance;
  for (std::size_t i = 0; i < all.size(); ++i)
    by_distance.emplace_back((all[i] - middle).squaredNorm(), i);
  std::nth_element(by_distance.begin(), by_distance.begin() + size, by_distance.end());
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < size; ++i)
    chosen.push_back(by_distance[i].second);
  std::sort(chosen.begin(), chosen.end());
  Positions part;
  for (const std::size_t i : chosen)
    part.push_back(all[i]);
  return part;
}

void
printCounts(const std::string& name,
            const Positions& cloud,
            DeWallRule rule,
            double maximum_edge_length = 0)
{
  const Positions points = middlePart(cloud);
  const EventCounts counts = countMesh(points, rule, maximum_edge_length);
  const auto size = static_cast<double>(points.size());
  Row() << name << points.size() << ruleName(rule)
        << figure(static_cast<double>(counts.instructions) / size, 0)
        << figure(static_cast<double>(counts.mispredictions) / size, 0);
}

const Section counts_section("counts", [] {
  printHead("cloud | points | mesher | instructions a point | mispredicted branches a "
            "point");
  std::vector<std::pair<std::string, Positions>> raw{
      {"view 0", makeViewCloud(corridor().scene(), 0).merged.points}};
  for (const FigureCloud& view : singleViews()) {
    raw.emplace_back(view.name, Positions());
    for (const PointXYZ& point : view.cloud)
      raw.back().second.emplace_back(point.getVector3fMap());
  }
  for (const auto& [name, points] : raw)
    for (const DeWallRule rule : {DeWallRule::Paper, DeWallRule::Dense})
      printCounts(name, points, rule);
  ConsolidationReport report;
  Positions representatives;
  for (const Representative& representative :
       consolidate(corridor().whole(), voxel, report).representatives)
    representatives.push_back(representative.point);
  printCounts("corridor, consolidated at 5 cm",
              representatives,
              DeWallRule::Paper,
              2.5 * voxel);
});

} // namespace
} // namespace pcl::acmap::bench
