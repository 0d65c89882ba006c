#include "consolidation_tables.h"

#include "consolidated_mesh.h"
#include "markdown_row.h"
#include "peak_memory.h"
#include "simulated_points.h"
#include "statistics.h"
#include "timing.h"

#include <pcl/core/noise_scale.h>
#include <pcl/filters/approximate_voxel_grid.h>
#include <pcl/filters/voxel_consolidation.h>
#include <pcl/filters/voxel_grid.h>

#include <functional>
#include <iostream>

namespace pcl::acmap::bench {
namespace {

constexpr float leaf = 0.05f;      // metres
constexpr double time_reach = 0.2; // us per point
constexpr double cell_bytes = 112;

/** A cloud in all formats that are timed. */
struct TimedCloud {
  const SimulatedCloud& cloud;
  PointCloud<PointXYZ>::Ptr plain;
  PointCloud<PointXYZRGBNormalView>::Ptr map;
};

template <typename PointT>
std::size_t
consolidateCloud(const typename PointCloud<PointT>::Ptr& input,
                 const SimulatedCloud& cloud,
                 double voxel)
{
  VoxelConsolidation<PointT> consolidation;
  consolidation.setVoxelSize(voxel);
  consolidation.setNumberOfThreads(1);
  consolidation.setViewpoints(cloud.sensorOrigins());
  consolidation.setInputCloud(input);
  PointCloud<PointT> output;
  consolidation.filter(output);
  return output.size();
}

template <typename Grid>
std::size_t
downsample(const PointCloud<PointXYZ>::Ptr& input)
{
  Grid grid;
  grid.setLeafSize(leaf, leaf, leaf);
  grid.setInputCloud(input);
  PointCloud<PointXYZ> output;
  grid.filter(output);
  return output.size();
}

std::size_t
readAndSum(const PointCloud<PointXYZ>& cloud)
{
  Eigen::Vector4f sum = Eigen::Vector4f::Zero();
  for (const PointXYZ& point : cloud)
    sum += point.getVector4fMap();
  return sum.allFinite() ? 1 : 0;
}

/** A timed function; returns its number of points or triangles. */
struct Timed {
  std::string name;
  double time_reach;
  std::function<std::size_t()> run;
};

std::vector<Timed>
consolidations(const TimedCloud& c)
{
  std::vector<Timed> all;
  for (const double voxel : {0.05, 0.0}) {
    all.push_back(
        {"VoxelConsolidation, colour and view, " + voxelName(voxel), time_reach, [=] {
           return consolidateCloud<PointXYZRGBNormalView>(c.map, c.cloud, voxel);
         }});
    all.push_back(
        {"VoxelConsolidation, PointXYZ, " + voxelName(voxel), time_reach, [=] {
           return consolidateCloud<PointXYZ>(c.plain, c.cloud, voxel);
         }});
    ConsolidationReport report;
    const auto consolidation =
        std::make_shared<Consolidation>(consolidate(c.cloud, voxel, report));
    all.push_back({"mesh of the representatives, " + voxelName(voxel),
                   no_reach,
                   [consolidation, edge = report.voxel_size] {
                     return meshOf(*consolidation, edge).triangles.size();
                   }});
  }
  return all;
}

std::vector<Timed>
allTimed(const TimedCloud& c)
{
  std::vector<Timed> all = consolidations(c);
  all.push_back({"NoiseScale alone", no_reach, [=] {
                   measureNoiseScale(c.cloud.points(), c.cloud.sensors(), 1);
                   return std::size_t{1};
                 }});
  all.push_back({"PCL VoxelGrid, 5 cm, PointXYZ", no_reach, [=] {
                   return downsample<VoxelGrid<PointXYZ>>(c.plain);
                 }});
  all.push_back({"PCL ApproximateVoxelGrid, 5 cm, PointXYZ", no_reach, [=] {
                   return downsample<ApproximateVoxelGrid<PointXYZ>>(c.plain);
                 }});
  all.push_back({"lower bound: read and sum, PointXYZ", no_reach, [=] {
                   return readAndSum(*c.plain);
                 }});
  return all;
}

void
printRows(const SimulatedCloud& cloud, std::size_t rounds)
{
  const std::vector<Timed> all =
      allTimed({cloud, plainPoints(cloud), mapPoints(cloud)});
  std::vector<std::vector<double>> seconds(all.size());
  std::vector<std::size_t> results(all.size());
  for (std::size_t round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < all.size(); ++i)
      seconds[i].push_back(measureThread([&] { results[i] = all[i].run(); }));
  for (std::size_t i = 0; i < all.size(); ++i)
    MarkdownRow()
        .text(cloud.name)
        .count(cloud.size())
        .text(all[i].name)
        .count(results[i])
        .atMost(1e6 * median(seconds[i]) / static_cast<double>(cloud.size()),
                all[i].time_reach,
                4)
        .print();
}

void
printMemoryRow(const std::string& name, double output, double cells, double peak)
{
  constexpr double mega = 1e6;
  const double allowed = output + cells * cell_bytes;
  MarkdownRow()
      .text(name)
      .number(output / mega, 1)
      .number(cells, 0)
      .number(allowed / mega, 1)
      .atMost(peak / mega, allowed / mega, 1)
      .print();
}

template <typename PointT>
void
printClassMemory(const std::string& name,
                 const typename PointCloud<PointT>::Ptr& input,
                 const SimulatedCloud& cloud,
                 double voxel,
                 std::size_t cells)
{
  const PeakMemory memory;
  const std::size_t output = consolidateCloud<PointT>(input, cloud, voxel);
  const std::size_t peak = memory.bytes();
  printMemoryRow("VoxelConsolidation, " + name + ", " + voxelName(voxel),
                 static_cast<double>(output * sizeof(PointT)),
                 static_cast<double>(cells),
                 static_cast<double>(peak));
}

} // namespace

void
printConsolidationTime(SceneData& corridor, std::size_t rounds)
{
  constexpr std::size_t few_rounds = 3;
  std::cout << "\n### Time\n";
  printHead({"cloud", "points", "what", "points or triangles out", "CPU us a point"});
  printRows(makeViewCloud(corridor.scene(), 0), rounds);
  printRows(makeRandomPart(corridor.whole(), 1000000, 1000000), rounds);
  printRows(corridor.whole(), few_rounds);
}

void
printConsolidationMemory(SceneData& corridor)
{
  std::cout << "\n### Memory\n";
  printHead({"what", "output, MB", "cells", "output and cells, MB", "peak on top, MB"});
  const SimulatedCloud& cloud = corridor.whole();
  for (const double voxel : {0.05, 0.0}) {
    ConsolidationReport report;
    const PeakMemory memory;
    const std::size_t output = consolidate(cloud, voxel, report).representatives.size();
    const std::size_t peak = memory.bytes();
    const std::size_t cells =
        sumVoxels(cloud.points(), cloud.sensors(), report.voxel_size, 1).cells.size();
    printMemoryRow("kernel, " + voxelName(voxel),
                   static_cast<double>(output * sizeof(Representative)),
                   static_cast<double>(cells),
                   static_cast<double>(peak));
    printClassMemory<PointXYZRGBNormalView>(
        "colour and view", mapPoints(cloud), cloud, voxel, cells);
  }
}

} // namespace pcl::acmap::bench
