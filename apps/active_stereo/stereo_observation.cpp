#include "stereo_observation.h"

#include "fields_json.h"
#include "memory.h"
#include "output_target.h"

#include <pcl/conversions.h>
#include <pcl/core/image_file.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/rig_cameras.h>
#include <pcl/pipeline/observation_files.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

constexpr auto matched_index = static_cast<std::size_t>(DisparityOutcome::Matched);
constexpr const char* disparity_name = "disparity";

/** \brief Memory for the costs of all disparities of a rig's views, in bytes. */
std::size_t
disparityMemory(const TrinocularRig& rig, const SearchRange& range)
{
  constexpr double bytes = 4.0; // one disparity of a pair
  // the vertical pair has disparities in proportion to its baseline
  const double pairs =
      (std::abs(rig.baseline_horizontal) + std::abs(rig.baseline_vertical)) /
      disparityBaseline(rig);
  return static_cast<std::size_t>(bytes * pairs * rig.width * rig.height * range.count);
}

/** \brief Draws disparities as a grey picture, 8 bits per pixel: near is bright (64 to
 * 255), black (0) means invalid. The grey levels span the disparities without the
 * lowest and highest 1 %. */
std::vector<std::uint8_t>
pictureOf(const DisparityImage& disparities)
{
  constexpr float darkest = 64; // clearly distinct from black
  constexpr float brightest = 255;
  constexpr float min_range = 1e-6F; // px
  std::vector<std::uint8_t> greys(disparities.values.size(), 0);
  std::vector<float> found;
  for (const float disparity : disparities.values)
    if (std::isfinite(disparity))
      found.push_back(disparity);
  if (found.empty())
    return greys;
  std::sort(found.begin(), found.end());
  const std::size_t cut = found.size() / 100;
  const float minimum = found[cut];
  const float range = std::max(found[found.size() - 1 - cut] - minimum, min_range);
  for (std::size_t i = 0; i < greys.size(); ++i) {
    const float disparity = disparities.values[i];
    if (!std::isfinite(disparity))
      continue;
    const float share = std::clamp((disparity - minimum) / range, 0.0F, 1.0F);
    greys[i] =
        static_cast<std::uint8_t>(std::lround(darkest + share * (brightest - darkest)));
  }
  return greys;
}

std::string
percent(double share)
{
  return shortNumber(100.0 * share) + " %";
}

} // namespace

double
depthOf(const TrinocularRig& rig, double disparity)
{
  return rig.focal_length * disparityBaseline(rig) / disparity;
}

SearchRange
disparitiesBetween(const TrinocularRig& rig, double nearest, double farthest)
{
  // supported by TrinocularMatching
  constexpr int fewest_disparities = 8;
  constexpr int max_disparities = 1024;
  const double longest =
      (hasCamera(rig, RigCamera::Horizontal) ? rig.width : rig.height) - 1.0;
  // the conversion between depth and disparity is its own inverse
  const double from = std::floor(depthOf(rig, farthest)) - 1.0;
  if (from > longest)
    throw UsageError("--max-depth: at " + shortNumber(farthest) +
                     " m disparities are longer than the image, " +
                     std::to_string(static_cast<long>(longest)) +
                     " px; the rig's baseline is " +
                     shortNumber(disparityBaseline(rig)) + " m");
  const double to = std::min(std::ceil(depthOf(rig, nearest)) + 1.0, longest);
  SearchRange range;
  range.minimum = static_cast<int>(std::max(from, 0.0));
  range.count = std::clamp(
      static_cast<int>(to) - range.minimum + 1, fewest_disparities, max_disparities);
  return range;
}

SearchRange
setUpStereo(const TrinocularRig& rig,
            const StereoOptions& options,
            unsigned threads,
            DisparityFusion& fusion,
            DisparityBackProjection& projection)
{
  const double nearest = options.projection.getMinimumDepth();
  const double farthest = options.projection.getMaximumDepth();
  const SearchRange range = disparitiesBetween(rig, nearest, farthest);
  requireMemory(disparityMemory(rig, range),
                std::to_string(range.count) + " disparities of " + sizeText(rig) +
                    " pixels");
  TrinocularMatching matching = options.matching;
  matching.setXOffset(range.minimum);
  matching.setMaxDisparity(range.count);
  fusion.setMatching(matching);
  fusion.setInputRig(rig);
  fusion.setMethod(disparityFusionMethod(options.method));
  fusion.setPassive(options.isPassive());
  fusion.setNumberOfThreads(threads);
  projection.setInputRig(rig);
  projection.setMinimumDepth(nearest);
  projection.setMaximumDepth(farthest);
  projection.setNumberOfThreads(threads);
  return range;
}

ShotFusion::ShotFusion(const TrinocularRig& rig,
                       const StereoOptions& options,
                       unsigned threads)
: range_(setUpStereo(rig, options, threads, fusion_, projection_))
{}

MadeObservation
ShotFusion::make(const ObservationShots& shots, const ProgressCallback& progress)
{
  // most of the time is spent in the step that does the matching
  const bool at_once = fusion_.getMethod() == DisparityFusion::Method::SpaceTime;
  const double share_of_shots = at_once ? 0.05 : 0.95;
  const auto count = static_cast<double>(shots.frames.size());
  double begin = 0;
  double end = 0;
  fusion_.setProgressCallback([&](double fraction, const std::string& step) {
    return progress(std::min(begin + fraction * (end - begin), end), step);
  });

  MadeObservation made;
  fusion_.clear();
  for (const TrinocularFrame::ConstPtr& frame : shots.frames) {
    end = share_of_shots * static_cast<double>(fusion_.shots() + 1) / count;
    fusion_.addShot(frame);
    begin = end;
  }
  end = 1;
  fusion_.fuse(made.matched);
  fusion_.setProgressCallback({}); // the callback refers to local variables
  made.fusion = fusion_.getReport();
  projection_.project(made.matched, fusion_.getColor(), made.cloud);
  made.projection = projection_.getReport();
  return made;
}

void
requireNoStereo(const OutputFolder& folder)
{
  requireNoneIn(folder, [](const std::string& name) {
    return isSequenceName(name) || name.rfind(disparity_name, 0) == 0;
  });
}

void
saveResults(const OutputFolder& folder,
            const StereoOptions& options,
            std::size_t number,
            const MadeObservation& made,
            const Eigen::Isometry3d& T_map_camera)
{
  PCLPointCloud2 cloud;
  toPCLPointCloud2(made.cloud, cloud);
  saveObservation(folder.path(observationName(number)), cloud, T_map_camera);
  if (!options.hasLists() && !options.disparity)
    return;
  const auto path = [&](const char* ending) {
    return folder.path(options.hasLists()
                           ? std::string(disparity_name) + ending
                           : numberedName(disparity_name, number, ending));
  };
  const DisparityImage& disparity = made.matched.disparity;
  savePfm(path(".pfm"), disparity);
  savePng(path(".png"), disparity.width, disparity.height, pictureOf(disparity));
}

void
StereoResults::add(std::size_t number,
                   std::size_t frame_count,
                   const MadeObservation& made)
{
  const DisparityFusionReport& fusion = made.fusion;
  const DisparityBackProjectionReport& projection = made.projection;
  std::vector<std::string> all_remarks = fusion.remarks;
  all_remarks.insert(
      all_remarks.end(), projection.remarks.begin(), projection.remarks.end());
  Json observation = {{"observation", number},
                      {"file", observationName(number)},
                      {"frames", frame_count}};
  observation.update(fieldsOf(fusion, {{"is_passive"}}));
  observation["matched"] = fusion.outcomes[matched_index];
  observation.update(fieldsOf(projection, {{"invalid"}}));
  observation["remarks"] = all_remarks;
  add(observation);
}

void
StereoResults::add(const Json& observation)
{
  const auto count = [](const Json& json, const char* name) {
    return json.at(name).get<std::size_t>();
  };
  const std::size_t number = count(observation, "observation");
  frames += count(observation, "frames");
  points += count(observation, "points");
  too_near += count(observation, "too_near");
  too_far += count(observation, "too_far");
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const std::size_t found =
        count(observation.at("outcomes"), nameOf(static_cast<DisparityOutcome>(i)));
    outcomes[i] += found;
    pixels += found;
  }
  for (const Json& text : observation.at("remarks"))
    remarks[text.get<std::string>()].push_back(number);
  observations.push_back(observation);
}

bool
StereoResults::has(std::size_t number) const
{
  return std::any_of(observations.begin(), observations.end(), [&](const Json& entry) {
    return entry.at("observation") == number;
  });
}

double
StereoResults::matchedShare() const
{
  return pixels == 0 ? 0.0
                     : static_cast<double>(outcomes[matched_index]) /
                           static_cast<double>(pixels);
}

std::string
StereoResults::rejected() const
{
  std::vector<std::pair<std::size_t, std::string>> reasons = {
      {too_near, "nearer than --min-depth"}, {too_far, "farther than --max-depth"}};
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    if (i != matched_index)
      reasons.emplace_back(outcomes[i], nameOf(static_cast<DisparityOutcome>(i)));
  std::stable_sort(reasons.begin(), reasons.end(), [](const auto& a, const auto& b) {
    return a.first > b.first;
  });
  std::string text;
  for (const auto& [count, name] : reasons)
    if (count > 0)
      text += (text.empty() ? "" : ", ") +
              percent(static_cast<double>(count) / static_cast<double>(pixels)) + " " +
              name;
  return text.empty() ? "none" : text;
}

void
StereoResults::tellPoints(StageLog& log) const
{
  log.tell("matched", percent(matchedShare()) + " of the pixels");
  log.tell("points", std::to_string(points));
  log.tell("rejected", rejected());
}

void
StereoResults::warnOfRemarks(StageLog& log) const
{
  for (const auto& [text, numbers] : remarks)
    log.warn("observation " + std::to_string(numbers.front()) +
             (numbers.size() > 1
                  ? " and " + std::to_string(numbers.size() - 1) + " others: "
                  : ": ") +
             text);
}

void
warnOfFindings(StageLog& log, const std::vector<std::string>& findings)
{
  constexpr std::size_t max_named = 10;
  for (std::size_t i = 0; i < std::min(max_named, findings.size()); ++i)
    log.warn(findings[i]);
  if (findings.size() > max_named)
    log.warn(std::to_string(findings.size() - max_named) +
             " further findings, the report names them");
}

} // namespace pcl::acmap
