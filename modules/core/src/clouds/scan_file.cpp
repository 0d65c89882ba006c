#include <pcl/core/scan_file.h>

#include "clouds/e57_cloud.h"
#include "files/byte_source.h"
#include "files/text_number.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

namespace {

/** \brief From the axes of a scanner, z up, to those of a camera that looks along x. */
Eigen::Isometry3d
cameraOfScanner()
{
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  return turn;
}

std::unique_ptr<ScanReader>
readerOf(ByteSource& source, bool verifies)
{
  return lowerEnding(source.name()) == ".ptx" ? readerOfPtx(source)
                                              : readerOfE57(source, verifies);
}

} // namespace
} // namespace pcl::acmap

namespace pcl {

struct ScanFile::Content {
  std::string path;
  std::vector<acmap::E57Scan> scans;
  std::vector<Eigen::Isometry3d> T_camera_scan; ///< camera: the frame of an observation
  std::vector<Eigen::Isometry3d> poses;
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  std::vector<std::string> remarks;
};

ScanFile::ScanFile(const std::string& path, const std::optional<Eigen::Vector3d>& shift)
{
  acmap::ByteSource source(path);
  const auto reader = acmap::readerOf(source, true);
  auto content = std::make_shared<Content>();
  content->path = path;
  content->scans = reader->scans();
  for (const acmap::E57Scan& scan : content->scans)
    if (content->shift.isZero(0))
      content->shift =
          acmap::shiftOf(scan, scan.T_map_scan, {1, shift, {}, false}, *reader);
  for (const acmap::E57Scan& scan : content->scans) {
    if (!scan.remark.empty())
      content->remarks.push_back(scan.remark);
    const Eigen::Isometry3d T_camera_scan =
        acmap::cameraOfScanner() *
        Eigen::Translation3d(
            -acmap::shiftOf(scan, Eigen::Isometry3d::Identity(), {}, *reader));
    content->T_camera_scan.push_back(T_camera_scan);
    content->poses.push_back(Eigen::Translation3d(-content->shift) * scan.T_map_scan *
                             T_camera_scan.inverse());
  }
  content_ = std::move(content);
}

std::size_t
ScanFile::count(const std::string& path)
{
  acmap::ByteSource source(path);
  return acmap::readerOf(source, false)->scans().size();
}

std::size_t
ScanFile::size() const
{
  return content_->scans.size();
}

const Eigen::Vector3d&
ScanFile::shift() const
{
  return content_->shift;
}

const std::vector<std::string>&
ScanFile::remarks() const
{
  return content_->remarks;
}

const Eigen::Isometry3d&
ScanFile::pose(std::size_t i) const
{
  return content_->poses.at(i);
}

PointCloudFile
ScanFile::load(std::size_t i) const
{
  acmap::ByteSource source(content_->path);
  const auto reader = acmap::readerOf(source, false);
  PointCloudFile file;
  acmap::CoordinateCheck check(true);
  acmap::readScans({content_->scans.at(i)},
                   {content_->T_camera_scan[i]},
                   Eigen::Vector3d::Zero(),
                   *reader,
                   nullptr,
                   file.cloud,
                   check);
  check.finish(file);
  const Eigen::Isometry3d& pose = content_->poses[i];
  file.sensor_origin = pose.translation().cast<float>();
  file.sensor_orientation =
      Eigen::Quaterniond(pose.linear()).cast<float>().normalized();
  return file;
}

} // namespace pcl
