#include "outline_tables.h"

#include "bench_data.h"
#include "map_outlines.h"
#include "markdown_row.h"
#include "packed_cloud.h"

#include <pcl/pipeline/observation_merging.h>
#include <pcl/pipeline/rgbd_cameras.h>
#include <pcl/pipeline/rgbd_sequence.h>

#include <cmath>
#include <iostream>

namespace pcl::acmap::bench {
namespace {

/** \brief A real scan. */
struct Scan {
  const char* name;
  const char* file; ///< a cloud, or a file of an RGB-D folder
  double near;      ///< metres, three voxels of its consolidation
};

constexpr Scan scans[] = {
    {"wtc37_corridor", "D_large/wtc37_corridor_1M.ply.xz", 0.19},
    {"grenoble_room", "D_large/grenoble_room_5.2M.ply.xz", 0.042},
    {"redkitchen", "C_sequence/redkitchen_000_495/frame-000000.pose.txt", 0.091},
};

/** \brief Lengths of outlines in metres. A place is near another plane if it is within
 * three voxels of its polygons, unless the planes are nearly parallel. */
struct SharedLengths {
  double all = 0;
  double exact = 0; ///< edges that another plane has, too
  double near = 0;
  double exact_near = 0; ///< of the near, edges that another plane has, too
  double within = 0;     ///< of the near, within 2 mm of an edge of that plane
  double touching = 0;   ///< of the near, within 2 mm of its surface
};

bool
areParallel(const PlaneOutline& a, const PlaneOutline& b)
{
  constexpr double min_sine = 0.17;
  return a.coefficients.head<3>()
             .cross(Eigen::Vector3d(b.coefficients.head<3>()))
             .norm() < min_sine;
}

SharedLengths
measureShared(const std::vector<PlaneOutline>& outlines, double near)
{
  constexpr double step = 0.01, same = 0.002; // metres
  SharedLengths lengths;
  for (const PlaneOutline& own : outlines) {
    std::vector<const PlaneOutline*> others;
    for (const PlaneOutline& other : outlines)
      if (!areParallel(own, other) && other.box.exteriorDistance(own.box) <= near)
        others.push_back(&other);
    for (const OutlineEdge& edge : own.edges) {
      const double length = (edge.to - edge.from).norm();
      const auto parts = static_cast<int>(std::ceil(length / step));
      for (int k = 0; k < parts; ++k) {
        const double part = length / parts;
        const Eigen::Vector3d place =
            edge.from + (k + 0.5) / parts * (edge.to - edge.from);
        const bool is_exact = !edge.partners.empty();
        lengths.all += part;
        lengths.exact += is_exact ? part : 0;
        double to_surface = near, to_edges = near;
        for (const PlaneOutline* other : others)
          if (other->box.exteriorDistance(place) <= near) {
            to_surface = std::min(to_surface, other->distanceToSurface(place));
            to_edges = std::min(to_edges, other->distanceToEdges(place));
          }
        if (to_surface >= near)
          continue;
        lengths.near += part;
        lengths.exact_near += is_exact ? part : 0;
        lengths.within += to_edges <= same ? part : 0;
        lengths.touching += to_surface <= same ? part : 0;
      }
    }
  }
  return lengths;
}

JudgedCloud
loadScan(const Scan& scan, const std::string& path)
{
  const bool is_cloud = std::string(scan.file).rfind("D_large", 0) == 0;
  if (is_cloud)
    return {std::make_shared<PointCloudFile>(loadMaybePacked(path)), {}};
  const RgbdSequence recorded =
      openRgbdSequence(path.substr(0, path.find_last_of('/')));
  ObservationMerging merging;
  MergedCloud merged;
  merging.compute(ObservationSequence(recorded, recorded.cameras()), merged);
  const auto file = std::make_shared<PointCloudFile>();
  file->cloud = merged.cloud.copy();
  return {file, merged.viewpoints};
}

void
printScan(const Scan& scan, const std::string& path, const OutlineOptions& options)
{
  const JudgedMap map =
      makeJudgedMap(scan.name, options, [&] { return loadScan(scan, path); });
  const std::vector<PlaneOutline> outlines = makeOutlines(map.planes);
  const OutlineCounts counts = countOutlines(outlines);
  const SharedLengths lengths = measureShared(outlines, scan.near);
  const auto ofNear = [&](double part) { return 100 * part / lengths.near; };
  MarkdownRow()
      .text(scan.name)
      .count(counts.planes)
      .number(counts.vertices_mean, 1)
      .number(counts.vertices_median, 0)
      .count(counts.polygons)
      .count(counts.holes)
      .count(counts.slivers)
      .count(counts.crossed)
      .number(counts.area, 1)
      .number(lengths.all, 0)
      .number(lengths.exact, 0)
      .number(lengths.near, 0)
      .number(ofNear(lengths.exact_near), 1)
      .number(ofNear(lengths.within), 1)
      .number(ofNear(lengths.touching), 1)
      .number(map.seconds, 3)
      .print();
}

} // namespace

void
printScanOutlines(const OutlineOptions& options)
{
  std::cout << "\n### Outlines of real scans\n";
  printHead({"scan",
             "planes",
             "vertices a plane, mean",
             "median",
             "polygons",
             "holes",
             "slivers",
             "polygons that cross themselves",
             "area, m²",
             "outline, m",
             "shared exactly, m",
             "near another plane, m",
             "of this shared exactly %",
             "to 2 mm %",
             "touching to 2 mm %",
             "outlines, CPU s"});
  for (const Scan& scan : scans)
    if (const auto path = pathOfData(scan.file))
      printScan(scan, *path, options);
}

} // namespace pcl::acmap::bench
