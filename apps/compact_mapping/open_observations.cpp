#include "open_observations.h"

#include "output_target.h"
#include "tool.h"

#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/pcd_viewpoint.h>
#include <pcl/core/output_folder.h>
#include <pcl/core/scan_file.h>
#include <pcl/pipeline/input_kind.h>
#include <pcl/pipeline/observation_source.h>
#include <pcl/pipeline/observation_writing.h>

#include <filesystem>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

/** \brief Number of scans of an E57 or PTX file; 0 if that cannot be told. */
std::size_t
scansOf(const std::string& path)
{
  try {
    return ScanFile::count(path);
  }
  catch (const InputFileException&) {
    return 0; // the fault is told when the file is read as one cloud
  }
}

ObservationSequence
openRgbd(const std::string& path, std::size_t every, const RgbdOptions& options)
{
  RgbdSequence recorded = openRgbdSequence(path, settingsOf(options));
  const RgbdCameras cameras = camerasOf(options, recorded);
  recorded.remarks = rgbdRemarks(options, recorded, cameras);
  std::vector<RgbdFrame> thinned;
  for (std::size_t i = 0; i < recorded.frames.size(); i += every)
    thinned.push_back(recorded.frames[i]);
  recorded.frames = std::move(thinned);
  return {recorded, cameras};
}

std::optional<ObservationSequence>
openRecording(const std::string& path,
              const BagSettings& bag,
              const RgbdOptions& rgbd,
              const PointCloudReader& reader)
{
  if (inputKindOf(path) == InputKind::RgbdFolder)
    return openRgbd(path, bag.every, rgbd);
  if (inputKindOf(path) == InputKind::Bag)
    return ObservationSequence(openBag(path, bag));
  const std::string ending = endingOf(path);
  if ((ending == ".e57" || ending == ".ptx") && scansOf(path) > 1) {
    std::optional<Eigen::Vector3d> shift = reader.getShift();
    if (shift)
      *shift /= reader.getScale(); // that of the scans is in the unit of the file
    return ObservationSequence(openScans(path, shift));
  }
  return {};
}

bool
hasPoses(const ObservationSequence& sequence, bool skip_broken)
{
  if (sequence.hasTrajectory())
    return true;
  std::optional<Eigen::Matrix4d> first;
  std::size_t readable = 0;
  for (const std::string& path : sequence.paths()) {
    if (endingOf(path) != ".pcd")
      return false; // other formats have no VIEWPOINT
    try {
      const Eigen::Matrix4d pose = loadPcdViewpoint(path).matrix();
      ++readable;
      if (first && pose != *first)
        return true;
      first = pose;
    }
    catch (const InputFileException&) {
      if (!skip_broken)
        throw;
    }
  }
  return readable < 2; // a single pose cannot differ from others
}

} // namespace

const char*
nameOf(StartingPoint start)
{
  switch (start) {
  case StartingPoint::Session:
    return "raw session";
  case StartingPoint::Observations:
    return "observations";
  case StartingPoint::PosedObservations:
    return "posed observations";
  default:
    return "cloud";
  }
}

MapInput
openObservations(const std::string& path,
                 const BagSettings& bag,
                 bool skip_broken,
                 const RgbdOptions& rgbd,
                 const PointCloudReader& reader)
{
  const auto observations = [](bool has_poses) {
    return has_poses ? StartingPoint::PosedObservations : StartingPoint::Observations;
  };
  if (auto recorded = openRecording(path, bag, rgbd, reader)) {
    const StartingPoint start = observations(recorded->hasTrajectory());
    return {start, std::move(recorded)};
  }
  std::error_code error;
  if (!fs::is_directory(path, error))
    return {StartingPoint::Cloud, {}};
  if (inputKindOf(path) == InputKind::RawSession)
    return {StartingPoint::Session, {}};
  return {observations(hasPoses(ObservationSequence(path), skip_broken)), {}};
}

void
importRecording(const std::string& path,
                const ObservationSequence& sequence,
                const std::string& folder,
                const RunControls& controls,
                StageLog& log)
{
  StepTimer timer(log.report);
  OutputFolder output(folder);
  std::size_t points = 0;
  const auto count = [&](const ObservationToWrite& written) {
    points += rowsOf(*written.cloud);
  };
  writeObservations(output, sequence, {controls.progress, "reading " + path, count});
  stopIfInterrupted();
  output.commit();
  timer.finish("import");
  log.warn(sequence.remarks());
  const Eigen::Vector3d& shift = sequence.shift();
  log.details = {{"input", path},
                 {"observations", sequence.size()},
                 {"points", points},
                 {"shift", {shift.x(), shift.y(), shift.z()}}};
  log.tell("observations", std::to_string(sequence.size()));
  log.tell("points", std::to_string(points));
}

} // namespace pcl::acmap
