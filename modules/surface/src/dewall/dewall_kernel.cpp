#include "dewall_kernel.h"

#include "facing.h"
#include "flat_patches.h"
#include "mesh_steps.h"
#include "spacing.h"
#include "triangle_builder.h"

#include <pcl/core/impl/length_remarks.h>
#include <pcl/core/impl/parallel.h>

#include <atomic>
#include <cstdlib>
#include <sstream>
#include <thread>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

/** \brief Reports the progress from time to time as the fraction of processed edges,
 * only from the calling thread; the tasks of other threads only count. */
class Ticker {
public:
  Ticker(const Progress& progress, std::int32_t points, DeWallRule rule)
  : progress_(progress)
  , expected_((rule == DeWallRule::Strict ? 12.0 : 4.0) * points)
  {}

  void
  operator()()
  {
    const std::size_t count = count_.fetch_add(1, std::memory_order_relaxed);
    if (count % 8 == 0) // an edge of the last passes brings in pages from everywhere
      pollRun();
    if (count % 512 == 0 && std::this_thread::get_id() == caller_)
      progress_.tell(0.05 + 0.9 * std::min(1.0, static_cast<double>(count) / expected_),
                     "triangulation");
  }

private:
  const Progress& progress_;
  const double expected_;
  const std::thread::id caller_ = std::this_thread::get_id();
  std::atomic<std::size_t> count_{0};
};

void
remarkOnInput(DeWallReport& report)
{
  const auto remark = [&](std::size_t count, const char* what) {
    if (count > 0)
      report.remarks.push_back(std::to_string(count) + " of " +
                               std::to_string(report.points) + " points " + what);
  };
  remark(report.invalid_points, "are not finite and were skipped");
  remark(report.duplicate_points,
         "repeat the place of an earlier one and were skipped");
}

std::string
whyEmpty(const SizeConstraint& size)
{
  std::ostringstream reason;
  reason << "no triangle: no three points within the maximum edge length ("
         << size.minimum() << " to " << size.largest() << " m) that are not on a line";
  return reason.str();
}

void
remarkOnSearch(const Spacing& spacing, DeWallReport& report)
{
  if (spacing.unanswered > 0)
    report.remarks.push_back("the search method found no neighbour of " +
                             std::to_string(spacing.unanswered) + " of " +
                             std::to_string(spacing.asked) +
                             " points; the nearest ones were taken there");
}

/** \brief Returns the triangle lists of the parts and of the last passes, and counts
 * the walls and rejections of the parts. */
std::vector<TriangleList>
listsOf(std::vector<Part>& parts, GrowingMesh& mesh, DeWallReport& report)
{
  const std::size_t divided = parts.size() / 2; // they come before the leaves
  std::vector<TriangleList> lists;
  for (Part& part : parts) {
    report.walls += lists.size() < divided && !part.triangles.empty();
    lists.push_back({&part.triangles, static_cast<std::uint8_t>(part.node.depth)});
    report.refused_moebius += part.refused_moebius;
    report.removed_fans += part.removed_fans;
  }
  lists.push_back({&mesh.triangles(), TriangleMesh::no_wall});
  report.refused_moebius += mesh.refusedMoebius();
  return lists;
}

/** \param[out] sides by what the mesh is oriented; without facing directions, too */
Facing
facingOf(const PointTree& tree,
         const Spacing& spacing,
         const DeWallInput& input,
         const DeWallSettings& settings,
         DeWallSides& sides)
{
  sides = DeWallSides::Outward;
  if (settings.outward)
    return {};
  sides = DeWallSides::FreeSpace;
  if (settings.up)
    return Facing::along(freeSpaceNormals(tree, spacing, input.normals, *settings.up));
  sides = DeWallSides::Sensor;
  if (input.is_single_view)
    return Facing::towards(tree, input.sensor_origin);
  Facing by_normals = Facing::byNormals(tree, input.normals);
  if (by_normals.isKnown())
    sides = DeWallSides::Normals;
  else if (!input.sensor.isKnown())
    sides = DeWallSides::Undetermined;
  return by_normals;
}

/** \brief Maximum number of points of a half that is not divided. */
std::int32_t
leafSizeOf(const DeWallSettings& settings)
{
  constexpr std::int32_t usual = 65536;
  if (settings.leaf_size > 0)
    return settings.leaf_size;
  return settings.rule == DeWallRule::Strict ? 1 : usual;
}

/** \brief The guarded rules: walls and halves, then the last passes. */
TriangleMesh
guardedMesh(const PointTree& tree,
            const SizeConstraint& size,
            const Facing& facing,
            const Eigen::Vector3d& sensor_origin,
            const DeWallSettings& settings,
            const std::function<void()>& tick,
            StepTimer& timer,
            DeWallReport& report)
{
  MeshArrays arrays(tree, facing);
  std::vector<Part> parts =
      buildTriangles(arrays, size, {settings.rule, leafSizeOf(settings)}, tick);
  returnFreeMemory(); // what the parts needed while they grew
  timer.finish("walls and halves");
  std::vector<GrownTriangle> contradictions;
  GrowingMesh mesh = joinParts(arrays, parts, contradictions);
  report.refused_moebius = contradictions.size();
  report.removed_fans =
      finishMesh(mesh, size, settings.rule, parts, std::move(contradictions), tick);
  const std::vector<TriangleList> lists = listsOf(parts, mesh, report);
  timer.finish("last passes");
  countVertices(arrays, report);
  arrays.releaseVertices(); // only the triangles are needed from here on
  PointSets components = findComponents(tree, lists);
  report.clusters = countClusters(tree, size, components);
  timer.finish("clusters");
  TriangleMesh result = orientedMesh(mesh,
                                     lists,
                                     std::move(components),
                                     sensor_origin,
                                     settings.compute_wall_depth,
                                     report);
  timer.finish("orientation");
  return result;
}

} // namespace

TriangleMesh
triangulate(const DeWallInput& input,
            const DeWallSettings& settings,
            const Progress& progress,
            DeWallReport& report)
{
  report = {};
  StepTimer timer(report);
  progress.tell(0, "cells");
  const PointTree tree(distinctPoints(input.points, report));
  timer.finish("cells");
  remarkOnInput(report);
  if (tree.size() < 3) {
    addRemarks(report, lengthRemarks(input.points));
    report.remarks.push_back("no triangle: only " + std::to_string(tree.size()) +
                             " distinct finite points");
    return {};
  }
  Spacing spacing = measureSpacing(tree, input.neighbours);
  if (input.scan.size() > 0 && !input.neighbours)
    reachNextRings(
        tree, RingGaps(input.scan, input.sensor_origin), input.scan_edge, spacing);
  remarkOnSearch(spacing, report);
  report.median_spacing = spacing.median();
  const SizeConstraint size = settings.maximum_edge_length > 0
                                  ? SizeConstraint(tree, settings.maximum_edge_length)
                                  : SizeConstraint(tree, spacing);
  addRemarks(report, lengthRemarks(input.points, report.median_spacing));
  report.min_maximum_edge = size.minimum();
  report.largest_maximum_edge = size.largest();
  timer.finish("spacing");

  const Facing facing = facingOf(tree, spacing, input, settings, report.sides);
  report.sensor = input.sensor;
  Ticker ticker(progress, tree.size(), settings.rule);
  const std::function<void()> tick = [&] { ticker(); };
  TriangleMesh result =
      settings.rule == DeWallRule::Strict
          ? literalMesh(tree,
                        size,
                        facing,
                        input.sensor_origin,
                        settings,
                        leafSizeOf(settings),
                        tick,
                        timer,
                        report)
          : guardedMesh(
                tree, size, facing, input.sensor_origin, settings, tick, timer, report);
  if (result.triangles.empty())
    report.remarks.push_back(whyEmpty(size));
  progress.tell(1, "orientation");
  return result;
}

} // namespace pcl::acmap::ACMAP_DEWALL
