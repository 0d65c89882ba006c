#include "pose_adjustment.h"

#include "fields_json.h"

#include <pcl/pipeline/sequence_adjustment.h>

#include <algorithm>
#include <optional>

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

Trajectory
adjustPoses(const ObservationSequence& sequence,
            const std::vector<Eigen::Isometry3d>& before,
            const OdometryNoise& noise,
            const RunControls& controls,
            StageLog& log)
{
  SequenceAdjustment adjustment;
  adjustment.setNumberOfThreads(controls.threads);
  adjustment.setProgressCallback(controls.progress);
  adjustment.setOdometryNoise(noise);
  adjustment.setPosesBefore(before);
  Trajectory adjusted;
  adjustment.compute(sequence, adjusted);
  const PlaneAdjustmentReport& report = adjustment.getReport();
  log.warn(report.remarks);
  log.tell(std::string("planes ") + nameIn(adjustment_outcome_names, report.outcome),
           report.reason);
  log.tell("thickness",
           "of planes seen by several observations " +
               shortNumber(report.thickness_before) + " m, adjusted " +
               shortNumber(report.thickness_after) + " m");
  log.tell("moved by planes", "at most " + shortNumber(maximumOf(report.moved)) + " m");
  if (adjustment.getRevisitReport())
    tellRevisits(*adjustment.getRevisitReport(), report, log);
  log.details["adjustment"] = detailsOf(report, adjustment.getRevisitReport());
  return adjusted;
}

} // namespace pcl::acmap
