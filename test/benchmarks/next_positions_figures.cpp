#include "bench.h"
#include "faulty_sessions.h"
#include "quality/seen_faces.h"
#include "run_tool.h"
#include "temporary_folder.h"

#include <pcl/core/map_file.h>
#include <pcl/pipeline/next_positions.h>
#include <pcl/pipeline/unseen_surfaces.h>
#include <pcl/simulation/ray_casting.h>
#include <pcl/simulation/scene_file.h>
#include <pcl/texture/floor_plan.h>

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <variant>
#include <vector>

// What three proposed positions uncover of a building of which a part was recorded, against a search that
// knows the building.

namespace pcl::acmap::bench {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double spacing = 0.2, reach = 5, eye_height = 1.5; // metres

/** A sample of floor, ceiling or walls of a scene, in the scene's frame. */
struct Sample {
  Vector3d place, normal;
};

/** \return samples of all planes of at least 2 square metres that do not belong to a box */
std::vector<Sample>
samplesOf(const SceneGeometry& scene)
{
  constexpr double min_area = 2; // square metres
  std::vector<Sample> samples;
  for (const SimulatedSurface& surface : scene.surfaces()) {
    const auto* const rectangle = std::get_if<SimulatedRectangle>(&surface.shape);
    if (!rectangle || surface.plane < 0 ||
        scene.planes()[static_cast<std::size_t>(surface.plane)].area() < min_area)
      continue;
    const auto columns =
        std::max(1, static_cast<int>(std::lround(rectangle->edge_u.norm() / spacing)));
    const auto rows =
        std::max(1, static_cast<int>(std::lround(rectangle->edge_v.norm() / spacing)));
    for (int column = 0; column < columns; ++column)
      for (int row = 0; row < rows; ++row)
        samples.push_back({rectangle->corner +
                               (column + 0.5) / columns * rectangle->edge_u +
                               (row + 0.5) / rows * rectangle->edge_v,
                           rectangle->normal()});
  }
  return samples;
}

/** A camera of 60 x 46 degrees. */
TrinocularRig
proposedCamera()
{
  TrinocularRig rig;
  rig.width = 120;
  rig.height = 88;
  rig.focal_length = 60 / std::tan(30 * degree);
  rig.center_x = 59.5;
  rig.center_y = 43.5;
  return rig;
}

Isometry3d
poseOf(const Vector3d& eye, const Vector3d& direction)
{
  const Vector3d right = Vector3d::UnitY().cross(direction).normalized();
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() << right, direction.cross(right), direction;
  pose.translation() = eye;
  return pose;
}

using Seen = std::vector<std::uint64_t>; ///< a bit a sample

/** Which samples a view shows. */
Seen
seenBy(const SimulatedScene& scene,
       const TrinocularRig& rig,
       const Isometry3d& T_scene_camera,
       double farthest,
       const std::vector<Sample>& samples)
{
  constexpr double min_cosine = 0.17, near = 0.05; // metres
  const SurfaceImage image = castView(scene.geometry, rig, T_scene_camera, farthest);
  Seen seen(samples.size() / 64 + 1, 0);
  const Isometry3d T_camera_scene = T_scene_camera.inverse();
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const Vector3d place = T_camera_scene * samples[k].place;
    if (place.z() < 0.2 || place.z() > farthest)
      continue;
    const double distance = place.norm();
    const auto column =
        std::lround(rig.focal_length * place.x() / place.z() + rig.center_x);
    const auto row =
        std::lround(rig.focal_length * place.y() / place.z() + rig.center_y);
    if (column < 0 || row < 0 || column >= rig.width || row >= rig.height)
      continue;
    const double cosine =
        std::abs(
            (samples[k].place - T_scene_camera.translation()).dot(samples[k].normal)) /
        distance;
    const double hit = image.distance[static_cast<std::size_t>(row) *
                                          static_cast<std::size_t>(rig.width) +
                                      static_cast<std::size_t>(column)];
    // a pixel is as wide as the distance over the focal length
    if (cosine >= min_cosine &&
        std::abs(hit - distance) < near + distance / rig.focal_length / cosine)
      seen[k / 64] |= std::uint64_t{1} << (k % 64);
  }
  return seen;
}

/** Which samples are on planes of a map.
 * \param[in] T_map_scene of the truth */
Seen
mappedBy(const CompactMap& map,
         const Isometry3d& T_map_scene,
         const std::vector<Sample>& samples)
{
  constexpr double near = 0.1, min_cosine = 0.9; // metres
  std::vector<SeenFace> faces;
  for (const PlanePatch& plane : map.planes)
    faces.emplace_back(plane);
  Seen seen(samples.size() / 64 + 1, 0);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const Vector3d place = T_map_scene * samples[k].place,
                   normal = T_map_scene.linear() * samples[k].normal;
    if (std::any_of(faces.begin(), faces.end(), [&](const SeenFace& face) {
          return std::abs(face.distanceTo(place)) < near &&
                 std::abs(face.normal().dot(normal)) > min_cosine && face.covers(place);
        }))
      seen[k / 64] |= std::uint64_t{1} << (k % 64);
  }
  return seen;
}

std::size_t
countOf(const Seen& seen)
{
  std::size_t count = 0;
  for (const std::uint64_t bits : seen)
    count += static_cast<std::size_t>(__builtin_popcountll(bits));
  return count;
}

/** What a view adds to what others show. */
std::size_t
gainOf(const Seen& view, const Seen& others)
{
  std::size_t count = 0;
  for (std::size_t k = 0; k < view.size(); ++k)
    count += static_cast<std::size_t>(__builtin_popcountll(view[k] & ~others[k]));
  return count;
}

void
add(const Seen& view, Seen& all)
{
  for (std::size_t k = 0; k < all.size(); ++k)
    all[k] |= view[k];
}

std::size_t
bestOf(const std::vector<Seen>& views, const Seen& others)
{
  std::size_t best = 0, most = 0;
  for (std::size_t k = 0; k < views.size(); ++k)
    if (const std::size_t gain = gainOf(views[k], others); gain > most) {
      best = k;
      most = gain;
    }
  return best;
}

/** Samples that three views add: from each of the best 20 views, greedily, then by exchanging one of the
 * three as long as that helps. */
std::size_t
searched(const std::vector<Seen>& views, const Seen& before)
{
  if (views.empty())
    return 0;
  constexpr std::size_t starts = 20;
  std::vector<std::size_t> order(views.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    order[k] = k;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return gainOf(views[a], before) > gainOf(views[b], before);
  });
  std::size_t most = 0;
  for (std::size_t start = 0; start < std::min(starts, order.size()); ++start) {
    std::array<std::size_t, 3> chosen{order[start], 0, 0};
    const auto without = [&](std::size_t left_out, std::size_t count) {
      Seen seen = before;
      for (std::size_t k = 0; k < count; ++k)
        if (k != left_out)
          add(views[chosen[k]], seen);
      return seen;
    };
    for (std::size_t k = 1; k < 3; ++k)
      chosen[k] = bestOf(views, without(3, k));
    std::size_t total = gainOf(without(3, 3), before);
    for (bool is_better = true; is_better;) {
      is_better = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t old = chosen[k];
        chosen[k] = bestOf(views, without(k, 3));
        const std::size_t now = gainOf(without(3, 3), before);
        is_better |= now > total;
        if (now > total)
          total = now;
        else
          chosen[k] = old;
      }
    }
    most = std::max(most, total);
  }
  return most;
}

/** All views from the floor that was seen, half a metre apart, to twelve sides, level and 25 degrees up
 * and down, from where nothing is nearer than 0.35 m at any height that matters. */
std::vector<Isometry3d>
candidatesOf(const SimulatedScene& scene,
             const std::vector<Sample>& samples,
             const Seen& seen)
{
  constexpr double step = 0.5, clear = 0.35; // metres
  const double floor = std::max_element(samples.begin(),
                                        samples.end(),
                                        [](const Sample& a, const Sample& b) {
                                          return a.place.y() < b.place.y();
                                        })
                           ->place.y();
  std::vector<Isometry3d> candidates;
  std::vector<std::pair<long, long>> taken;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const Vector3d& place = samples[k].place;
    if (place.y() < floor - 0.01 || (seen[k / 64] >> (k % 64) & 1) == 0)
      continue;
    const std::pair<long, long> cell{std::lround(place.x() / step),
                                     std::lround(place.z() / step)};
    if (std::find(taken.begin(), taken.end(), cell) != taken.end())
      continue;
    const bool is_blocked = std::any_of(
        scene.geometry.surfaces().begin(),
        scene.geometry.surfaces().end(),
        [&](const SimulatedSurface& surface) {
          const auto* const rectangle = std::get_if<SimulatedRectangle>(&surface.shape);
          if (const auto* const column = std::get_if<SimulatedCylinder>(&surface.shape))
            return std::hypot(place.x() - column->base.x(),
                              place.z() - column->base.z()) < column->radius + clear;
          if (!rectangle)
            return false;
          const Vector3d arm = place - rectangle->corner;
          // of the rectangle, seen from above; floors and ceilings are not in the way
          const Vector3d other =
              rectangle->corner + rectangle->edge_u + rectangle->edge_v;
          if (std::min(rectangle->corner.y(), other.y()) > floor - 0.05 ||
              std::max(rectangle->corner.y(), other.y()) < floor - 2)
            return false;
          const double dx =
              std::max({std::min(rectangle->corner.x(), other.x()) - place.x(),
                        place.x() - std::max(rectangle->corner.x(), other.x()),
                        0.0});
          const double dz =
              std::max({std::min(rectangle->corner.z(), other.z()) - place.z(),
                        place.z() - std::max(rectangle->corner.z(), other.z()),
                        0.0});
          return arm.allFinite() && std::hypot(dx, dz) < clear;
        });
    if (is_blocked)
      continue;
    taken.push_back(cell);
    for (int yaw = 0; yaw < 12; ++yaw)
      for (const int pitch : {-25, 0, 25}) {
        const double turn = 30 * yaw * degree, tilt = pitch * degree;
        candidates.push_back(poseOf(Vector3d(place.x(), floor - eye_height, place.z()),
                                    {std::cos(tilt) * std::sin(turn),
                                     -std::sin(tilt),
                                     std::cos(tilt) * std::cos(turn)}));
      }
  }
  return candidates;
}

/** A scene of which the first observations were recorded. */
struct PartlySeen {
  const char* scene;
  std::size_t observations;
};

void
printUncovered(const std::vector<PartlySeen>& parts)
{
  printHead(
      "scene | observations | unseen, m² | uncovered by three proposals, m² | by the "
      "search, m² | share, %");
  const test::TemporaryFolder folder;
  for (const PartlySeen& part : parts) {
    const std::string session = folder.path(part.scene),
                      map_folder = session + std::string("_map");
    simulateSession(session, part.scene, 1, true, part.observations);
    test::runTool(ACMAP_COMPACT_MAPPING,
                  {session,
                   "-o",
                   map_folder,
                   "--no-pictures",
                   "--no-details",
                   "--no-rectification",
                   "--texel",
                   "0.05",
                   "--formats",
                   "svg"})
        .succeeded();
    const CompactMap map = loadMapFile(map_folder + "/map.json");
    const FloorPlan plan = makeFloorPlan(map);
    NextPositions next;
    next.setEyeHeight(eye_height);
    next.setReach(reach);
    next.compute(map, plan, findUnseenSurfaces(map, plan));

    const SimulatedScene scene = loadSimulatedScene(session + ".yaml");
    const std::vector<Sample> samples = samplesOf(scene.geometry);
    const Isometry3d& T_scene_map = scene.views.front();
    const Seen seen = mappedBy(map, T_scene_map.inverse(), samples);
    Seen with_proposals = seen;
    for (const NextPosition& position : next.getReport().positions)
      add(seenBy(scene,
                 proposedCamera(),
                 poseOf(T_scene_map * position.eye,
                        T_scene_map.linear() * position.direction),
                 reach,
                 samples),
          with_proposals);
    const std::vector<Isometry3d> candidates = candidatesOf(scene, samples, seen);
    std::vector<Seen> views(candidates.size());
    oneapi::tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t k) {
      views[k] = seenBy(scene, proposedCamera(), candidates[k], reach, samples);
    });
    const std::size_t proposed = gainOf(with_proposals, seen),
                      best = searched(views, seen);
    constexpr double area = spacing * spacing; // of a sample
    Row() << part.scene << part.observations
          << figure(area * static_cast<double>(samples.size() - countOf(seen)), 1)
          << figure(area * static_cast<double>(proposed), 1)
          << figure(area * static_cast<double>(best), 1)
          << atLeast(percent(proposed, best), 70, 0);
    if (std::getenv("ACMAP_NEXT_WORDS"))
      for (const NextPosition& position : next.getReport().positions)
        std::cerr << position.words << " (" << position.uncovered << ")\n";
  }
}

const Section uncovered_section("uncovered", [] {
  printUncovered({{"room", 14},
                  {"office", 16},
                  {"l_corridor", 24},
                  {"loop", 44},
                  {"corridor", 40}});
});

// other parts, at which nobody looked while the class was written
const Section held_out_section("held_out", [] {
  printUncovered({{"room", 24},
                  {"office", 28},
                  {"l_corridor", 40},
                  {"loop", 20},
                  {"corridor", 70},
                  {"corridor_survey", 30}});
});

} // namespace
} // namespace pcl::acmap::bench
