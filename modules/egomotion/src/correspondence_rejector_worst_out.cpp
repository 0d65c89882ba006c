#include <pcl/PCLPointCloud2.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/egomotion/correspondence_rejector_worst_out.h>

#include <Eigen/Core>

#include <array>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

namespace {

/** Offset of a coordinate within a point. */
std::size_t
offsetOf(const PCLPointCloud2& cloud, const std::string& name)
{
  const PCLPointField* const field = findField(cloud, name);
  if (!field)
    throw acmap::BadArgument("a cloud has no field " + name);
  // A count of 0 means 1, as in old files.
  if (field->datatype != PCLPointField::FLOAT32 || field->count > 1)
    throw acmap::BadArgument("the field " + name +
                             " is refused: it must be one 32 bit float");
  if (field->offset + sizeof(float) > cloud.point_step)
    throw acmap::BadArgument("the field " + name +
                             " is refused: it must lie inside of a point");
  return field->offset;
}

void
requireData(const PCLPointCloud2& cloud)
{
  const std::size_t row = static_cast<std::size_t>(cloud.width) * cloud.point_step;
  if (cloud.height > 0 && cloud.row_step < row)
    throw acmap::BadArgument("the row step " + std::to_string(cloud.row_step) +
                             " is refused: it must hold a row, " + std::to_string(row) +
                             " bytes");
  const std::size_t needed = static_cast<std::size_t>(cloud.height) * cloud.row_step;
  if (cloud.data.size() < needed)
    throw acmap::BadArgument("a cloud of " + std::to_string(cloud.data.size()) +
                             " bytes is refused: it must have " +
                             std::to_string(needed));
}

/** \brief The points of a cloud of unknown type, from its fields x, y and z.
 * \throws BadArgumentException without a cloud, if a field is missing or not a single
 * float, or if the data are shorter than the header declares */
std::vector<Eigen::Vector3f>
placesOf(const PCLPointCloud2::ConstPtr& cloud)
{
  if (!cloud)
    throw acmap::BadArgument("a cloud is missing");
  const std::array<std::size_t, 3> offsets{
      offsetOf(*cloud, "x"), offsetOf(*cloud, "y"), offsetOf(*cloud, "z")};
  requireData(*cloud);
  std::vector<Eigen::Vector3f> places;
  places.reserve(static_cast<std::size_t>(cloud->width) * cloud->height);
  for (std::size_t row = 0; row < cloud->height; ++row)
    for (std::size_t column = 0; column < cloud->width; ++column) {
      const std::uint8_t* const point =
          cloud->data.data() + row * cloud->row_step + column * cloud->point_step;
      Eigen::Vector3f place;
      for (int axis = 0; axis < 3; ++axis)
        std::memcpy(&place[axis], point + offsets[axis], sizeof(float));
      places.push_back(place);
    }
  return places;
}

} // namespace

} // namespace pcl::acmap

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
