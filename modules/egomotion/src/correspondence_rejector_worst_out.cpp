#include "worst_out/blob_places.h"

#include <pcl/core/arguments.h>
#include <pcl/egomotion/correspondence_rejector_worst_out.h>

#include <string>
#include <utility>

namespace pcl::registration {

namespace {

using Places = std::vector<Eigen::Vector3f>;

const Eigen::Vector3f&
placeAt(const Places& places, index_t index, const char* name)
{
  if (index < 0 || static_cast<std::size_t>(index) >= places.size())
    acmap::refuseArgument(std::string("index into the ") + name,
                          static_cast<double>(index),
                          "within a cloud of " + std::to_string(places.size()) +
                              " points");
  return places[static_cast<std::size_t>(index)];
}

std::size_t
countInvalid(const Places& source, const Places& target)
{
  std::size_t invalid = 0;
  for (std::size_t i = 0; i < source.size(); ++i)
    invalid += !(source[i].allFinite() && target[i].allFinite());
  return invalid;
}

void
remark(const acmap::WorstOutSettings& settings, WorstOutReport& report)
{
  if (report.invalid > 0)
    report.remarks.push_back(std::to_string(report.invalid) +
                             " matches have a point that is not finite");
  if (report.kept == 0)
    report.remarks.push_back("no " + std::to_string(settings.min_matches) + " of " +
                             std::to_string(report.given) +
                             " matches agree on distances: none is kept");
}

} // namespace

CorrespondenceRejectorWorstOut::CorrespondenceRejectorWorstOut()
{
  rejection_name_ = "CorrespondenceRejectorWorstOut";
}

void
CorrespondenceRejectorWorstOut::setMaximumDistortion(double distortion)
{
  acmap::requireInRange("maximum distortion", distortion, 1.0, 1000.0, "(no unit)");
  settings_.max_distortion = distortion;
}

void
CorrespondenceRejectorWorstOut::setMinimumDistance(double metres)
{
  acmap::requireInRange("minimum distance", metres, 0.0, 1e6, "m");
  settings_.min_distance = metres;
}

void
CorrespondenceRejectorWorstOut::setMinimumMatches(std::size_t matches)
{
  acmap::requireInRange(
      "minimum matches", static_cast<double>(matches), 3.0, 1e6, "matches");
  settings_.min_matches = matches;
}

void
CorrespondenceRejectorWorstOut::setSampleSize(std::size_t matches)
{
  acmap::requireInRange(
      "sample size", static_cast<double>(matches), 10.0, 1e6, "matches");
  settings_.sample = matches;
}

void
CorrespondenceRejectorWorstOut::setSourcePoints(PCLPointCloud2::ConstPtr cloud)
{
  source_ = acmap::placesOf(cloud);
}

void
CorrespondenceRejectorWorstOut::setTargetPoints(PCLPointCloud2::ConstPtr cloud)
{
  target_ = acmap::placesOf(cloud);
}

void
CorrespondenceRejectorWorstOut::getRemainingCorrespondences(
    const Correspondences& original_correspondences,
    Correspondences& remaining_correspondences)
{
  if (!source_ || !target_)
    PCL_THROW_EXCEPTION(InitFailedException,
                        "no " << (source_ ? "target" : "source") << " cloud was set");
  WorstOutReport report;
  acmap::StepTimer timer(report);
  Places source, target;
  for (const Correspondence& match : original_correspondences) {
    source.push_back(placeAt(*source_, match.index_query, "source"));
    target.push_back(placeAt(*target_, match.index_match, "target"));
  }
  const acmap::WorstOutOutcome outcome =
      acmap::leaveWorstOut(source, target, settings_);
  Correspondences remaining;
  for (const std::int32_t kept : outcome.kept)
    remaining.push_back(original_correspondences[static_cast<std::size_t>(kept)]);
  report.given = original_correspondences.size();
  report.kept = remaining.size();
  report.invalid = countInvalid(source, target);
  report.distortion = outcome.distortion;
  timer.finish("leaving the worst out");
  remark(settings_, report);
  report_ = std::move(report);
  remaining_correspondences = std::move(remaining);
}

void
CorrespondenceRejectorWorstOut::applyRejection(Correspondences& correspondences)
{
  getRemainingCorrespondences(*input_correspondences_, correspondences);
}

} // namespace pcl::registration
