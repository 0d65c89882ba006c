#include "grab_outputs.h"

#include <filesystem>

namespace pcl::acmap {

namespace fs = std::filesystem;

GrabOutputs::GrabOutputs(Tool& tool,
                         const GrabberOptions& options,
                         const Device& device,
                         SeeCloud see)
: tool_(tool)
, options_(options)
, see_(std::move(see))
{
  checkPlaces();
  if (!options.clouds.empty() || (options.live && !options.isStream()))
    clouds_.emplace(tool, options, device);
  if (!options.session.empty())
    session_.emplace(options.session, device);
}

void
GrabOutputs::checkPlaces() const
{
  const auto same = [](const std::string& a, const std::string& b) {
    std::error_code error;
    return !a.empty() && !b.empty() &&
           fs::weakly_canonical(fs::absolute(a) / "", error) ==
               fs::weakly_canonical(fs::absolute(b) / "", error);
  };
  if (same(options_.clouds, options_.session))
    throw UsageError(options_.clouds + ": is to hold the session, too");
  if (options_.isRecording())
    for (const std::string& output : {options_.clouds, options_.session})
      if (same(output, options_.device))
        throw UsageError(output + ": is the recording's folder, too");
  tool_.requireReportWritable({options_.rigPath()});
}

void
GrabOutputs::take(const TrinocularFrame::ConstPtr& frame,
                  const ProgressCallback& progress)
{
  if (!open_.empty() && open_.front()->observation != frame->observation)
    close(progress);
  open_.push_back(frame);
}

std::optional<std::size_t>
GrabOutputs::openObservation() const
{
  if (open_.empty())
    return std::nullopt;
  return static_cast<std::size_t>(open_.front()->observation);
}

void
GrabOutputs::close(const ProgressCallback& progress)
{
  if (open_.empty())
    return;
  const std::vector<TrinocularFrame::ConstPtr> frames = std::move(open_);
  open_.clear();
  Report steps;
  StepTimer timer(steps);
  if (session_)
    for (const TrinocularFrame::ConstPtr& frame : frames)
      session_->recorder().record(*frame);
  timer.finish("record");
  if (clouds_) {
    ObservationShots shots;
    for (const TrinocularFrame::ConstPtr& frame : frames)
      groups_.add(frame, shots);
    if (!shots.frames.empty()) {
      groups_.close(shots);
      const auto cloud = clouds_->make(shots, progress);
      if (see_)
        see_(cloud);
    }
    timer.finish("match");
  }
  for (const auto& [step, seconds] : steps.seconds)
    seconds_[step] += seconds;
  ++observations_;
}

std::optional<std::uintmax_t>
GrabOutputs::written() const
{
  if (!session_)
    return std::nullopt;
  return session_->recorder().bytes();
}

std::optional<std::uintmax_t>
GrabOutputs::free() const
{
  const std::string& place = session_ ? options_.session : options_.clouds;
  std::error_code error;
  const fs::space_info space = fs::space(place, error);
  if (place.empty() || error)
    return std::nullopt;
  return space.available;
}

void
GrabOutputs::finish()
{
  if (session_)
    session_->recorder().finish();
  if (!clouds_)
    return;
  if (clouds_->results().points() == 0) {
    clouds_->results().warnOfRemarks(tool_);
    tool_.failWithNothing("no pixel has a place: " + clouds_->results().rejected());
  }
  clouds_->commit();
}

std::string
GrabOutputs::keepClouds()
{
  if (options_.clouds.empty() || !clouds_ || clouds_->results().points() == 0)
    return "";
  clouds_->commit();
  return "; observations finished by then, in " + options_.clouds + ": " +
         std::to_string(clouds_->results().observations());
}

std::string
GrabOutputs::keepSession()
{
  if (!session_ || session_->recorder().frames() == 0)
    return "";
  try {
    session_->recorder().finish();
  }
  catch (const OutputFileException&) {
    // frames can be read without it, and the earlier error is reported
  }
  return "; frames recorded by then, in " + options_.session + ": " +
         std::to_string(session_->recorder().frames());
}

void
GrabOutputs::keep(const std::exception_ptr& error)
{
  const std::string kept = keepClouds() + keepSession();
  if (kept.empty())
    std::rethrow_exception(error);
  const Failure failure = failureOf(error);
  switch (failure.code) {
  case exit_interrupted:
    throw InterruptedPartway("interrupted" + kept);
  case exit_output:
    throw OutputFileException(failure.line + kept);
  case exit_input:
    throw InputFileException(failure.line + kept);
  case exit_nothing_found:
    throw NothingFound(failure.line + kept);
  case exit_memory:
    throw MemoryRefused(failure.line + kept);
  default:
    throw std::runtime_error(failure.line + kept);
  }
}

void
GrabOutputs::tell() const
{
  for (const std::string& remark : groups_.remarks())
    tool_.warn(remark);
  tool_.tell("observations", std::to_string(observations_));
  if (clouds_)
    clouds_->tell(tool_);
  for (const auto& [step, seconds] : seconds_)
    tool_.report().seconds.emplace_back(step, seconds);
  nlohmann::ordered_json& details = tool_.details();
  details["clouds"] = options_.clouds;
  details["session"] = options_.session;
  if (session_) {
    details["recorded_frames"] = session_->recorder().frames();
    details["recorded_bytes"] = session_->recorder().bytes();
  }
}

} // namespace pcl::acmap
