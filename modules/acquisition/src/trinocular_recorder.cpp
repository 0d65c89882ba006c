#include "session/fault_text.h"
#include "session/session_folder.h"
#include "session/waiting_frames.h"

#include <pcl/acquisition/frame_file.h>
#include <pcl/acquisition/trinocular_recorder.h>
#include <pcl/core/exceptions.h>

#include <filesystem>
#include <mutex>
#include <set>
#include <utility>

namespace pcl {

namespace {

/** \return true if the folder was created */
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

/** Reports a folder that cannot be listed as an output error. */
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

/** Creates the folder and its `rig.yaml`; on failure, a new folder is removed again.
 * \return true if the folder was created */
template <typename SaveRig>
bool
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
    if (is_new) // its entry in the parent folder
      acmap::syncToDisk(acmap::pathIn(folder, ".."));
  }
  catch (...) {
    std::error_code error;
    std::filesystem::remove(rig, error);
    if (is_new)
      std::filesystem::remove(folder, error);
    throw;
  }
  return is_new;
}

/** Writes a frame to the disk; on failure, no file remains. */
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

struct TrinocularRecorder::State {
  State(const std::string& session_folder, const TrinocularRig& session_rig)
  : folder(session_folder)
  , rig(session_rig)
  , waiting([this](const TrinocularFrame& frame) { write(frame); })
  {}

  void
  take(const TrinocularFrame& frame);

  void
  forget(const TrinocularFrame& frame);

  void
  write(const TrinocularFrame& frame);

  const std::string folder;
  const TrinocularRig rig;
  bool is_finished = false;
  bool is_new_folder = false;
  std::size_t max_waiting = 0;

  std::mutex mutex; // protects the members below, except for the last one
  std::set<std::uint64_t> numbers;
  std::set<std::pair<std::int32_t, std::int32_t>> shots; ///< observation, pattern
  std::array<bool, 3> cameras{};
  std::size_t frames = 0; ///< number of frames that were written
  std::uintmax_t bytes = 0;

  acmap::WaitingFrames waiting;
};

/** Checks that a frame is valid and not a duplicate, and registers it. */
void
TrinocularRecorder::State::take(const TrinocularFrame& frame)
{
  const std::pair shot{frame.observation, frame.pattern};
  std::string fault = is_finished ? "the session is finished" : "";
  if (fault.empty())
    fault = acmap::faultUnderRig(acmap::headerOf(frame), rig);
  const std::lock_guard lock(mutex);
  if (fault.empty() && numbers.count(frame.number) > 0)
    fault = "a frame of this number was recorded before";
  if (fault.empty() && shots.count(shot) > 0)
    fault = shotText(frame) + " was recorded before";
  if (!fault.empty())
    throw acmap::BadArgument("frame " + std::to_string(frame.number) + ": " + fault);
  numbers.insert(frame.number);
  shots.insert(shot);
}

/** Removes the registration of a frame that was not written. */
void
TrinocularRecorder::State::forget(const TrinocularFrame& frame)
{
  const std::lock_guard lock(mutex);
  numbers.erase(frame.number);
  shots.erase({frame.observation, frame.pattern});
}

/** Writes a registered frame. */
void
TrinocularRecorder::State::write(const TrinocularFrame& frame)
{
  const std::string path = acmap::pathIn(folder, acmap::frameFileName(frame.number));
  try {
    saveFrame(path, frame);
  }
  catch (...) {
    forget(frame);
    throw;
  }
  std::error_code error; // the file may already have been moved away
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  const std::lock_guard lock(mutex);
  ++frames;
  bytes += error ? 0 : size;
  for (std::size_t camera = 0; camera < cameras.size(); ++camera)
    cameras[camera] |= frame.images[camera].width > 0;
}

TrinocularRecorder::TrinocularRecorder(const std::string& folder,
                                       const TrinocularRig& rig)
: TrinocularRecorder(folder, rig, std::optional<RigCalibration>())
{}

TrinocularRecorder::TrinocularRecorder(const std::string& folder,
                                       const TrinocularRig& rig,
                                       const RigCalibration& calibration)
: TrinocularRecorder(folder, rig, std::optional<RigCalibration>(calibration))
{}

TrinocularRecorder::TrinocularRecorder(const std::string& folder,
                                       const TrinocularRig& rig,
                                       const std::optional<RigCalibration>& cameras)
: state_(new State(folder, rig))
{
  state_->is_new_folder = beginSession(folder, [&](const std::string& path) {
    if (cameras)
      saveRigCalibration(path, rig, *cameras);
    else
      saveTrinocularRig(path, rig);
  });
}

TrinocularRecorder::~TrinocularRecorder() = default;

void
TrinocularRecorder::setMostWaiting(std::size_t frames)
{
  constexpr std::size_t maximum = 1000;
  if (frames > maximum)
    throw acmap::BadArgument("maximum waiting: " + std::to_string(frames) +
                             " frames; legal is [0, " + std::to_string(maximum) + ']');
  state_->max_waiting = frames;
}

std::size_t
TrinocularRecorder::getMostWaiting() const
{
  return state_->max_waiting;
}

void
TrinocularRecorder::record(const TrinocularFrame& frame)
{
  state_->waiting.throwFault();
  state_->take(frame);
  if (state_->max_waiting == 0) {
    state_->waiting.waitForAll();
    state_->write(frame);
    return;
  }
  try {
    state_->waiting.add(frame, state_->max_waiting);
  }
  catch (...) { // out of memory, or no thread
    state_->forget(frame);
    throw;
  }
}

void
TrinocularRecorder::finish()
{
  if (state_->is_finished)
    return;
  state_->waiting.waitForAll();
  state_->waiting.throwFault();
  const std::lock_guard lock(state_->mutex);
  std::set<std::int32_t> observations;
  std::set<std::int32_t> patterns;
  for (const auto& [observation, pattern] : state_->shots) {
    observations.insert(observation);
    if (pattern != TrinocularFrame::no_pattern)
      patterns.insert(pattern);
  }
  acmap::SessionSummary summary;
  summary.frames = state_->frames;
  summary.observations = observations.size();
  summary.patterns = patterns.size();
  summary.cameras = state_->cameras;
  acmap::saveSessionSummary(state_->folder, summary);
  state_->is_finished = true;
}

void
TrinocularRecorder::discardIfEmpty()
{
  state_->waiting.waitForAll();
  if (frames() > 0)
    return;
  state_->is_finished = true;
  acmap::removeSessionFiles(state_->folder);
  std::error_code error;
  if (state_->is_new_folder)
    std::filesystem::remove(state_->folder, error);
}

std::size_t
TrinocularRecorder::frames() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->frames;
}

std::uintmax_t
TrinocularRecorder::bytes() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->bytes;
}

} // namespace pcl
