#include "mesh_speed_tables.h"

#include "consolidated_mesh.h"
#include "markdown_row.h"
#include "raw_mesh.h"
#include "statistics.h"
#include "timing.h"

#include <algorithm>
#include <iostream>

namespace pcl::acmap::bench {
namespace {

constexpr double voxel = 0.05; // metres
constexpr std::size_t small_crop = 100000;

/** CPU time of the mesh step, us per point. */
struct CropCost {
  double raw = 0;
  double consolidated = 0;
};

CropCost
printRow(const SimulatedCloud& cloud, bool is_whole)
{
  const std::size_t rounds = cloud.size() > small_crop ? 3 : 5;
  const auto points = static_cast<double>(cloud.size());
  const double raw = medianThread(is_whole ? 1 : rounds,
                                  [&] { meshRaw(cloud.points(), DeWallRule::Paper); });
  ConsolidationReport report;
  const Consolidation consolidation = consolidate(cloud, voxel, report);
  const std::size_t representatives = consolidation.representatives.size();
  const double seconds = medianThread(rounds, [&] { meshOf(consolidation, voxel); });
  const CropCost cost{1e6 * raw / points,
                      1e6 * seconds / static_cast<double>(representatives)};
  MarkdownRow()
      .text(cloud.name)
      .count(cloud.size())
      .number(cost.raw, 2)
      .count(representatives)
      .number(cost.consolidated, 2)
      .print();
  return cost;
}

void
printSpread(const std::vector<CropCost>& costs)
{
  const auto [min_raw, max_raw] = std::minmax_element(
      costs.begin(), costs.end(), [](auto& a, auto& b) { return a.raw < b.raw; });
  const auto [minimum, maximum] =
      std::minmax_element(costs.begin(), costs.end(), [](auto& a, auto& b) {
        return a.consolidated < b.consolidated;
      });
  MarkdownRow()
      .text("slowest to fastest")
      .text("")
      .text(timesOf(max_raw->raw, min_raw->raw))
      .text("")
      .text(timesOf(maximum->consolidated, minimum->consolidated))
      .print();
}

} // namespace

void
printCropSpeed(SceneData& corridor)
{
  std::cout << "\n### Pieces of the corridor, rule Paper\n";
  printHead({"piece",
             "points",
             "raw, CPU us a point",
             "representatives, 5 cm",
             "mesh of these, CPU us a representative"});
  std::vector<CropCost> costs;
  for (const std::size_t size :
       {small_crop, std::size_t{1000000}, std::size_t{5000000}})
    costs.push_back(printRow(makeCrop(corridor.whole(), size), false));
  costs.push_back(printRow(corridor.whole(), true));
  printSpread(costs);
}

void
printConsolidatedSpeed(SceneData& corridor, std::size_t rounds)
{
  std::cout << "\n### All views, consolidated at 5 cm\n";
  const SimulatedCloud& cloud = corridor.whole();
  std::vector<double> consolidations, meshes, sums;
  std::size_t representatives = 0, triangles = 0;
  for (std::size_t round = 0; round < rounds; ++round) {
    ConsolidationReport report;
    Consolidation consolidation;
    consolidations.push_back(
        measureThread([&] { consolidation = consolidate(cloud, voxel, report); }));
    meshes.push_back(measureThread(
        [&] { triangles = meshOf(consolidation, voxel).triangles.size(); }));
    sums.push_back(consolidations.back() + meshes.back());
    representatives = consolidation.representatives.size();
  }
  printHead({"points",
             "representatives",
             "triangles",
             "consolidation, CPU s",
             "mesh, CPU s",
             "sum, CPU s",
             "CPU us a point"});
  MarkdownRow()
      .count(cloud.size())
      .count(representatives)
      .count(triangles)
      .number(median(consolidations), 2)
      .number(median(meshes), 2)
      .number(median(sums), 2)
      .number(1e6 * median(sums) / static_cast<double>(cloud.size()), 3)
      .print();
}

} // namespace pcl::acmap::bench
