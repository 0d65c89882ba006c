#include "primitive_tables.h"

#include "cpu_time.h"
#include "cylinder_scenes.h"
#include "markdown_row.h"
#include "statistics.h"

#include <pcl/segmentation/cylinder_hypothesis_clustering.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>

namespace pcl::acmap::bench {
namespace {

std::vector<CylinderPatch>
findCylinders(const test::CylinderView& view)
{
  CylinderHypothesisClustering<PointXYZ> clustering;
  clustering.setInputCloud(view.cloud);
  clustering.setSourceCloud(view.cloud);
  std::vector<CylinderPatch> patches;
  clustering.segment(patches);
  return patches;
}

/** The patch of a cylinder: nearly on its axis, with nearly its radius. */
const CylinderPatch*
patchOf(const test::SceneCylinder& truth, const std::vector<CylinderPatch>& patches)
{
  constexpr double parallel = 0.99;  // 8 degrees
  constexpr double tolerance = 0.25; // of the radius
  for (const CylinderPatch& patch : patches) {
    const Eigen::Vector3d way = patch.axis_point - truth.point;
    const double off = (way - way.dot(truth.axis) * truth.axis).norm();
    if (std::abs(truth.axis.dot(patch.axis_direction)) > parallel &&
        std::abs(patch.radius - truth.radius) < tolerance * truth.radius &&
        off < tolerance * truth.radius)
      return &patch;
  }
  return nullptr;
}

constexpr double millimetre = 1e-3;

} // namespace

void
printHalfSeen()
{
  constexpr std::size_t seeds = 20;
  std::cout << "\n### Half-seen columns\n";
  printHead({"noise mm",
             "found",
             "spurious",
             "median radius error mm",
             "largest mm",
             "CPU s a scene"});
  for (const auto& [sigma, reach] :
       {std::pair(0.003, 0.4), std::pair(0.01, 2.0), std::pair(0.02, 5.0)}) {
    std::size_t all = 0, found = 0, spurious = 0;
    std::vector<double> errors;
    const double begin = processSeconds();
    for (std::size_t seed = 0; seed < seeds; ++seed) {
      const test::CylinderView view = test::seeColumns(sigma, seed);
      const std::vector<CylinderPatch> patches = findCylinders(view);
      std::size_t right = 0;
      for (const test::SceneCylinder& truth : view.cylinders)
        if (const CylinderPatch* patch = patchOf(truth, patches)) {
          ++right;
          errors.push_back(std::abs(patch->radius - truth.radius) / millimetre);
        }
      all += view.cylinders.size();
      found += right;
      spurious += patches.size() - std::min(patches.size(), right);
    }
    const double seconds = (processSeconds() - begin) / seeds;
    MarkdownRow()
        .number(sigma / millimetre, 0)
        .atLeast(static_cast<double>(found), static_cast<double>(all), 0)
        .atMost(static_cast<double>(spurious), 0, 0)
        .number(median(errors), 2)
        .atMost(quantile(errors, 1), reach, 2)
        .number(seconds, 2)
        .print();
  }
}

void
printWalls()
{
  constexpr std::size_t seeds = 5;
  std::cout << "\n### Walls\n";
  printHead({"wall", "noise mm", "walls", "cylinders", "largest radius error mm"});
  for (const double bow : {0.0, 0.025, 0.06})
    for (const double sigma : {0.003, 0.01}) {
      std::size_t cylinders = 0;
      for (std::size_t seed = 0; seed < seeds; ++seed)
        cylinders +=
            findCylinders(test::seeWall([&](double x) { return bow * (1 - x * x / 9); },
                                        sigma,
                                        seed))
                .size();
      MarkdownRow()
          .text(bow == 0
                    ? std::string("flat")
                    : "bowed by " + std::to_string(std::lround(1000 * bow)) + " mm")
          .number(sigma / millimetre, 0)
          .count(seeds)
          .atMost(static_cast<double>(cylinders), 0, 0)
          .text("")
          .print();
    }
  for (const bool is_hollow : {false, true})
    for (const double sigma : {0.003, 0.01}) {
      std::size_t cylinders = 0;
      double largest = 0;
      for (std::size_t seed = 0; seed < seeds; ++seed) {
        const test::CylinderView view = test::seeRoundWall(is_hollow, sigma, seed);
        const std::vector<CylinderPatch> patches = findCylinders(view);
        const CylinderPatch* const patch = patchOf(view.cylinders[0], patches);
        cylinders += patch && patches.size() == 1 ? 1 : 0;
        if (patch)
          largest = std::max(largest, std::abs(patch->radius - 10) / millimetre);
      }
      MarkdownRow()
          .text(is_hollow ? "radius 10 m, hollow" : "radius 10 m")
          .number(sigma / millimetre, 0)
          .count(seeds)
          .atLeast(static_cast<double>(cylinders), seeds, 0)
          .atMost(largest, 4, 1)
          .print();
    }
}

void
printSigma()
{
  constexpr std::uint64_t seeds = 20;
  std::cout << "\n### Told uncertainty\n";
  printHead({"noise mm", "radius cm", "fits", "rms of error over told sigma"});
  for (const double sigma : {0.003, 0.01, 0.02}) {
    std::map<double, std::vector<double>> squares; // of each radius, over the variance
    for (std::uint64_t seed = 100; seed < 100 + seeds; ++seed) {
      const test::CylinderView view = test::seeColumns(sigma, seed);
      const std::vector<CylinderPatch> patches = findCylinders(view);
      for (const test::SceneCylinder& truth : view.cylinders)
        if (const CylinderPatch* const patch = patchOf(truth, patches))
          squares[truth.radius].push_back(std::pow(patch->radius - truth.radius, 2) /
                                          patch->covariance(4, 4));
    }
    for (const auto& [radius, ratios] : squares) {
      const double mean = std::accumulate(ratios.begin(), ratios.end(), 0.0) /
                          static_cast<double>(ratios.size());
      const double ratio = std::sqrt(mean);
      std::ostringstream text;
      text << std::fixed << std::setprecision(2) << ratio << " (0.8 to 1.25)";
      const bool is_right = ratio >= 0.8 && ratio <= 1.25;
      MarkdownRow()
          .number(sigma / millimetre, 0)
          .number(100 * radius, 0)
          .count(ratios.size())
          .text(is_right ? text.str() : "**" + text.str() + "**")
          .print();
    }
  }
}

} // namespace pcl::acmap::bench
