#include "pose_adjustment.h"

#include <pcl/core/fields_json.h>

#include <algorithm>

namespace pcl::acmap {

namespace {

nlohmann::ordered_json
detailsOf(const PlaneAdjustmentReport& report,
          const std::optional<RevisitReport>& revisits)
{
  const char* const outcome = nameIn(adjustment_outcome_names, report.outcome);
  nlohmann::ordered_json details = fieldsOf(report,
                                            {{"reason", outcome},
                                             {"views"},
                                             {"invalid_points"},
                                             {"revisits_used"},
                                             {"revisits_dropped"}});
  if (revisits) {
    details["revisits"] =
        fieldsOf(*revisits, {{"views"}, {"points"}, {"invalid_points"}});
    details["revisits"]["used"] = report.revisits_used;
    details["revisits"]["dropped"] = report.revisits_dropped;
  }
  return details;
}

void
tellRevisits(const RevisitReport& revisits,
             const PlaneAdjustmentReport& report,
             StageLog& log)
{
  log.tell("revisits",
           std::to_string(revisits.proposals) + " pairs of observations look alike, " +
               std::to_string(revisits.verified) + " are verified, " +
               std::to_string(report.revisits_used) + " used");
}

double
maximumOf(const std::vector<double>& values)
{
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

} // namespace

void
tellAdjustment(const PlaneAdjustmentReport& report,
               const std::optional<RevisitReport>& revisits,
               StageLog& log)
{
  log.tell(std::string("planes ") + nameIn(adjustment_outcome_names, report.outcome),
           report.reason);
  log.tell("thickness",
           "of planes seen by several observations " +
               shortNumber(report.thickness_before) + " m, adjusted " +
               shortNumber(report.thickness_after) + " m");
  log.tell("moved by planes", "at most " + shortNumber(maximumOf(report.moved)) + " m");
  if (revisits)
    tellRevisits(*revisits, report, log);
  log.details["adjustment"] = detailsOf(report, revisits);
}

} // namespace pcl::acmap
