#include "starting_point.h"

#include "input_kind.h"

#include <pcl/core/exceptions.h>

#include <filesystem>
#include <optional>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

bool
hasPoses(const ObservationSequence& sequence, bool skip_broken)
{
  if (sequence.hasTrajectory())
    return true;
  std::optional<Eigen::Matrix4d> first;
  std::size_t readable = 0;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    try {
      const Eigen::Matrix4d pose = sequence.load(i).T_map_camera.matrix();
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

StartingPoint
startingPointOf(const std::string& input,
                bool skip_broken,
                const std::optional<ObservationSequence>& recorded)
{
  const auto observations = [](bool has_poses) {
    return has_poses ? StartingPoint::PosedObservations : StartingPoint::Observations;
  };
  if (recorded)
    return observations(recorded->hasTrajectory());
  std::error_code error;
  if (!fs::is_directory(input, error))
    return StartingPoint::Cloud;
  if (inputKindOf(input) == InputKind::RawSession)
    return StartingPoint::Session;
  return observations(hasPoses(ObservationSequence(input), skip_broken));
}

} // namespace pcl::acmap
