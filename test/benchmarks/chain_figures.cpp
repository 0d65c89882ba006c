#include "bench.h"
#include "bench_data.h"
#include "chain_runs.h"
#include "temporary_folder.h"

#include <pcl/core/trajectory_error.h>

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
printPath(const ChainWay& way, const ChainRun& run)
{
  const auto found = posesOf(run, &ChainView::found);
  const auto given = posesOf(run, &ChainView::given);
  const RelativePoseError next = relativePoseError(found, given);
  const RelativePoseError tenth = relativePoseError(found, given, 10);
  const PointAgreement points = comparePoints(run.views);
  Row() << way.name << run.observations << run.observations - run.views.size()
        << figure(centi * absoluteTrajectoryError(found, given).aligned, 1)
        << figure(centi * next.translation_rms, 1)
        << figure(next.rotation_rms / degree, 2)
        << figure(centi * tenth.translation_rms, 1)
        << figure(tenth.rotation_rms / degree, 2) << figure(centi * points.median, 1)
        << figure(centi * points.maximum, 1);
}

constexpr std::size_t furthest = 30; // maximum step between compared views

void
printSurfaces(const ChainWay& way, const ChainRun& run)
{
  Row row;
  row << way.name;
  for (const std::size_t step :
       {std::size_t(1), std::size_t(5), std::size_t(10), furthest}) {
    const SurfaceAgreement surfaces =
        compareSurfaces(run.views, step, &ChainView::found);
    row << surfaces.pieces << figure(milli * surfaces.median, 1)
        << figure(milli * surfaces.maximum, 1);
  }
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
  Row() << way.name << run.map.planes.size() << figure(area, 1)
        << figure(milli * std::sqrt(squares / area), 1) << planes.planes
        << figure(100 * planes.area, 0) << figure(planes.angle, 2)
        << figure(planes.angle_maximum, 2) << figure(milli * planes.offset, 1)
        << figure(milli * planes.offset_maximum, 1)
        << std::to_string(std::lround(run.compactness)) + " : 1"
        << figure(run.seconds, 1)
        << figure(1e-9 * static_cast<double>(run.peak_memory), 2);
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
  printHead("way | observations | without a pose | ATE aligned, cm | RPE to the next, "
            "rms, cm | degrees | to the 10th next, cm | degrees | the same points "
            "apart, median, cm | 95 %");
  for (std::size_t i = 0; i < ways.size(); ++i)
    printPath(ways[i], runs[i]);
  printHead("way | views 1 apart: pieces | across, median, mm | 90 % | 5 apart: pieces "
            "| median | 90 % | 10 apart: pieces | median | 90 % | 30 apart: pieces | "
            "median | 90 %");
  for (std::size_t i = 0; i < ways.size(); ++i)
    if (runs[i].views.size() > furthest)
      printSurfaces(ways[i], runs[i]);
  printHead("way | planes | area, m² | rms, mm | partners of the first row's planes | "
            "near in % of their area | angle, median, degrees | most | offset, median, "
            "mm | most | compactness | CPU, s | memory, GB");
  for (std::size_t i = 0; i < ways.size(); ++i)
    printMap(ways[i], runs[i], runs[0]);
}

const Section kitchen_section("kitchen", [] {
  const auto folder = pathOfKitchen();
  if (!folder)
    return;
  const test::TemporaryFolder work;
  std::vector<ChainRun> runs;
  for (const ChainWay& way : waysOfKitchen())
    runs.push_back(runChainOfTools(way, *folder, work.path("")));
  printTables(waysOfKitchen(), runs);
});

} // namespace
} // namespace pcl::acmap::bench
