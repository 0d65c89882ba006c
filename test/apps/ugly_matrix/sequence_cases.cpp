#include "input_cases.h"
#include "small_world.h"

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/core/trajectory.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <limits>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* first = "obs/observation_0000.pcd";
constexpr const char* second = "obs/observation_0001.pcd";
constexpr const char* poses = "obs/trajectory.txt";

/** Reads an observation, changes the position of each pixel, and writes it again. */
void
changePlaces(const std::string& path,
             const std::function<void(Eigen::Vector3f&)>& change,
             float sensor_factor = 1)
{
  PointCloudFile file = loadPointCloud(path);
  for (std::size_t i = 0; i < file.points().size(); ++i) {
    std::uint8_t* const at =
        &file.cloud.data[i * file.cloud.point_step + file.cloud.fields[0].offset];
    Eigen::Vector3f place;
    std::memcpy(place.data(), at, sizeof place);
    change(place);
    std::memcpy(at, place.data(), sizeof place);
  }
  savePointCloud(
      path, file.cloud, sensor_factor * file.sensor_origin, file.sensor_orientation);
}

/** Keeps only this number of points. */
void
keepPoints(const std::string& path, std::size_t kept)
{
  changePlaces(path, [&](Eigen::Vector3f& place) {
    if (place.allFinite() && kept > 0)
      --kept;
    else
      place.setConstant(std::numeric_limits<float>::quiet_NaN());
  });
}

/** Multiplies all lengths of the sequence by a factor. */
void
scaleAll(const TemporaryFolder& folder, float factor)
{
  for (const char* file : {first, second})
    changePlaces(
        folder.path(file), [&](Eigen::Vector3f& place) { place *= factor; }, factor);
  Trajectory trajectory = loadTrajectory(folder.path(poses));
  for (Eigen::Isometry3d& pose : trajectory.poses)
    pose.translation() *= factor;
  saveTrajectory(folder.path(poses), trajectory);
}

void
addFolders(CaseList& list, const CommandFor& command)
{
  const std::string none = "none";
  list.addRun(Ugliness::Missing, "no such folder", none, command(none));
  list.addRun(
      Ugliness::Empty, "an empty folder", none, command(none), [](const auto& folder) {
        fs::create_directory(folder.path("none"));
      });
  list.addRun(Ugliness::Device, "`/dev/null`", "/dev/null", command("/dev/null"));
  list.addRun(Ugliness::Folder,
              "a file for the folder",
              none,
              command(none),
              [](const auto& folder) { folder.write("none", "x"); });
}

} // namespace

std::vector<UglyCase>
sequenceCases(const CommandFor& command,
              const std::map<std::string, UglyOutcome>& outcomes,
              const CaseList::Prepare& others)
{
  const auto good = [others](const TemporaryFolder& folder) {
    others(folder);
    give(folder, hallObservations(), "obs");
  };
  CaseList list(good, command("obs"), outcomes);
  addFolders(list, command);
  list.addFile(second);
  list.addFile(poses);
  list.add(Ugliness::NanOnly, nan_observation, second, [](const auto& folder) {
    keepPoints(folder.path(second), 0);
  });
  list.add(Ugliness::NanOnly, nan_observations, "obs", [](const auto& folder) {
    keepPoints(folder.path(first), 0);
    keepPoints(folder.path(second), 0);
  });
  list.add(Ugliness::NanOnly, "a pose without a number", poses, [](const auto& folder) {
    folder.write(poses, "0 0 0 0 0 0 0 1\n1 nan 0 0 0 0 0 1\n");
  });
  list.add(Ugliness::OnePoint, one_pixel, second, [](const auto& folder) {
    keepPoints(folder.path(second), 1);
  });
  list.add(Ugliness::Doubled, doubled_observation, second, [](const auto& folder) {
    fs::copy(
        folder.path(first), folder.path(second), fs::copy_options::overwrite_existing);
    folder.write(poses, "0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n");
  });
  list.add(Ugliness::WrongFields, no_z, second, [](const auto& folder) {
    replaceIn(folder.path(second), "FIELDS x y z", "FIELDS x y w");
  });
  list.add(Ugliness::Huge, vast_observations, "obs", [](const auto& folder) {
    scaleAll(folder, 1e30F);
  });
  list.add(Ugliness::Millimetres,
           millimetre_observations,
           "obs",
           [](const auto& folder) { scaleAll(folder, 1000); });
  list.addRun(Ugliness::Names,
              odd_folder,
              odd_folder,
              command(odd_folder),
              [](const auto& folder) { give(folder, folder.path("obs"), odd_folder); });
  return list.cases();
}

} // namespace pcl::acmap::test
