#include "known_poses.h"

#include <pcl/pipeline/observation_files.h>

namespace pcl::acmap {

KnownPoses::KnownPoses(const std::string& path, const ShotSource& source)
: path_(path)
{
  if (path.empty())
    return;
  trajectory_ = loadTrajectory(path);
  of(source.lastObservation());
}

Eigen::Isometry3d
KnownPoses::of(std::size_t observation) const
{
  if (path_.empty())
    return Eigen::Isometry3d::Identity();
  if (observation >= trajectory_.poses.size())
    throw InputFileException(path_ + ": has " +
                             std::to_string(trajectory_.poses.size()) +
                             " poses, none for observation " +
                             std::to_string(observation) + " (counted from 0)");
  return trajectory_.poses[observation];
}

void
KnownPoses::save(const OutputFolder& folder) const
{
  if (!path_.empty())
    saveTrajectory(folder.path(trajectory_name), trajectory_);
}

} // namespace pcl::acmap
