#include "compact_mapping/chain_report.h"
#include "compact_mapping/live_map.h"
#include "compact_mapping/map_run.h"
#include "compact_mapping/map_stage.h"
#include "compact_mapping/run_ranks.h"
#include "drawn_apart.h"
#include "output_target.h"
#include "pose_options.h"

#include <pcl/pipeline/map_report.h>
#include <pcl/pipeline/ranked_work.h>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace {

using namespace pcl::acmap;
namespace fs = std::filesystem;

/** \brief Is a path the folder, or below it? */
bool
isIn(const std::string& path, const std::string& folder)
{
  const auto real = [](const std::string& name) {
    std::error_code error;
    const fs::path path = fs::weakly_canonical(fs::absolute(name), error);
    return path.has_filename() ? path : path.parent_path();
  };
  const fs::path inner = real(path), outer = real(folder);
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first ==
         outer.end();
}

std::vector<std::string>
inputsOf(const ChainOptions& options)
{
  std::vector<std::string> inputs = {options.input};
  if (!options.stereo.poses.empty())
    inputs.push_back(options.stereo.poses);
  if (!options.earlier.empty())
    inputs.push_back(options.earlier);
  if (!options.truth.empty())
    inputs.push_back(options.truth + "/truth.json");
  return inputs;
}

/** \brief Checks that inputs are not in the folders of the results. */
void
checkPlaces(const ChainOptions& options)
{
  for (const std::string& input : inputsOf(options))
    if (isIn(input, options.output))
      throw UsageError(input + ": lies in the folder that is to hold the map; name "
                               "another one");
}

void
run(Tool& tool, const ChainOptions& options)
{
  checkPlaces(options);
  const pcl::MapInput input = pcl::openMapInput(
      options.input,
      {tool.reader(), options.bag, options.rgbd, options.texture.skip_broken});
  requireSense(tool, options, input.start);
  const PicturesApart pictures(options.has_pictures, tool.log());
  tool.requireReportWritable(inputsOf(options));
  std::optional<pcl::SessionTruth> truth;
  if (!options.truth.empty())
    truth = pcl::loadSessionTruth(options.truth);
  tool.setOutputFolder(options.output);
  OutputFolder folder(options.output);

  const auto values = [&](const std::string& group) { return valuesIn(tool, group); };
  tool.setRunKind(std::string(nameOf(input.start)) +
                  (options.planes.paper ? ", paper" : "") +
                  (pictures.canBeDrawn() ? ", pictures" : ""));
  MapRun made(options, values, tool.controls(), pictures, folder, tool.log());
  if (options.as_recorded)
    made.replay();
  else
    made.run(input);
  for (const RunStage& stage : made.stages())
    if (stage.is_reused)
      tool.forgetTime();
  const StageLog& told = made.stages().back().told;
  std::optional<pcl::MapFigures> figures;
  if (truth)
    figures = compareMap(options, made.state(), told, *truth);
  tellPoseReading(options.poses, made.state().report.pose_convention, tool.log());
  if (const auto& path = made.state().report.path;
      path && input.start == pcl::StartingPoint::PosedObservations)
    tellPath(*path, tool.log());
  tellChain(options, input.start, made.stages(), figures, tool.log());
  pcl::MapReport(jsonText(tool.fullReport()))
      .savePage(options.output + "/report.html", options.output);
  if (made.missing())
    made.missing()->fail(options.output);
}

/** \brief Works for rank 0, which alone prints and writes. */
int
serve(Tool& tool, pcl::Ranks& ranks, int argc, char** argv)
{
  tool.beSilent();
  return tool.run(argc, argv, [&] { serveRanks(ranks); });
}

/** \brief Makes the map, with the processes of this run if there are several. */
int
lead(Tool& tool, ChainOptions& options, const RunRanks& ranks, int argc, char** argv)
{
  options.ranks = ranks.get();
  const int code = tool.run(argc, argv, [&] {
    takePaperWay(tool, options);
    options.rectification.up = tool.reader().getUpDirection();
    run(tool, options);
  });
  if (!ranks.get())
    return code;
  if (code == exit_interrupted)
    ranks.abort(code); // the others may be in the midst of something
  endRanks(*ranks.get());
  return code;
}

} // namespace

int
main(int argc, char** argv)
{
  const RunRanks ranks(argc, argv);
  Tool tool(
      "pcl_compact_mapping",
      "Turns what a rig saw of a building, or its point clouds, into a few textured "
      "planes.");
  ChainOptions options;
  addOptions(tool, options);
  tool.setHelp(
      {{{"pcl_compact_mapping cloud.ply -o map",
         "A map of one cloud; map/map.html shows it in a browser."},
        {"pcl_compact_mapping recording -o map",
         "A map of a raw session, an RGB-D folder, a bag, or a folder of clouds."},
        {"pcl_compact_mapping session -o map --truth session",
         "The same of a simulated session, compared with its truth."},
        {"pcl_compact_mapping second -o both --extend first",
         "A second recording extends the map of the first one."}},
       {"--output",
        "--up",
        "--scale",
        "--sensor-at",
        "--columns",
        "--truth",
        "--paper",
        "--as-recorded",
        "--live",
        "--6dof",
        "--extend",
        "--pose-convention",
        "--no-rectification",
        "--no-details",
        "--no-pictures",
        "--formats",
        "--threads",
        "--memory-limit",
        "--report",
        "--quiet",
        "--verbose",
        "--help",
        "--version"}});
  if (ranks.get())
    ranks.get()->setIdleCallback(stopIfInterrupted);
  return ranks.get() && ranks.get()->rank() > 0
             ? serve(tool, *ranks.get(), argc, argv)
             : lead(tool, options, ranks, argc, argv);
}
