#include "rectification_reports.h"

#include "stage_reports.h"

#include <algorithm>

namespace pcl::acmap {

namespace {

constexpr double degrees = 180 / 3.14159265358979323846;

const char*
outcomeName(RectificationOutcome outcome)
{
  switch (outcome) {
  case RectificationOutcome::Rectified:
    return "rectified";
  case RectificationOutcome::Kept:
    return "kept";
  case RectificationOutcome::Refused:
    return "refused";
  default:
    return "undetermined";
  }
}

nlohmann::ordered_json
jsonOf(const MapEvidence& evidence)
{
  return {{"rays", evidence.rays},
          {"near_contradictions", evidence.near_contradictions},
          {"far_contradictions", evidence.far_contradictions},
          {"near_rays", evidence.near_rays},
          {"far_rays", evidence.far_rays},
          {"mean_map_entropy", evidence.mean_map_entropy},
          {"orthogonal_variance", evidence.orthogonal_variance}};
}

/** The steps as columns, since there may be thousands of them. */
nlohmann::ordered_json
jsonOf(const std::vector<RectificationStep>& steps)
{
  nlohmann::ordered_json columns = {{"search", nlohmann::ordered_json::array()},
                                    {"bin_size", nlohmann::ordered_json::array()},
                                    {"entropy", nlohmann::ordered_json::array()},
                                    {"prior", nlohmann::ordered_json::array()},
                                    {"energy", nlohmann::ordered_json::array()}};
  for (const RectificationStep& step : steps) {
    columns["search"].push_back(step.search);
    columns["bin_size"].push_back(step.bin_size);
    columns["entropy"].push_back(step.entropy);
    columns["prior"].push_back(step.prior);
    columns["energy"].push_back(step.energy);
  }
  return columns;
}

void
addDetails(Tool& tool,
           const RectificationOptions& options,
           const EntropyRectificationReport& report)
{
  tool.details().update({{"input", options.input()},
                         {"output", options.output},
                         {"mode", nameOf(options.mode)},
                         {"bin_size", options.binSize()},
                         {"seed", options.seed},
                         {"observations", report.observations},
                         {"points", report.points},
                         {"invalid_points", report.invalid_points},
                         {"outcome", outcomeName(report.outcome)},
                         {outcomeName(report.outcome), report.reason},
                         {"evaluations", report.evaluations},
                         {"odometry_scale", report.odometry_scale},
                         {"strongest_action", report.strongest_action},
                         {"disagreement", report.disagreement},
                         {"before", jsonOf(report.before)},
                         {"after", jsonOf(report.after)},
                         {"moved", report.moved},
                         {"turned", report.turned},
                         {"steps", jsonOf(report.steps)},
                         {"rectification_seconds", secondsOf(report)}});
}

double
largestOf(const std::vector<double>& values)
{
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

/** Fraction of rays before and after, in %. */
std::string
change(double before, double after, bool is_new)
{
  return shortNumber(100 * before) + (is_new ? " % before, " : " % (best candidate ") +
         shortNumber(100 * after) + (is_new ? " % after" : " %)");
}

void
tellEvidence(Tool& tool, const EntropyRectificationReport& report)
{
  const bool is_new = report.outcome == RectificationOutcome::Rectified;
  const MapEvidence& before = report.before;
  const MapEvidence& after = report.after;
  const auto near_confirmed = [](const MapEvidence& rays) {
    return rays.near_rays * (1 - rays.near_contradictions);
  };
  const auto far_confirmed = [](const MapEvidence& rays) {
    return rays.far_rays * (1 - rays.far_contradictions);
  };
  tool.tell("contradicted",
            "of the rays that near observations tell about " +
                change(before.near_contradictions, after.near_contradictions, is_new) +
                "; of those that far ones do " +
                change(before.far_contradictions, after.far_contradictions, is_new));
  tool.tell("confirmed",
            "of all rays by near observations " +
                change(near_confirmed(before), near_confirmed(after), is_new) +
                "; by far ones " +
                change(far_confirmed(before), far_confirmed(after), is_new));
}

} // namespace

void
tellOutcome(Tool& tool,
            const RectificationOptions& options,
            const EntropyRectificationReport& report)
{
  for (const std::string& remark : report.remarks)
    if (remark != report.reason)
      tool.warn(remark);
  tool.tell(outcomeName(report.outcome), report.reason);
  if (report.outcome == RectificationOutcome::Refused ||
      report.outcome == RectificationOutcome::Undetermined)
    tool.warn("the poses are as they came: " + report.reason);
  if (report.before.rays > 0)
    tellEvidence(tool, report);
  tool.tell("moved",
            "at most " + shortNumber(largestOf(report.moved)) + " m and " +
                shortNumber(degrees * largestOf(report.turned)) + " degrees");
  addDetails(tool, options, report);
}

} // namespace pcl::acmap
