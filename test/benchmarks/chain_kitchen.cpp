#include "chain_agreement.h"
#include "chain_tables.h"
#include "markdown_row.h"
#include "temporary_folder.h"
#include "test_data.h"
#include "units.h"

#include <pcl/core/trajectory_error.h>

#include <cmath>
#include <iostream>

namespace pcl::acmap::bench {
namespace {

/** Poses of one kind, in the order of the views. */
std::vector<Eigen::Isometry3d>
posesOf(const ChainRun& run, Eigen::Isometry3d ChainView::*pose)
{
  std::vector<Eigen::Isometry3d> poses;
  for (const ChainView& view : run.views)
    poses.push_back(view.*pose);
  return poses;
}

void
printPathHead()
{
  printHead({"way",
             "observations",
             "without a pose",
             "ATE aligned, cm",
             "RPE to the next, rms, cm",
             "degrees",
             "to the 10th next, cm",
             "degrees",
             "the same points apart, median, cm",
             "95 %"});
}

void
printPath(const ChainWay& way, const ChainRun& run)
{
  const auto found = posesOf(run, &ChainView::found);
  const auto given = posesOf(run, &ChainView::given);
  const RelativePoseError next = relativePoseError(found, given);
  const RelativePoseError tenth = relativePoseError(found, given, 10);
  const PointAgreement points = comparePoints(run.views);
  MarkdownRow()
      .text(way.name)
      .count(run.observations)
      .count(run.observations - run.views.size())
      .number(centi * absoluteTrajectoryError(found, given).aligned, 1)
      .number(centi * next.translation_rms, 1)
      .number(next.rotation_rms / degree, 2)
      .number(centi * tenth.translation_rms, 1)
      .number(tenth.rotation_rms / degree, 2)
      .number(centi * points.median, 1)
      .number(centi * points.maximum, 1)
      .print();
}

constexpr std::size_t furthest = 30; // maximum step between compared views

void
printSurfaces(const ChainWay& way, const ChainRun& run)
{
  MarkdownRow row;
  row.text(way.name);
  for (const std::size_t step :
       {std::size_t(1), std::size_t(5), std::size_t(10), furthest}) {
    const SurfaceAgreement surfaces =
        compareSurfaces(run.views, step, &ChainView::found);
    row.count(surfaces.pieces)
        .number(milli * surfaces.median, 1)
        .number(milli * surfaces.maximum, 1);
  }
  row.print();
}

void
printMap(const ChainWay& way, const ChainRun& run, const ChainRun& reference)
{
  const PlaneAgreement planes = comparePlanes(
      reference.map.planes, run.map.planes, comparePoints(run.views).T_given_found);
  double area = 0, squares = 0;
  for (const PlanePatch& plane : run.map.planes) {
    area += plane.area;
    squares += plane.area * plane.rms * plane.rms;
  }
  MarkdownRow()
      .text(way.name)
      .count(run.map.planes.size())
      .number(area, 1)
      .number(milli * std::sqrt(squares / area), 1)
      .count(planes.planes)
      .number(100 * planes.area, 0)
      .number(planes.angle, 2)
      .number(planes.angle_maximum, 2)
      .number(milli * planes.offset, 1)
      .number(milli * planes.offset_maximum, 1)
      .text(std::to_string(std::lround(run.compactness)) + " : 1")
      .number(run.seconds, 1)
      .number(1e-9 * static_cast<double>(run.peak_memory), 2)
      .print();
}

const std::vector<ChainWay>&
waysOfKitchen()
{
  static const std::vector<ChainWay> ways = {
      {"given poses", 1, true, {"--no-rectification"}},
      {"given poses, rectified", 1, true, {}},
      {"our own poses", 1, false, {"--no-rectification"}},
      {"our own poses, rectified", 1, false, {}},
      {"our own poses, features alone",
       1,
       false,
       {"--no-rectification", "--no-refinement"}},
      {"given poses, voxels of 5 cm",
       1,
       true,
       {"--no-rectification", "--consolidate", "0.05"}},
      {"our own poses, voxels of 5 cm",
       1,
       false,
       {"--no-rectification", "--consolidate", "0.05"}},
      {"given poses, each 2nd view", 2, true, {"--no-rectification"}},
      {"our own poses, each 2nd view", 2, false, {"--no-rectification"}},
      {"given poses, each 3rd view", 3, true, {"--no-rectification"}},
      {"our own poses, each 3rd view", 3, false, {"--no-rectification"}}};
  return ways;
}

void
printTables(const std::vector<ChainWay>& ways, const std::vector<ChainRun>& runs)
{
  printPathHead();
  for (std::size_t i = 0; i < ways.size(); ++i)
    printPath(ways[i], runs[i]);
  printHead({"way",
             "views 1 apart: pieces",
             "across, median, mm",
             "90 %",
             "5 apart: pieces",
             "median",
             "90 %",
             "10 apart: pieces",
             "median",
             "90 %",
             "30 apart: pieces",
             "median",
             "90 %"});
  for (std::size_t i = 0; i < ways.size(); ++i)
    if (runs[i].views.size() > furthest)
      printSurfaces(ways[i], runs[i]);
  printHead({"way",
             "planes",
             "area, m²",
             "rms, mm",
             "partners of the first row's planes",
             "near in % of their area",
             "angle, median, degrees",
             "most",
             "offset, median, mm",
             "most",
             "compactness",
             "CPU, s",
             "memory, GB"});
  for (std::size_t i = 0; i < ways.size(); ++i)
    printMap(ways[i], runs[i], runs[0]);
}

} // namespace

void
printChainKitchen()
{
  const std::string folder = "C_sequence/redkitchen_000_495";
  if (!test::hasTestData(folder + "/frame-000000.pose.txt")) {
    std::cout << "\nkitchen: left out, no " << folder << "\n";
    return;
  }
  const test::TemporaryFolder work;
  std::vector<ChainRun> runs;
  for (const ChainWay& way : waysOfKitchen())
    runs.push_back(
        runChainOfTools(way, test::testDataPath(folder).string(), work.path("")));
  printTables(waysOfKitchen(), runs);
}

} // namespace pcl::acmap::bench
