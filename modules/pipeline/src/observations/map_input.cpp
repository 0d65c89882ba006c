#include <pcl/core/exceptions.h>
#include <pcl/core/impl/file_ending.h>
#include <pcl/core/impl/pcd_viewpoint.h>
#include <pcl/core/scan_file.h>
#include <pcl/pipeline/input_kind.h>
#include <pcl/pipeline/map_input.h>
#include <pcl/pipeline/observation_source.h>

#include <filesystem>
#include <utility>

namespace pcl {

namespace {

namespace fs = std::filesystem;

/** \brief Number of scans of an E57 or PTX file; 0 if that cannot be told. */
std::size_t
scansIn(const std::string& path)
{
  try {
    return ScanFile::count(path);
  }
  catch (const InputFileException&) {
    return 0; // the fault is told when the file is read as one cloud
  }
}

ObservationSequence
openStatedRgbd(const std::string& path, const InputStatement& stated)
{
  RgbdSequence recorded = openRgbdSequence(path, settingsOf(stated.rgbd));
  const RgbdCameras cameras = camerasOf(stated.rgbd, recorded);
  recorded.remarks = rgbdRemarks(stated.rgbd, recorded, cameras);
  std::vector<RgbdFrame> thinned;
  for (std::size_t i = 0; i < recorded.frames.size(); i += stated.bag.every)
    thinned.push_back(recorded.frames[i]);
  recorded.frames = std::move(thinned);
  return {recorded, cameras};
}

/** \brief The observations of what is no folder of PCDs; none for other inputs. */
std::optional<ObservationSequence>
openRecorded(const std::string& path, const InputStatement& stated)
{
  const InputKind kind = inputKindOf(path);
  if (kind == InputKind::RgbdFolder)
    return openStatedRgbd(path, stated);
  if (kind == InputKind::Bag)
    return ObservationSequence(openBag(path, stated.bag));
  const std::string ending = acmap::endingOf(path);
  if ((ending == ".e57" || ending == ".ptx") && scansIn(path) > 1) {
    std::optional<Eigen::Vector3d> shift = stated.reader.getShift();
    if (shift)
      *shift /=
          stated.reader.getScale(); // that of the scans is in the unit of the file
    return ObservationSequence(openScans(path, shift));
  }
  return {};
}

/** \brief Has a folder poses, by its trajectory or by the headers of its PCDs? */
bool
hasPoses(const ObservationSequence& sequence, bool skip_broken)
{
  if (sequence.hasTrajectory())
    return true;
  std::optional<Eigen::Matrix4d> first;
  std::size_t readable = 0;
  for (const std::string& path : sequence.paths()) {
    if (acmap::endingOf(path) != ".pcd")
      return false; // other formats have no VIEWPOINT
    try {
      const Eigen::Matrix4d pose = acmap::loadPcdViewpoint(path).matrix();
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
openMapInput(const std::string& path, const InputStatement& stated)
{
  MapInput input;
  std::error_code error;
  input.observations = openRecorded(path, stated);
  bool is_posed = input.observations && input.observations->hasTrajectory();
  if (!input.observations) {
    if (!fs::is_directory(path, error))
      return input;
    if (inputKindOf(path) == InputKind::RawSession) {
      input.start = StartingPoint::Session;
      return input;
    }
    input.observations.emplace(
        path, stated.reader.getScale(), stated.reader.getShift());
    is_posed = hasPoses(*input.observations, stated.skip_broken);
  }
  input.start =
      is_posed ? StartingPoint::PosedObservations : StartingPoint::Observations;
  return input;
}

} // namespace pcl
