#include "chain/stage_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/pipeline/fingerprint.h>
#include <pcl/pipeline/stage_store.h>

#include <Eigen/Geometry>

#include <filesystem>
#include <limits>
#include <locale>
#include <sstream>
#include <utility>

namespace pcl::acmap {

namespace fs = std::filesystem;

namespace {

Trajectory
asInFiles(Trajectory trajectory)
{
  for (Eigen::Isometry3d& pose : trajectory.poses)
    pose = acmap::asInFiles(pose);
  return trajectory;
}

} // namespace

void
StageKey::add(const std::string& name, double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  text << value;
  add(name, text.str());
}

std::string
StageKey::fingerprint() const
{
  Fingerprint hash;
  for (const auto& [name, value] : entries_) {
    hash.add(name);
    hash.add(value);
  }
  return hash.text();
}

OpenStage::OpenStage() = default;

OpenStage::OpenStage(std::unique_ptr<StageFolder> folder)
: folder_(std::move(folder))
{}

OpenStage::OpenStage(OpenStage&&) noexcept = default;

OpenStage&
OpenStage::operator=(OpenStage&& other) noexcept
{
  folder_.swap(other.folder_);
  results_.swap(other.results_);
  std::swap(has_ended_, other.has_ended_);
  return *this;
}

OpenStage::~OpenStage()
{
  if (folder_ && !has_ended_)
    folder_->abandon();
}

std::string
OpenStage::path(const std::string& name) const
{
  return folder_ ? (fs::path(folder_->path()) / name).string() : std::string();
}

EstimatedPoses
OpenStage::put(const EstimatedPoses& poses)
{
  if (folder_)
    saveEstimatedPoses(folder_->path(), poses);
  EstimatedPoses kept = poses;
  kept.trajectory = asInFiles(std::move(kept.trajectory));
  return kept;
}

Trajectory
OpenStage::put(const std::string& name, const Trajectory& trajectory)
{
  if (folder_)
    saveTrajectory(path(name), trajectory);
  return asInFiles(trajectory);
}

std::vector<std::string>
OpenStage::finish(const StageNotes& notes)
{
  std::vector<std::string> removed;
  if (folder_)
    removed = folder_->finish(notes, results_);
  has_ended_ = true;
  return removed;
}

std::string
StageStore::path(const std::string& stage, const std::string& name) const
{
  return isFolder() ? (fs::path(folder_) / stage / name).string() : std::string();
}

std::optional<StageNotes>
StageStore::find(const std::string& stage,
                 const StageKey& key,
                 const std::string& result_folder) const
{
  if (!isFolder())
    return std::nullopt;
  return StageFolder((fs::path(folder_) / stage).string(), key, result_folder)
      .finished();
}

OpenStage
StageStore::begin(const std::string& stage,
                  const StageKey& key,
                  const std::string& result_folder) const
{
  if (!isFolder())
    return OpenStage();
  auto folder = std::make_unique<StageFolder>(
      (fs::path(folder_) / stage).string(), key, result_folder);
  folder->begin();
  return OpenStage(std::move(folder));
}

EstimatedPoses
StageStore::poses(const std::string& stage) const
{
  const std::string folder = path(stage);
  std::optional<EstimatedPoses> poses = loadEstimatedPoses(folder);
  if (!poses)
    throw InputFileException(folder + ": has no poses");
  return std::move(*poses);
}

Eigen::Isometry3d
asInFiles(Eigen::Isometry3d pose)
{
  Eigen::Quaterniond written(pose.linear());
  written.normalize();
  if (written.w() < 0)
    written.coeffs() = -written.coeffs();
  pose.linear() = written.normalized().toRotationMatrix();
  return pose;
}

} // namespace pcl::acmap
