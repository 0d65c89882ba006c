#include "bench.h"
#include "bench_data.h"
#include "scenes_with_up.h"

#include <pcl/core/noise_scale.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/up_evidence.h>

#include <Eigen/Core>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap::bench {
namespace {

using Eigen::Vector3d;
using test::SceneWithUp;

/** A cloud of others, its up direction by its README. */
struct RealCloud {
  const char* path;
  Vector3d up;
};

const Vector3d z = Vector3d::UnitZ();

/** These were looked at while the thresholds were chosen; the generated ones were not. */
const std::vector<RealCloud> real_clouds = {
    {"H_field/clouds/room_y_up.ply", Vector3d::UnitY()},
    {"H_field/clouds/facade_z_up.ply", z},
    {"H_field/clouds/flat_15000.ply", z},
    {"H_field/clouds/flat_5000.ply", z},
    {"H_field/clouds/multibeam_room.ply", z},
    {"H_field/clouds/rings_near_horizon.ply", z},
    {"H_field/clouds/building_local.xyz", z},
    {"H_field/clouds/roofs_3_per_m2.ply", z},
    {"G_formats/las/autzen_trim.las", z},
    {"F_planes/navvis_room1/room1_gt_fine.pcd", z},
    {"C_sequence/pcl_room_scans/room_scan1.pcd", z},
    {"D_large/grenoble_room_5.2M.ply.xz", z},
    {"D_large/wtc37_corridor_1M.ply.xz", z}};

struct Answers {
  int found = 0, wrong = 0, assumed_right = 0, assumed_vertical = 0, assumed_wrong = 0;

  void
  operator+=(const Answers& other)
  {
    found += other.found;
    wrong += other.wrong;
    assumed_right += other.assumed_right;
    assumed_vertical += other.assumed_vertical;
    assumed_wrong += other.assumed_wrong;
  }
};

Answers
askTurned(const SceneWithUp& scene)
{
  constexpr double right = 0.97;
  Answers answers;
  for (const Eigen::Matrix3d& turn : test::turnsToAxes()) {
    std::vector<Eigen::Vector3f> points;
    for (const Vector3d& point : scene.points)
      points.emplace_back((turn * point).cast<float>());
    const PointView view(points.data(), sizeof(Eigen::Vector3f), points.size());
    const NoiseScale scale = measureNoiseScale(view, {});
    const UpEvidence up = findUp(view, scale.spacing, scale.sigma);
    const double cosine = up.value.dot(turn * scene.up);
    if (up.isKnown())
      ++(cosine > right ? answers.found : answers.wrong);
    else
      ++(cosine > right    ? answers.assumed_right
         : cosine < -right ? answers.assumed_vertical
                           : answers.assumed_wrong);
  }
  return answers;
}

void
printRow(const std::string& name, const Answers& answers)
{
  Row row;
  row << name << answers.found << atMost(answers.wrong, 0, 0) << answers.assumed_right
      << answers.assumed_vertical << answers.assumed_wrong;
}

constexpr const char* titles =
    "scene, turned to six axes | found | wrong in silence | assumed, right | assumed, "
    "upside down | assumed, wrong axis";

/** At most about half a million points of a cloud. */
SceneWithUp
sceneOf(const RealCloud& real, const PointCloudFile& file)
{
  constexpr std::size_t many = 500000;
  SceneWithUp scene{real.path, {}, real.up};
  const PointView points = file.points();
  const std::size_t step = points.size() / many + 1;
  for (std::size_t i = 0; i < points.size(); i += step)
    if (points[i].allFinite())
      scene.points.push_back(points[i].cast<double>());
  return scene;
}

void
printReal()
{
  printHead(titles);
  Answers all;
  for (const RealCloud& real : real_clouds)
    if (const std::optional<std::string> path = pathOfData(real.path)) {
      const Answers answers = askTurned(sceneOf(real, loadMaybePacked(*path)));
      printRow(real.path, answers);
      all += answers;
    }
  printRow("all", all);
}

void
printGenerated()
{
  printHead(titles);
  std::map<std::string, Answers> kinds;
  Answers all;
  for (std::uint64_t seed = 41; seed < 47; ++seed)
    for (const SceneWithUp& scene : test::scenesWithUp(seed)) {
      const Answers answers = askTurned(scene);
      kinds[scene.name] += answers;
      all += answers;
    }
  for (const auto& [name, answers] : kinds)
    printRow(name, answers);
  printRow("all", all);
}

const Section real_section("real", printReal);
const Section generated_section("generated", printGenerated);

} // namespace
} // namespace pcl::acmap::bench
