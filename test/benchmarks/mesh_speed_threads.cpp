#include "mesh_speed_tables.h"

#include "markdown_row.h"
#include "raw_mesh.h"
#include "timing.h"

#include <cmath>
#include <iostream>
#include <thread>

namespace pcl::acmap::bench {
namespace {

using Triangles = TriangleMesh::Triangles;

double
sumOfRoots(std::size_t begin, std::size_t end)
{
  double sum = 0;
  for (std::size_t i = begin; i < end; ++i)
    sum += std::sqrt(static_cast<double>(i));
  return sum;
}

/** A loop without shared data or memory access: the upper bound of the machine. */
void
sumRoots(unsigned threads)
{
  constexpr std::size_t numbers = 500000000;
  std::vector<std::thread> others;
  const std::size_t part = numbers / threads;
  for (unsigned t = 0; t < threads; ++t)
    others.emplace_back([=] {
      [[maybe_unused]] const volatile double sum = sumOfRoots(t * part, (t + 1) * part);
    });
  for (std::thread& other : others)
    other.join();
}

void
printRow(const std::string& name, const Cost& one, const Cost& two)
{
  MarkdownRow()
      .text(name)
      .number(one.cpu, 2)
      .number(two.cpu, 2)
      .number(one.wall, 2)
      .number(two.wall, 2)
      .text(timesOf(two.cpu, one.cpu))
      .text(timesOf(one.wall, two.wall))
      .print();
}

void
printRootsRow(std::size_t rounds)
{
  std::vector<Cost> one, two;
  for (std::size_t round = 0; round < rounds; ++round) {
    one.push_back(measureCost([] { sumRoots(1); }));
    two.push_back(measureCost([] { sumRoots(2); }));
  }
  printRow("bound: square roots", medianCost(one), medianCost(two));
}

Triangles
meshWith(unsigned threads, const SimulatedCloud& cloud, std::vector<Cost>& costs)
{
  Triangles triangles;
  costs.push_back(measureCost([&] {
    triangles = meshRaw(cloud.points(), DeWallRule::Paper, threads).mesh.triangles;
  }));
  return triangles;
}

/** Are the meshes the same for 1, 2 and 8 threads? */
bool
printMeshRow(const SimulatedCloud& cloud, std::size_t rounds)
{
  std::vector<Cost> one, two, many;
  bool are_same = true;
  Triangles first;
  for (std::size_t round = 0; round < rounds; ++round) {
    first = meshWith(1, cloud, one);
    are_same = meshWith(2, cloud, two) == first && are_same;
  }
  are_same = meshWith(8, cloud, many) == first && are_same;
  printRow(cloud.name, medianCost(one), medianCost(two));
  return are_same;
}

} // namespace

void
printThreadSpeed(SceneData& corridor)
{
  std::cout << "\n### Threads, rule Paper on raw points\n";
  printHead({"what",
             "1 thread, CPU s",
             "2 threads, CPU s",
             "1 thread, wall s",
             "2 threads, wall s",
             "CPU of 2 to 1",
             "speed-up"});
  printRootsRow(3);
  const bool is_small_same = printMeshRow(makeCrop(corridor.whole(), 1000000), 3);
  const bool is_large_same = printMeshRow(makeCrop(corridor.whole(), 5000000), 1);
  std::cout << "\nThe meshes of 1, 2 and 8 threads are "
            << (is_small_same && is_large_same ? "the same bytes." : "**different**.")
            << std::endl;
}

} // namespace pcl::acmap::bench
