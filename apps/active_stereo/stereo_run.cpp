#include "stereo_options.h"

#include "known_poses.h"
#include "memory.h"
#include "output_target.h"
#include "stereo_files.h"
#include "stereo_results.h"

#include <pcl/core/output_file.h>

#include <filesystem>
#include <functional>
#include <future>
#include <optional>

namespace pcl::acmap {

namespace {

void
checkPlaces(const Tool& tool, const StereoOptions& options, const OutputFolder& folder)
{
  if (!options.hasLists() && folder.holds(options.session + "/any"))
    throw UsageError(options.output + ": is the session's folder, too");
  if (!options.goes_on)
    requireNoStereo(folder);
  std::vector<std::string> inputs = options.allImages();
  inputs.insert(inputs.end(), {options.rigPath(), options.poses});
  tool.requireReportWritable(inputs);
}

/** \brief Seconds of each step, summed over the observations. */
void
addSums(const pcl::Report& steps, pcl::Report& report)
{
  for (const char* const step : {"wait for shots", "match", "write"}) {
    double sum = 0;
    for (const auto& [name, seconds] : steps.seconds)
      sum += name == step ? seconds : 0;
    report.seconds.emplace_back(step, sum);
  }
}

/** \brief The shots of an observation, and the progress of the whole work. */
struct ComingShots {
  std::optional<ObservationShots> shots;
  double done = 0; ///< fraction of all frames
};

ComingShots
read(ShotSource& source)
{
  ComingShots coming;
  coming.shots = source.next();
  coming.done =
      static_cast<double>(source.passed()) / static_cast<double>(source.frames());
  return coming;
}

/** \brief Name of the file that lists the finished observations, from which a later run
 * can continue. */
constexpr const char* finished_name = "finished.json";

void
saveFinished(const StereoResults& results, const OutputFolder& folder)
{
  const std::string text = results.entries().dump() + "\n";
  OutputFile file(folder.path(finished_name));
  file.write(text.data(), text.size());
  file.commit();
}

/** \brief Moves an observation to its final place, with the statistics so far: a run
 * that is killed loses only the observation that it was working on. */
void
commitObservation(const StereoOptions& options,
                  const ObservationShots& shots,
                  const MadeObservation& made,
                  const Eigen::Isometry3d& pose,
                  const StereoResults& results)
{
  OutputFolder folder(options.output);
  saveResults(folder, options, shots, made, pose);
  saveFinished(results, folder);
  folder.commit();
}

/** \brief Computes the observations one after another, while the next one is read.
 * Their files are in the hidden part of the folder, unless a later run is to continue
 * from them. */
void
writeObservations(Tool& tool,
                  const StereoOptions& options,
                  ShotSource& source,
                  ObservationMaker& maker,
                  const KnownPoses& poses,
                  const OutputFolder& folder,
                  StereoResults& results)
{
  pcl::Report steps;
  StepTimer timer(steps);
  const auto readOn = [&] {
    return std::async(std::launch::async, read, std::ref(source));
  };
  tool.withProgress([&](const pcl::ProgressCallback& progress) {
    const Progress told(progress);
    double begin = 0;
    std::future<ComingShots> next = readOn();
    for (;;) {
      told.tell(begin, "reading shots");
      const auto [shots, done] = next.get();
      timer.finish("wait for shots");
      if (!shots)
        break;
      next = readOn();
      if (!results.has(shots->number)) {
        const MadeObservation made = maker.make(
            *shots,
            [&, from = begin, to = done](double fraction, const std::string& step) {
              return progress(from + fraction * (to - from), step);
            });
        timer.finish("match");
        results.add(*shots, made);
        if (options.goes_on)
          commitObservation(options, *shots, made, poses.of(shots->number), results);
        else
          saveResults(folder, options, *shots, made, poses.of(shots->number));
        timer.finish("write");
      }
      begin = done;
    }
  });
  addSums(steps, tool.report());
}

StereoResults
finishedBefore(const StereoOptions& options)
{
  namespace fs = std::filesystem;
  const fs::path folder = options.output;
  const auto entries = readJson((folder / finished_name).string());
  if (!options.goes_on || !entries.is_array())
    return {};
  try {
    auto there = nlohmann::ordered_json::array();
    for (const auto& entry : entries) {
      const auto name = entry.at("file").get<std::string>();
      if (isPlainName(name) && fs::exists(folder / name))
        there.push_back(entry);
    }
    StereoResults results;
    results.takeEntries(there);
    return results;
  }
  catch (const nlohmann::json::exception&) {
    return {}; // damaged: everything is computed again
  }
}

/** \brief Keeps the observations that were finished before an interruption; each of
 * them is complete.
 * \throws InterruptedPartway when there is any */
void
keepFinished(const StereoOptions& options,
             const StereoResults& results,
             OutputFolder& folder)
{
  if (results.points() == 0)
    return;
  folder.commit();
  throw InterruptedPartway("interrupted; observations finished by then, in " +
                           options.output + ": " +
                           std::to_string(results.observations()));
}

} // namespace

void
makeObservations(Tool& tool, const StereoOptions& options)
{
  requireSense(options);
  StepTimer timer(tool.report());
  ShotSource source(options, tool.threads());
  const SearchRange range =
      disparitiesBetween(source.rig(), options.nearest, options.farthest);
  requireMemory(disparityMemory(source.rig(), range),
                std::to_string(range.count) + " disparities of " +
                    std::to_string(source.rig().width) + " x " +
                    std::to_string(source.rig().height) + " pixels");
  const KnownPoses poses(options.poses, source);
  ObservationMaker maker(source.rig(), range, options, tool.threads());
  OutputFolder folder(options.output);
  checkPlaces(tool, options, folder);
  poses.save(folder);
  timer.finish("open");

  StereoResults results = finishedBefore(options);
  try {
    writeObservations(tool, options, source, maker, poses, folder, results);
  }
  catch (const pcl::CancelledException&) {
    keepFinished(options, results, folder);
    throw;
  }
  results.requireAny(tool, options, source);
  folder.commit();
  std::error_code ignored;
  std::filesystem::remove(options.output + "/" + finished_name, ignored);
  results.tell(tool, options, source, range);
}

} // namespace pcl::acmap
