#include "stereo_results.h"

#include <pcl/pipeline/observation_files.h>

#include <algorithm>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;
using Outcomes = std::array<std::size_t, disparity_outcomes>;

constexpr auto matched_index = static_cast<std::size_t>(DisparityOutcome::Matched);

// number of remarks in warnings; the report has all
constexpr std::size_t max_named = 10;

Json
jsonOf(const Outcomes& outcomes)
{
  Json json = Json::object();
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    json[nameOf(static_cast<DisparityOutcome>(i))] = outcomes[i];
  return json;
}

std::string
percent(double share)
{
  return shortNumber(100.0 * share) + " %";
}

/** \brief The minimum depth that is searched; it is above the requested one if image or
 * matcher limit the disparities. */
double
nearestOf(const StereoOptions& options,
          const TrinocularRig& rig,
          const SearchRange& range)
{
  return std::max(options.nearest, depthOf(rig, range.most()));
}

/** \brief How the shots were matched. With one image per camera, which the user may have
 * taken with or without a pattern, the other possibility is named too. */
std::string
methodText(const StereoOptions& options)
{
  if (!options.hasOneShot())
    return options.method;
  return options.isPassive() ? "passive stereo, one image per camera "
                               "(--active: taken under a pattern)"
                             : "one shot under a pattern (--active)";
}

} // namespace

void
StereoResults::add(const ObservationShots& shots, const MadeObservation& made)
{
  const DisparityFusionReport& fusion = made.fusion;
  const DisparityBackProjectionReport& projection = made.projection;
  Json remarks = Json::array();
  for (const auto* report :
       {static_cast<const Report*>(&fusion), static_cast<const Report*>(&projection)})
    for (const std::string& text : report->remarks)
      remarks.push_back(text);
  addEntry({{"observation", shots.number},
            {"file", observationName(shots.number)},
            {"frames", shots.frames.size()},
            {"shots", fusion.shots},
            {"off_shots", fusion.off_shots},
            {"matched", fusion.outcomes[matched_index]},
            {"points", projection.points},
            {"too_near", projection.too_near},
            {"too_far", projection.too_far},
            {"outcomes", jsonOf(fusion.outcomes)},
            {"coverage", fusion.coverage},
            {"remarks", std::move(remarks)}});
}

void
StereoResults::takeEntries(const Json& entries)
{
  for (const Json& entry : entries)
    addEntry(entry);
}

void
StereoResults::addEntry(const Json& entry)
{
  const auto number = entry.at("observation").get<std::size_t>();
  frames_ += entry.at("frames").get<std::size_t>();
  points_ += entry.at("points").get<std::size_t>();
  too_near_ += entry.at("too_near").get<std::size_t>();
  too_far_ += entry.at("too_far").get<std::size_t>();
  for (std::size_t i = 0; i < outcomes_.size(); ++i) {
    const auto count = entry.at("outcomes")
                           .at(nameOf(static_cast<DisparityOutcome>(i)))
                           .get<std::size_t>();
    outcomes_[i] += count;
    pixels_ += count;
  }
  for (const Json& text : entry.at("remarks"))
    addRemark(text.get<std::string>(), number);
  numbers_.insert(number);
  entries_.push_back(entry);
}

void
StereoResults::addRemark(const std::string& text, std::size_t observation)
{
  Remark& remark = remarks_[text];
  if (remark.count++ == 0)
    remark.first = observation;
}

void
StereoResults::requireAny(Tool& tool,
                          const StereoOptions& options,
                          const ShotSource& source) const
{
  if (points_ > 0)
    return;
  warn(tool, options, source);
  if (observations() == 0)
    throw InputFileException(
        options.session + ": has no frame that can be read" +
        (tool.warnings().empty() ? "" : ", " + tool.warnings()[0]));
  tool.failWithNothing((options.session.empty() ? "" : options.session + ": ") +
                       "no pixel has a place: " + rejected());
}

double
StereoResults::matchedShare() const
{
  return pixels_ == 0 ? 0.0
                      : static_cast<double>(outcomes_[matched_index]) /
                            static_cast<double>(pixels_);
}

std::string
StereoResults::matchedText() const
{
  return percent(matchedShare()) + " of the pixels";
}

std::string
StereoResults::rejected() const
{
  std::vector<std::pair<std::size_t, std::string>> reasons = {
      {too_near_, "nearer than --min-depth"}, {too_far_, "farther than --max-depth"}};
  for (std::size_t i = 0; i < outcomes_.size(); ++i)
    if (i != matched_index)
      reasons.emplace_back(outcomes_[i], nameOf(static_cast<DisparityOutcome>(i)));
  std::stable_sort(reasons.begin(), reasons.end(), [](const auto& a, const auto& b) {
    return a.first > b.first;
  });
  std::string text;
  for (const auto& [count, name] : reasons)
    if (count > 0)
      text += (text.empty() ? "" : ", ") +
              percent(static_cast<double>(count) / static_cast<double>(pixels_)) + " " +
              name;
  return text.empty() ? "none" : text;
}

void
StereoResults::tell(Tool& tool,
                    const StereoOptions& options,
                    const ShotSource& source,
                    const SearchRange& range) const
{
  warn(tool, options, source);
  const char* const frames = source.isRectifying() ? "raw" : "rectified";
  const double nearest = nearestOf(options, source.rig(), range);
  Json& details = tool.details();
  details = {{"input", options.hasLists() ? options.rig : options.session},
             {"output", options.output},
             {"frames", frames},
             {"method", options.isPassive() ? "passive" : options.method},
             {"least_disparity", range.least},
             {"most_disparity", range.most()},
             {"least_depth", nearest},
             {"most_depth", options.farthest},
             {"has_poses", !options.poses.empty()},
             {"points", points_},
             {"matched_share", matchedShare()},
             {"outcomes", jsonOf(outcomes_)},
             {"broken_frames", source.broken()},
             {"findings", source.remarks()},
             {"observations", entries_}};
  tool.tell("observations", std::to_string(observations()));
  tool.tell("frames",
            std::to_string(frames_) +
                (source.isRectifying() ? ", rectified here" : ", taken as rectified"));
  tool.tell("method", methodText(options));
  tool.tell("searched",
            std::to_string(range.least) + " to " + std::to_string(range.most()) +
                " px, depths of " + shortNumber(nearest) + " to " +
                shortNumber(options.farthest) + " m");
  tool.tell("matched", matchedText());
  tool.tell("points", std::to_string(points_));
  tool.tell("rejected", rejected());
  if (!options.hasLists())
    tool.tell("poses", options.poses.empty() ? "none" : options.poses);
  tool.tellSeconds();
  tool.tell("folder", options.output);
}

void
StereoResults::warn(Tool& tool,
                    const StereoOptions& options,
                    const ShotSource& source) const
{
  const std::vector<std::string> findings = source.remarks();
  for (std::size_t i = 0; i < std::min(max_named, findings.size()); ++i)
    tool.warn(findings[i]);
  if (findings.size() > max_named)
    tool.warn(std::to_string(findings.size() - max_named) +
              " further findings, the report names them");
  warnOfRemarks(tool);
  if (options.hasLists() && source.hasCameras() && !source.isRectifying())
    tool.warn("images are taken as rectified; if they are as the cameras in " +
              options.rig + " gave them, they need --rectify");
}

void
StereoResults::warnOfRemarks(Tool& tool) const
{
  for (const auto& [text, remark] : remarks_)
    tool.warn("observation " + std::to_string(remark.first) +
              (remark.count > 1
                   ? " and " + std::to_string(remark.count - 1) + " others: "
                   : ": ") +
              text);
}

} // namespace pcl::acmap
