#include "active_stereo/known_poses.h"
#include "active_stereo/stereo_files.h"
#include "active_stereo/stereo_results.h"
#include "memory.h"
#include "output_target.h"

namespace {

using namespace pcl::acmap;

void
checkPlaces(const Tool& tool, const StereoOptions& options, const OutputFolder& folder)
{
  if (!options.hasLists() && folder.holds(options.session + "/any"))
    throw UsageError(options.output + ": is the session's folder, too");
  requireNoStereo(folder);
  std::vector<std::string> inputs = options.allImages();
  inputs.insert(inputs.end(), {options.rigPath(), options.poses});
  tool.requireReportWritable(inputs);
}

/** \brief Seconds of each step, summed over the observations. */
void
addSums(const pcl::Report& steps, pcl::Report& report)
{
  for (const char* const step : {"read shots", "match", "write"}) {
    double sum = 0;
    for (const auto& [name, seconds] : steps.seconds)
      sum += name == step ? seconds : 0;
    report.seconds.emplace_back(step, sum);
  }
}

/** \brief Makes the observations one after another; their files are in the folder's hidden
 * part. */
void
makeObservations(Tool& tool,
                 const StereoOptions& options,
                 ShotSource& source,
                 ObservationMaker& maker,
                 const KnownPoses& poses,
                 const OutputFolder& folder,
                 StereoResults& results)
{
  pcl::Report steps;
  StepTimer timer(steps);
  tool.withProgress([&](const pcl::ProgressCallback& progress) {
    const Progress told(progress);
    const auto all = static_cast<double>(source.frames());
    double done = 0;
    while (const auto shots = source.next([&] { told.tell(done, "reading shots"); })) {
      timer.finish("read shots");
      const double begin = done;
      done = static_cast<double>(source.passed()) / all;
      const MadeObservation made =
          maker.make(*shots, [&](double fraction, const std::string& step) {
            return progress(begin + fraction * (done - begin), step);
          });
      timer.finish("match");
      saveResults(folder, options, *shots, made, poses.of(shots->number));
      results.add(*shots, made);
      timer.finish("write");
    }
  });
  addSums(steps, tool.report());
}

/** \brief What was finished before an interruption is a whole result each.
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

void
convert(Tool& tool, const StereoOptions& options)
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

  StereoResults results;
  try {
    makeObservations(tool, options, source, maker, poses, folder, results);
  }
  catch (const pcl::CancelledException&) {
    keepFinished(options, results, folder);
    throw;
  }
  results.requireAny(tool, options, source);
  folder.commit();
  results.tell(tool, options, source, range);
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool("pcl_active_stereo",
            "Turns what a trinocular rig saw under patterns into observation point "
            "clouds.");
  StereoOptions options;
  addOptions(tool, options);
  return tool.run(argc, argv, [&] { convert(tool, options); });
}
