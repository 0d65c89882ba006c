#include "session/disk_sync.h"
#include "session/fault_text.h"
#include "session/session_folder.h"

#include <pcl/acquisition/frame_file.h>
#include <pcl/acquisition/trinocular_recorder.h>

#include <filesystem>
#include <set>
#include <utility>

namespace pcl {

struct TrinocularRecorder::State {
  std::string folder;
  TrinocularRig rig;
  std::set<std::uint64_t> numbers;
  std::set<std::pair<std::int32_t, std::int32_t>> shots; ///< observation, pattern
  std::array<bool, 3> cameras{};
  bool is_finished = false;
};

namespace {

/** \return whether there was none */
bool
makeFolder(const std::string& folder)
{
  std::error_code error;
  const bool is_new = std::filesystem::create_directory(folder, error);
  if (!error && !std::filesystem::is_directory(folder, error))
    error = std::make_error_code(std::errc::not_a_directory);
  if (error)
    throw OutputFileException(folder + ": " + error.message());
  return is_new;
}

/** A folder that cannot be listed is none to write into. */
bool
holdsSession(const std::string& folder)
{
  try {
    return acmap::holdsSession(folder);
  }
  catch (const InputFileException& exception) {
    throw OutputFileException(acmap::faultText(exception.what()));
  }
}

/** Makes the folder and its `rig.yaml`; where that fails, no new folder stays behind. */
template <typename SaveRig>
void
beginSession(const std::string& folder, const SaveRig& save_rig)
{
  const bool is_new = makeFolder(folder);
  if (holdsSession(folder))
    throw OutputFileException(folder +
                              ": holds a session already, none is overwritten");
  const std::string rig = acmap::pathIn(folder, acmap::SessionSummary().rig);
  try {
    save_rig(rig);
    acmap::syncToDisk(rig);
    if (is_new) // the folder's name in the one around it
      acmap::syncToDisk(acmap::pathIn(folder, ".."));
  }
  catch (...) {
    std::error_code error;
    std::filesystem::remove(rig, error);
    if (is_new)
      std::filesystem::remove(folder, error);
    throw;
  }
}

/** Writes a frame onto the disk, or not at all. */
void
saveFrame(const std::string& path, const TrinocularFrame& frame)
{
  saveTrinocularFrame(path, frame);
  try {
    acmap::syncToDisk(path);
  }
  catch (const OutputFileException&) {
    std::error_code error;
    std::filesystem::remove(path, error);
    throw;
  }
}

std::string
shotText(const TrinocularFrame& frame)
{
  return "observation " + std::to_string(frame.observation) + " under pattern " +
         std::to_string(frame.pattern);
}

} // namespace

TrinocularRecorder::TrinocularRecorder(const std::string& folder,
                                       const TrinocularRig& rig)
: state_(new State{folder, rig, {}, {}, {}, false})
{
  beginSession(folder, [&](const std::string& path) { saveTrinocularRig(path, rig); });
}

TrinocularRecorder::TrinocularRecorder(const std::string& folder,
                                       const TrinocularRig& rig,
                                       const RigCalibration& calibration)
: state_(new State{folder, rig, {}, {}, {}, false})
{
  beginSession(folder, [&](const std::string& path) {
    saveRigCalibration(path, rig, calibration);
  });
}

TrinocularRecorder::~TrinocularRecorder() = default;

void
TrinocularRecorder::record(const TrinocularFrame& frame)
{
  const acmap::FrameHeader header = acmap::headerOf(frame);
  const std::pair shot{frame.observation, frame.pattern};
  std::string fault = state_->is_finished ? "the session is finished" : "";
  if (fault.empty())
    fault = acmap::faultUnderRig(header, state_->rig);
  if (fault.empty() && state_->numbers.count(frame.number) > 0)
    fault = "a frame of this number was recorded before";
  if (fault.empty() && state_->shots.count(shot) > 0)
    fault = shotText(frame) + " was recorded before";
  if (!fault.empty())
    throw BadArgumentException("frame " + std::to_string(frame.number) + ": " + fault);
  saveFrame(acmap::pathIn(state_->folder, acmap::frameFileName(frame.number)), frame);
  state_->numbers.insert(frame.number);
  state_->shots.insert(shot);
  for (std::size_t camera = 0; camera < header.images.size(); ++camera)
    state_->cameras[camera] |= header.images[camera].width > 0;
}

void
TrinocularRecorder::finish()
{
  if (state_->is_finished)
    return;
  std::set<std::int32_t> observations;
  std::set<std::int32_t> patterns;
  for (const auto& [observation, pattern] : state_->shots) {
    observations.insert(observation);
    if (pattern != TrinocularFrame::no_pattern)
      patterns.insert(pattern);
  }
  acmap::SessionSummary summary;
  summary.frames = state_->numbers.size();
  summary.observations = observations.size();
  summary.patterns = patterns.size();
  summary.cameras = state_->cameras;
  acmap::saveSessionSummary(state_->folder, summary);
  state_->is_finished = true;
}

std::size_t
TrinocularRecorder::frames() const
{
  return state_->numbers.size();
}

} // namespace pcl
