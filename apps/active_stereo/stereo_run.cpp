#include "stereo_options.h"

#include "output_target.h"
#include "stage_reports.h"

#include <pcl/core/impl/json_text.h>
#include <pcl/core/process_memory.h>
#include <pcl/core/rig_cameras.h>

#include <algorithm>
#include <memory>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

std::shared_ptr<const FrameReader>
openFrames(const StereoOptions& options, const std::optional<CalibratedRig>& rig)
{
  if (rig)
    return std::make_shared<TrinocularFileGrabber>(options.images, rig->rig);
  return std::make_shared<TrinocularFileGrabber>(options.session);
}

SessionConversion
conversionOf(const StereoOptions& options, const ProgressCallback& progress)
{
  SessionConversion conversion;
  conversion.poses = options.poses;
  conversion.writes_disparities = options.hasLists() || options.disparity;
  conversion.numbers_disparities = !options.hasLists();
  conversion.goes_on = options.goes_on;
  conversion.progress = progress;
  return conversion;
}

/** \throws InputFileException when there was no readable frame
 * \throws NothingFound when no observation has a point */
void
requireResults(const StereoOptions& options,
               const ConvertedSession& converted,
               const StageLog& log)
{
  if (converted.report.observations == 0)
    throw InputFileException(
        options.session +
        (options.settings.unlit
             ? ": has no shot without projected light that can be read"
             : ": has no frame that can be read") +
        (log.report.remarks.empty() ? "" : ", " + log.report.remarks[0]));
  if (converted.report.points == 0)
    log.failWithNothing((options.session.empty() ? "" : options.session + ": ") +
                        noPlaceText(converted));
}

/** How the shots were matched. With one image per camera, which the user may have taken with
 * or without a pattern, the other possibility is named too. */
std::string
methodText(const StereoOptions& options)
{
  if (options.settings.unlit)
    return "passive stereo, shots without projected light";
  if (!options.hasOneShot())
    return options.method;
  return options.isPassive() ? "passive stereo, one image per camera "
                               "(--active: taken under a pattern)"
                             : "one shot under a pattern (--active)";
}

/** The depths that the disparities can be of, metres. */
std::pair<double, double>
searchedDepths(const DisparityBackProjection& depths, const SessionSource& session)
{
  const TrinocularRig& rig = session.rig();
  const SearchRange& range = session.range();
  // above the requested one if image or matcher limit the disparities
  const double nearest =
      std::max(depths.getMinimumDepth(), depthOf(rig, range.maximum()));
  // with an offset, disparities below 0 would be farther away
  const double farthest =
      disparityOffset(rig) > 0.0
          ? std::min(depths.getMaximumDepth(), depthOf(rig, range.minimum))
          : depths.getMaximumDepth();
  return {nearest, farthest};
}

void
tellConversion(const StereoOptions& options,
               const std::optional<CalibratedRig>& rig_of_lists,
               const SessionSource& session,
               const FrameReader& frames,
               const ConvertedSession& converted,
               StageLog& log)
{
  const TrinocularRig& rig = session.rig();
  const SearchRange& range = session.range();
  const auto [nearest, farthest] = searchedDepths(options.settings.projection, session);
  log.details = {
      {"input", options.hasLists() ? options.rigPath() : options.session},
      {"output", options.output},
      {"calibration", rig_of_lists ? Json(rig_of_lists->told) : Json()},
      {"rig",
       {{"width", rig.width},
        {"height", rig.height},
        {"focal_length", rig.focal_length},
        {"baseline_horizontal", rig.baseline_horizontal},
        {"baseline_vertical", rig.baseline_vertical}}},
      {"frames", session.isRectifying() ? "raw" : "rectified"},
      {"method", options.isPassive() ? "passive" : options.method},
      {"least_disparity", range.minimum},
      {"most_disparity", range.maximum()},
      {"least_depth", nearest},
      {"most_depth", farthest},
      {"has_poses", !options.poses.empty()},
      {"points", converted.report.points},
      {"matched_share", converted.matchedShare()},
      {"outcomes",
       FieldValueJson()(Named{converted.report.outcomes, disparity_outcome_names})},
      {"broken_frames", frames.faults().broken},
      {"findings", session.remarks()},
      {"observations", Json::parse(converted.figuresText())}};
  if (rig_of_lists)
    log.tell("rig", rig_of_lists->told);
  log.tell("observations", std::to_string(converted.report.observations));
  log.tell("frames",
           std::to_string(converted.report.frames) +
               (session.isRectifying() ? ", rectified here" : ", taken as rectified"));
  log.tell("method", methodText(options));
  log.tell("searched",
           std::to_string(range.minimum) + " to " + std::to_string(range.maximum()) +
               " px, depths of " + shortNumber(nearest) + " to " +
               shortNumber(farthest) + " m");
  tellPoints(converted, log);
  if (!options.hasLists())
    log.tell("poses", options.poses.empty() ? "none" : options.poses);
  log.tellSeconds();
  log.tell("folder", options.output);
}

/** Reasons for missing disparities, most frequent first: "3.1 % untextured, ...". */
std::string
rejectedText(const ConvertedSession& converted)
{
  const SessionReport& report = converted.report;
  std::vector<std::pair<std::size_t, std::string>> reasons = {
      {report.too_near, "nearer than --min-depth"},
      {report.too_far, "farther than --max-depth"}};
  for (std::size_t i = 0; i < report.outcomes.size(); ++i)
    if (const auto outcome = static_cast<DisparityOutcome>(i);
        outcome != DisparityOutcome::Matched)
      reasons.emplace_back(report.outcomes[i], nameOf(outcome));
  std::stable_sort(reasons.begin(), reasons.end(), [](const auto& a, const auto& b) {
    return a.first > b.first;
  });
  std::string text;
  for (const auto& [count, name] : reasons)
    if (count > 0)
      text +=
          (text.empty() ? "" : ", ") + percent(count, converted.pixels()) + " " + name;
  return text.empty() ? "none" : text;
}

} // namespace

std::string
noPlaceText(const ConvertedSession& converted)
{
  return "no pixel has a place: " + rejectedText(converted);
}

void
tellPoints(const ConvertedSession& converted, StageLog& log)
{
  log.tell("matched",
           percent(converted.matched(), converted.pixels()) + " of the pixels");
  log.tell("points", std::to_string(converted.report.points));
  log.tell("rejected", rejectedText(converted));
}

void
warnOfRemarks(const ConvertedSession& converted, StageLog& log)
{
  for (const auto& [text, numbers] : converted.remarks_of)
    log.warn("observation " + std::to_string(numbers.front()) +
             (numbers.size() > 1
                  ? " and " + std::to_string(numbers.size() - 1) + " others: "
                  : ": ") +
             text);
}

void
warnOfFindings(StageLog& log, const std::vector<std::string>& findings)
{
  log.warnOfFirst(10, findings, "further findings, the report names them");
}

void
makeObservations(const StereoOptions& options,
                 const RunControls& controls,
                 StageLog& log)
{
  StepTimer timer(log.report);
  std::optional<CalibratedRig> rig;
  if (options.hasLists())
    rig = options.rigOfLists();
  const std::shared_ptr<const FrameReader> frames = openFrames(options, rig);
  const std::shared_ptr<SessionSource> session = withDepths([&] {
    SessionSettings settings = options.sessionSettings(controls.threads);
    if (rig)
      settings.cameras = rig->cameras;
    return openSession(frames, settings, memoryCheck());
  });
  OutputFolder folder(options.output);
  if (!options.goes_on)
    requireNoneIn(folder, isConvertedName);
  timer.finish("open");
  ConvertedSession converted;
  try {
    convertSession(
        *session, conversionOf(options, controls.progress), folder, converted);
  }
  catch (const CancelledException&) {
    if (converted.report.points == 0)
      throw;
    folder.commit();
    throw InterruptedPartway("interrupted; observations finished by then, in " +
                             options.output + ": " +
                             std::to_string(converted.report.observations));
  }
  for (const auto& step : converted.report.seconds)
    log.report.seconds.push_back(step);
  warnOfFindings(log, session->remarks());
  warnOfRemarks(converted, log);
  if (rig && rig->leaves_built_out)
    log.warn("images are taken as rectified; if they are as the cameras in " +
             options.rigPath() + " gave them, they need --rectify");
  requireResults(options, converted, log);
  folder.commit();
  tellConversion(options, rig, *session, *frames, converted, log);
}

} // namespace pcl::acmap
