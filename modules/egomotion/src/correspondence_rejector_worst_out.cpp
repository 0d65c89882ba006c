#include <pcl/PCLPointCloud2.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/egomotion/correspondence_rejector_worst_out.h>

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

namespace {

/** \brief The points of a cloud of unknown type, from its fields x, y and z.
 * \throws BadArgumentException as \ref requirePoints */
std::vector<Eigen::Vector3f>
placesOf(const PCLPointCloud2::ConstPtr& cloud)
{
  try {
    const PointView points = requirePoints(CloudRows(cloud));
    std::vector<Eigen::Vector3f> places;
    places.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      places.push_back(points[i]);
    return places;
  }
  catch (const InitFailedException& fault) {
    throw BadArgument(fault.what());
  }
}

} // namespace

} // namespace pcl::acmap

namespace pcl::registration {

namespace {

using Places = std::vector<Eigen::Vector3f>;

const Eigen::Vector3f&
placeAt(const Places& places, index_t index)
{
  acmap::requireIndex<acmap::BadArgument>(index, places.size());
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
  if (report.kept == 0 && settings.paper)
    report.remarks.push_back("there is no match with finite points");
  else if (report.kept == 0)
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
    throw acmap::InitFailed("no ", (source_ ? "target" : "source"), " cloud was set");
  WorstOutReport report;
  acmap::StepTimer timer(report);
  Places source, target;
  for (const Correspondence& match : original_correspondences) {
    source.push_back(placeAt(*source_, match.index_query));
    target.push_back(placeAt(*target_, match.index_match));
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
