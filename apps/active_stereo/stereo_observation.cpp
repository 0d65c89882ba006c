#include "stereo_observation.h"

#include "output_target.h"

#include <pcl/core/fields_json.h>
#include <pcl/core/image_file.h>
#include <pcl/pipeline/observation_files.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

constexpr auto matched_index = static_cast<std::size_t>(DisparityOutcome::Matched);
constexpr const char* disparity_name = "disparity";

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

void
requireNoStereo(const OutputFolder& folder)
{
  requireNoneIn(folder, [](const std::string& name) {
    return isSequenceName(name) || name.rfind(disparity_name, 0) == 0;
  });
}

void
saveDisparity(const OutputFolder& folder,
              const StereoOptions& options,
              const SessionObservation& made)
{
  if (!options.hasLists() && !options.disparity)
    return;
  const auto path = [&](const char* ending) {
    return folder.path(options.hasLists()
                           ? std::string(disparity_name) + ending
                           : numberedName(disparity_name, made.number, ending));
  };
  const DisparityImage& disparity = made.matched.disparity;
  savePfm(path(".pfm"), disparity);
  savePng(path(".png"), disparity.width, disparity.height, pictureOf(disparity));
}

void
StereoResults::add(const SessionObservation& made)
{
  const DisparityFusionReport& fusion = made.fusion;
  const DisparityBackProjectionReport& projection = made.projection;
  std::vector<std::string> all_remarks = fusion.remarks;
  all_remarks.insert(
      all_remarks.end(), projection.remarks.begin(), projection.remarks.end());
  Json observation = {{"observation", made.number},
                      {"file", observationName(made.number)},
                      {"frames", made.frames}};
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
    remarks_of[text.get<std::string>()].push_back(number);
  ++observations;
  entries.push_back(observation);
}

bool
StereoResults::has(std::size_t number) const
{
  return std::any_of(entries.begin(), entries.end(), [&](const Json& entry) {
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
  for (const auto& [text, numbers] : remarks_of)
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
