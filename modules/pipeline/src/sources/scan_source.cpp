#include <pcl/core/scan_file.h>
#include <pcl/pipeline/observation_source.h>
#include <pcl/pipeline/stage_store.h>

namespace pcl {

namespace {

class ScanSource : public ObservationSource {
public:
  ScanSource(const std::string& path, const std::optional<Eigen::Vector3d>& shift)
  : path_(path)
  , scans_(path, shift)
  {}

  std::string
  name() const override
  {
    return path_;
  }

  std::string
  fingerprint() const override
  {
    return acmap::stateOfFile(path_);
  }

  std::size_t
  size() const override
  {
    return scans_.size();
  }

  Trajectory
  trajectory() const override
  {
    Trajectory trajectory;
    for (std::size_t i = 0; i < scans_.size(); ++i) {
      trajectory.stamps.push_back(static_cast<double>(i));
      trajectory.poses.push_back(scans_.pose(i));
    }
    return trajectory;
  }

  PointCloudFile
  load(std::size_t i) const override
  {
    return scans_.load(i);
  }

  Eigen::Vector3d
  shift() const override
  {
    return scans_.shift();
  }

  std::vector<std::string>
  remarks() const override
  {
    return scans_.remarks();
  }

private:
  std::string path_;
  ScanFile scans_;
};

} // namespace

std::shared_ptr<const ObservationSource>
openScans(const std::string& path, const std::optional<Eigen::Vector3d>& shift)
{
  return std::make_shared<ScanSource>(path, shift);
}

} // namespace pcl
