#include "clusters.h"
#include "distinct_points.h"
#include "facing.h"
#include "oriented_mesh.h"
#include "refill.h"
#include "small_holes.h"
#include "spacing.h"
#include "triangle_builder.h"

#include <pcl/core/parallel.h>
#include <pcl/surface/dewall_kernel.h>

#include <sstream>

namespace pcl::acmap {

namespace dewall {

namespace {

/** \brief Tells the progress now and then, by the share of the points in use. */
class Ticker {
public:
  Ticker(const Progress& progress, const GrowingMesh& mesh, std::int32_t points)
  : progress_(progress)
  , mesh_(mesh)
  , expected_(2.0 * points)
  {}

  void
  operator()()
  {
    if (++count_ % 4096 == 0)
      progress_.tell(fraction(), "triangulation");
  }

private:
  double
  fraction() const
  {
    return 0.05 +
           0.9 *
               std::min(1.0, static_cast<double>(mesh_.triangles().size()) / expected_);
  }

  const Progress& progress_;
  const GrowingMesh& mesh_;
  double expected_;
  std::size_t count_ = 0;
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

/** \brief The deferred sides, with apexes from everywhere. */
void
growAcrossPlanes(const PointTree& tree, Front& front)
{
  const Range all{0, tree.size(), 0, TriangleMesh::no_wall};
  for (const Side& side : front.takeDeferred())
    front.insert(side, all);
  front.advance(all);
  front.advancePostponed(all);
  front.advanceContrary(all);
}

std::string
whyEmpty(const SizeConstraint& size)
{
  std::ostringstream reason;
  reason << "no triangle: no three points within the maximum edge length ("
         << size.least() << " to " << size.largest() << " m) that are not on a line";
  return reason.str();
}

TriangleMesh
triangulate(const PointView& view,
            const DeWallSettings& settings,
            const Progress& progress,
            DeWallReport& report)
{
  report = {};
  StepTimer timer(report);
  progress.tell(0, "cells");
  const PointTree tree(distinctPoints(view, report));
  timer.finish("cells");
  remarkOnInput(report);
  if (tree.size() < 3) {
    report.remarks.push_back("no triangle: only " + std::to_string(tree.size()) +
                             " distinct finite points");
    return {};
  }
  const Spacing spacing = measureSpacing(tree);
  report.median_spacing = spacing.median();
  const SizeConstraint size = settings.maximum_edge_length > 0
                                  ? SizeConstraint(tree, settings.maximum_edge_length)
                                  : SizeConstraint(tree, spacing);
  report.least_maximum_edge = size.least();
  report.largest_maximum_edge = size.largest();
  timer.finish("spacing");

  const Facing facing = settings.is_single_view
                            ? Facing::towards(tree, settings.sensor_origin)
                            : Facing::byNormals(tree, settings.normals);
  GrowingMesh mesh(tree, facing);
  Ticker ticker(progress, mesh, tree.size());
  const auto tick = [&] { ticker(); };
  Front front(tree, size, settings.rule, mesh, tick);
  buildTriangles(tree, mesh, front, 0, {}, 0, settings.leaf_size);
  timer.finish("walls and halves");
  growAcrossPlanes(tree, front);
  if (settings.rule != DeWallRule::Strict) {
    report.removed_fans = mesh.keepLargestFans();
    Refill(tree, size, settings.rule, mesh, tick).run();
  }
  if (settings.rule == DeWallRule::Dense)
    closeSmallHoles(tree, size, mesh);
  report.refused_moebius = mesh.refusedMoebius();
  timer.finish("last passes");
  report.clusters = countClusters(tree, size, mesh.triangles());
  timer.finish("clusters");
  TriangleMesh result = orientedMesh(
      tree, mesh, facing, settings.sensor_origin, settings.compute_wall_depth, report);
  timer.finish("orientation");
  if (result.triangles.empty())
    report.remarks.push_back(whyEmpty(size));
  progress.tell(1, "orientation");
  return result;
}

} // namespace

} // namespace dewall

TriangleMesh
triangulateDeWall(const PointView& view,
                  const DeWallSettings& settings,
                  const Progress& progress,
                  DeWallReport& report)
{
  return withThreads(settings.threads, [&] {
    return dewall::triangulate(view, settings, progress, report);
  });
}

} // namespace pcl::acmap
