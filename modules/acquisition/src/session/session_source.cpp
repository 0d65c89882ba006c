#include "fault_text.h"
#include "frame_source.h"
#include "session_folder.h"

#include <pcl/acquisition/frame_file.h>

#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace pcl::acmap {

namespace {

class SessionSource : public FrameSource {
public:
  SessionSource(std::string folder,
                const TrinocularRig& rig,
                std::vector<std::uint64_t> numbers)
  : folder_(std::move(folder))
  , rig_(rig)
  , numbers_(std::move(numbers))
  , observations_(numbers_.size())
  {}

  std::size_t
  size() const override
  {
    return numbers_.size();
  }

  std::uint64_t
  number(std::size_t index) const override
  {
    return numbers_[index];
  }

  std::optional<std::int32_t>
  observation(std::size_t index) const override
  {
    return observations_[index];
  }

  std::string
  folder() const override
  {
    return folder_;
  }

  TrinocularFrame
  read(std::size_t index) const override
  {
    TrinocularFrame frame = loadTrinocularFrame(path(index));
    requireFitting(index, headerOf(frame));
    return frame;
  }

  const TrinocularRig&
  rig() const override
  {
    return rig_;
  }

  /** Takes the observation of a frame, too. */
  FrameHeader
  readHeader(std::size_t index)
  {
    const FrameHeader header = loadFrameHeader(path(index));
    requireFitting(index, header);
    observations_[index] = header.observation;
    return header;
  }

private:
  std::string
  path(std::size_t index) const
  {
    return pathIn(folder_, frameFileName(numbers_[index]));
  }

  void
  requireFitting(std::size_t index, const FrameHeader& header) const
  {
    std::string fault = faultUnderRig(header, rig_);
    if (header.number != numbers_[index])
      fault = "stands in the file of frame " + std::to_string(numbers_[index]);
    if (!fault.empty())
      throw InputFileException(path(index) + ": frame " +
                               std::to_string(header.number) + ": " + fault);
  }

  std::string folder_;
  TrinocularRig rig_;
  std::vector<std::uint64_t> numbers_;
  std::vector<std::optional<std::int32_t>> observations_;
};

constexpr std::size_t max_told = 1000;

using Shot = std::pair<std::int32_t, std::int32_t>; // observation, pattern
using ShotNumbers = std::map<Shot, std::uint64_t>;

std::string
textOf(const Shot& shot)
{
  return "observation " + std::to_string(shot.first) +
         (shot.second == TrinocularFrame::no_pattern
              ? " without a pattern"
              : " under pattern " + std::to_string(shot.second));
}

std::string
frameText(std::uint64_t number)
{
  return "frame " + std::to_string(number);
}

/** The position of a missing shot, relative to the existing frames. */
std::string
placeOf(const Shot& missing, const ShotNumbers& shots)
{
  const auto next = shots.upper_bound(missing);
  return next == shots.begin() ? "before " + frameText(next->second)
                               : "after " + frameText(std::prev(next)->second);
}

/** All observations should have the same patterns. The number of missing shots that are
 * reported individually is limited, since observations without common patterns would
 * have a large number of them. */
void
findMissing(const ShotNumbers& shots, TrinocularFileReport& report)
{
  std::set<std::int32_t> observations;
  std::set<std::int32_t> patterns;
  for (const auto& [shot, number] : shots) {
    observations.insert(shot.first);
    patterns.insert(shot.second);
  }
  for (const std::int32_t observation : observations)
    for (const std::int32_t pattern : patterns) {
      const Shot shot{observation, pattern};
      if (shots.count(shot) > 0)
        continue;
      if (report.missing.size() == max_told) {
        const std::size_t missing =
            observations.size() * patterns.size() - shots.size();
        report.remarks.push_back(std::to_string(missing - max_told) +
                                 " more shots are missing");
        return;
      }
      report.missing.push_back({observation, pattern});
      report.remarks.push_back("the shot of " + textOf(shot) + " is missing, " +
                               placeOf(shot, shots));
    }
}

/** Frames are numbered in the order of the shots: a missing number is a lost frame. */
void
findGaps(const SessionSource& source, TrinocularFileReport& report)
{
  std::uint64_t first = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const std::uint64_t number = source.number(i);
    if (number == first + 1)
      report.remarks.push_back(frameText(first) + " is missing");
    else if (number > first)
      report.remarks.push_back("frames " + std::to_string(first) + " to " +
                               std::to_string(number - 1) + " are missing");
    first = number + 1;
  }
}

void
surveyFrames(SessionSource& source, TrinocularFileReport& report)
{
  ShotNumbers shots;
  for (std::size_t i = 0; i < source.size(); ++i)
    try {
      const FrameHeader header = source.readHeader(i);
      const Shot shot{header.observation, header.pattern};
      const auto [known, is_new] = shots.emplace(shot, header.number);
      if (is_new)
        continue;
      report.doubled.push_back(header.number);
      report.remarks.push_back(frameText(header.number) + ": the shot of " +
                               textOf(shot) + " was there before, as " +
                               frameText(known->second));
    }
    catch (const InputFileException& exception) {
      report.broken.push_back(source.number(i));
      report.remarks.push_back(faultText(exception.what()));
    }
  findMissing(shots, report);
}

} // namespace

std::unique_ptr<FrameSource>
openSession(const std::string& folder, TrinocularFileReport& report)
{
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error))
    throw InputFileException(folder + ": is no folder with a session");
  const std::optional<SessionSummary> summary = loadSessionSummary(folder);
  const std::string rig = summary ? summary->rig : SessionSummary().rig;
  auto source = std::make_unique<SessionSource>(
      folder, loadTrinocularRig(pathIn(folder, rig)), listFrames(folder));
  report.frames = source->size();
  report.is_finished = summary.has_value();
  if (!summary)
    report.remarks.push_back(folder + ": was not finished, it has no session.yaml");
  else if (summary->frames != report.frames)
    report.remarks.push_back(folder + ": has " + std::to_string(report.frames) +
                             " frames, session.yaml tells of " +
                             std::to_string(summary->frames));
  if (report.frames == 0)
    report.remarks.push_back(folder + ": has no frame");
  findGaps(*source, report);
  surveyFrames(*source, report);
  return source;
}

} // namespace pcl::acmap
