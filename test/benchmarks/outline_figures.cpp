#include "bench.h"
#include "bench_data.h"
#include "outline_scores.h"
#include "simulated_clouds.h"

#include <pcl/pipeline/observation_merging.h>
#include <pcl/pipeline/rgbd_cameras.h>
#include <pcl/pipeline/rgbd_sequence.h>
#include <pcl/simulation/standard_scenes.h>

namespace pcl::acmap::bench {
namespace {

/** A simulated scene whose outlines were judged. */
struct JudgedScene {
  std::string name;
  OutlineCounts counts;
  OutlineScores scores;
  double seen = 0;    ///< square metres, of all true planes
  double seconds = 0; ///< of the outlines
};

JudgedScene
judge(const std::string& name, const SimulatedScene& scene, const VisibleTruth& truth)
{
  const JudgedMap map = findJudgedMap(scene);
  const std::vector<PlaneOutline> outlines =
      makeOutlines(map.planes, scene.views.front());
  return {name,
          countOutlines(outlines),
          scoreOutlines(outlines, truth),
          truth.seenArea(),
          map.seconds};
}

double
share(double part, double whole)
{
  return 100 * part / whole;
}

void
printCreases(const std::vector<JudgedScene>& scenes)
{
  printHead("scene | planes | matched | true creases, m | of planes found, m | of "
            "these shared exactly % | of all % | gap above 1 cm, m | corners | error, "
            "median, mm | 95 % | vertices a plane, mean | median | polygons that cross "
            "themselves | holes | slivers | outlines, CPU s");
  for (const JudgedScene& scene : scenes) {
    const OutlineScores& scores = scene.scores;
    const auto spurious = std::count(
        scores.face_of_plane.begin(), scores.face_of_plane.end(), std::int32_t{-1});
    Row() << scene.name << scene.counts.planes
          << (scene.counts.planes - static_cast<std::size_t>(spurious))
          << figure(scores.creases, 1) << figure(scores.found, 1)
          << figure(share(scores.shared, scores.found), 1)
          << figure(share(scores.shared, scores.creases), 1) << figure(scores.gaps, 2)
          << scores.corners.size() << figure(milli * median(scores.corners), 1)
          << figure(milli * quantile(scores.corners, 0.95), 0)
          << figure(scene.counts.vertices_mean, 1)
          << figure(scene.counts.vertices_median, 0) << scene.counts.crossed
          << scene.counts.holes << scene.counts.slivers << figure(scene.seconds, 3);
  }
}

void
printAreas(const std::vector<JudgedScene>& scenes)
{
  printHead("scene | seen, m² | of planes found, m² | IoU | seen but missing % | "
            "deeper than 5 cm, m² | surplus, unseen surface % | surplus over nothing % "
            "| deeper than 5 cm, m² | planes of no face, m² | area : seen area");
  for (const JudgedScene& scene : scenes) {
    const OutlineScores& scores = scene.scores;
    Row() << scene.name << figure(scene.seen, 1) << figure(scores.seen, 1)
          << figure(scores.common / scores.joined, 4)
          << figure(share(scores.missing, scores.seen), 2)
          << figure(scores.missing_inside, 3)
          << figure(share(scores.unseen, scores.seen), 2)
          << figure(share(scores.nothing, scores.seen), 2)
          << figure(scores.nothing_inside, 3) << figure(scores.unmatched_area, 2)
          << figure(scene.counts.area / scene.seen, 3);
  }
}

const Section scenes_section("scenes", [] {
  std::vector<JudgedScene> scenes;
  for (const std::string name : {"corridor_survey", "office", "l_corridor", "loop"}) {
    SimulatedScene scene = standardScene(name);
    const VisibleTruth truth = findVisibleTruth(scene);
    scenes.push_back(judge(name, scene, truth));
    scene.sensor.points = static_cast<std::size_t>(scene.rig.width) *
                          static_cast<std::size_t>(scene.rig.height);
    scene.sensor.views_with_one_more = 0;
    scenes.push_back(judge(name + "_all_pixels", scene, truth));
  }
  printCreases(scenes);
  printAreas(scenes);
});

/** \brief Copies of a scene side by side, each with its own sensors, at heights and in
 * directions of their own: otherwise, their planes would be one. */
JudgedMap
mapCopies(const MergedObservations& one, std::size_t copies)
{
  constexpr std::size_t a_row = 7;
  constexpr double step = 40, rise = 0.5, turn = 0.25; // metres, radians
  MergedObservations all;
  for (std::size_t copy = 0; copy < copies; ++copy) {
    const auto number = static_cast<double>(copy);
    const Eigen::Isometry3d T_all_one =
        Eigen::Translation3d(step * static_cast<double>(copy % a_row),
                             rise * number,
                             step * static_cast<double>(copy / a_row)) *
        Eigen::AngleAxisd(turn * number, Eigen::Vector3d::UnitY());
    const auto first_view = static_cast<std::int32_t>(all.trajectory.poses.size());
    for (const Eigen::Isometry3d& pose : one.trajectory.poses)
      all.trajectory.poses.push_back(T_all_one * pose);
    for (const Eigen::Vector3f& point : one.points)
      all.points.emplace_back(T_all_one.cast<float>() * point);
    for (const std::int32_t view : one.view)
      all.view.push_back(first_view + view);
  }
  all.rgb.resize(all.points.size());
  all.label.resize(all.points.size());
  const auto file = std::make_shared<PointCloudFile>();
  file->cloud = cloudOf(all);
  std::vector<Eigen::Vector3f> viewpoints;
  for (const Eigen::Isometry3d& pose : all.trajectory.poses)
    viewpoints.emplace_back(pose.translation().cast<float>());
  return findJudgedMap(file, viewpoints);
}

const Section size_section("size", [] {
  SimulatedScene scene = standardScene("loop");
  scene.sensor.points = 20000;
  const MergedObservations one = makeSceneCloud(scene).merged;
  printHead("copies of `loop` | points | planes | vertices a plane | outlines, CPU s | "
            "a plane, ms");
  for (const std::size_t copies : {1, 8, 46}) {
    const JudgedMap map = mapCopies(one, copies);
    const auto planes = static_cast<double>(map.planes.size());
    Row() << copies << copies * one.points.size() << map.planes.size()
          << figure(countOutlines(makeOutlines(map.planes, scene.views.front()))
                        .vertices_mean,
                    1)
          << figure(map.seconds, 3) << figure(milli * map.seconds / planes, 2);
  }
});

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

/** Lengths of outlines in metres. A place is near another plane if it is within three
 * voxels of its polygons, unless the planes are nearly parallel. */
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

JudgedMap
mapScan(const Scan& scan, const std::string& path)
{
  if (std::string(scan.file).rfind("D_large", 0) == 0)
    return findJudgedMap(std::make_shared<PointCloudFile>(loadMaybePacked(path)), {});
  const RgbdSequence recorded =
      openRgbdSequence(path.substr(0, path.find_last_of('/')));
  ObservationMerging merging;
  MergedCloud merged;
  merging.compute(ObservationSequence(recorded, recorded.cameras()), merged);
  const auto file = std::make_shared<PointCloudFile>();
  file->cloud = merged.cloud.copy();
  return findJudgedMap(file, merged.viewpoints);
}

const Section scans_section("scans", [] {
  printHead("scan | planes | vertices a plane, mean | median | polygons | holes | "
            "slivers | polygons that cross themselves | area, m² | outline, m | shared "
            "exactly, m | near another plane, m | of this shared exactly % | to 2 mm % "
            "| touching to 2 mm % | outlines, CPU s");
  for (const Scan& scan : scans)
    if (const auto path = pathOfData(scan.file)) {
      const JudgedMap map = mapScan(scan, *path);
      const std::vector<PlaneOutline> outlines = makeOutlines(map.planes);
      const OutlineCounts counts = countOutlines(outlines);
      const SharedLengths lengths = measureShared(outlines, scan.near);
      Row() << scan.name << counts.planes << figure(counts.vertices_mean, 1)
            << figure(counts.vertices_median, 0) << counts.polygons << counts.holes
            << counts.slivers << counts.crossed << figure(counts.area, 1)
            << figure(lengths.all, 0) << figure(lengths.exact, 0)
            << figure(lengths.near, 0)
            << figure(share(lengths.exact_near, lengths.near), 1)
            << figure(share(lengths.within, lengths.near), 1)
            << figure(share(lengths.touching, lengths.near), 1)
            << figure(map.seconds, 3);
    }
});

} // namespace
} // namespace pcl::acmap::bench
