#include "pose_adjustment.h"

#include <pcl/pipeline/sequence_adjustment.h>

#include <algorithm>
#include <optional>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

const char*
outcomeName(AdjustmentOutcome outcome)
{
  constexpr const char* names[] = {"adjusted", "kept", "refused", "undetermined"};
  return names[static_cast<std::size_t>(outcome)];
}

Json
detailsOf(const PlaneAdjustmentReport& report,
          const std::optional<RevisitReport>& revisits)
{
  const auto in = [](const auto& fields) {
    Json json;
    visitFields(fields,
                [&](const char* name, const auto& value) { json[name] = value; });
    return json;
  };
  Json rounds = Json::array(), uncertainty = Json::array();
  for (const AdjustmentRound& round : report.rounds)
    rounds.push_back(in(round));
  for (const PoseUncertainty& pose : report.uncertainty)
    uncertainty.push_back({{"position", pose.position}, {"rotation", pose.rotation}});
  Json details = {{"outcome", outcomeName(report.outcome)},
                  {outcomeName(report.outcome), report.reason},
                  {"points", report.points},
                  {"pieces", report.pieces},
                  {"planes", report.landmarks},
                  {"associated_pieces", report.associated_pieces},
                  {"noise_factor", report.noise_factor},
                  {"floor", report.floor},
                  {"attempts", report.attempts},
                  {"odometry_factors", report.odometry_factors},
                  {"prior", report.prior},
                  {"thickness_before", report.thickness_before},
                  {"thickness_after", report.thickness_after},
                  {"significance", report.significance},
                  {"rays_before", in(report.rays_before)},
                  {"rays_after", in(report.rays_after)},
                  {"moved", report.moved},
                  {"turned", report.turned},
                  {"rounds", rounds},
                  {"uncertainty", uncertainty}};
  if (revisits)
    details["revisits"] = {{"keypoints", revisits->keypoints},
                           {"proposals", revisits->proposals},
                           {"consistent", revisits->consistent},
                           {"verified", revisits->verified},
                           {"used", report.revisits_used},
                           {"dropped", report.revisits_dropped}};
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
  log.tell(std::string("planes ") + outcomeName(report.outcome), report.reason);
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
