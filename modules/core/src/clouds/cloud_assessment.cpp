#include "noise/point_sample.h"

#include <pcl/core/cloud_assessment.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/length_remarks.h>
#include <pcl/core/impl/parallel.h>

#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

namespace pcl {

namespace acmap {
namespace {

using Report = CloudAssessmentReport;

void
countPoints(const PointView& points, Report& report)
{
  constexpr std::size_t between_polls = 4096;
  LargeVector<std::uint64_t> places;
  places.reserve(points.size());
  report.points = points.size();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % between_polls == 0)
      pollRun();
    const Eigen::Vector3f point = points[i];
    if (!point.allFinite())
      continue;
    const Eigen::Vector3d place = point.cast<double>();
    report.minimum = report.finite_points == 0 ? place : place.cwiseMin(report.minimum);
    report.maximum = report.finite_points == 0 ? place : place.cwiseMax(report.maximum);
    ++report.finite_points;
    if (point.isZero(0))
      ++report.zero_points;
    else
      places.push_back(hashOfPlace(point, 0));
  }
  oneapi::tbb::parallel_sort(places.begin(), places.end());
  const auto end = std::unique(places.begin(), places.end());
  report.duplicate_points = static_cast<std::size_t>(places.end() - end);
}

Report::Unit
unitOf(const PointCloudFile& file, const PointView& points, double spacing)
{
  Report::Unit unit;
  if (file.stated_scale)
    return {*file.stated_scale, UnitOutcome::Stated, "stated"};
  for (const std::string& remark : lengthRemarks(points, spacing))
    if (remark.find("--scale") != std::string::npos)
      unit = {1, UnitOutcome::Doubtful, remark};
  if (unit.outcome == UnitOutcome::Assumed)
    unit.evidence = "spacing and extent are those of rooms or landscapes in metres";
  return unit;
}

Report::Noise
noiseOf(const NoiseScale& scale)
{
  Report::Noise noise;
  noise.is_determined = scale.is_determined && scale.spacing > 0;
  noise.value = scale.sigma;
  noise.interval = scale.interval;
  noise.confidence = scale.confidence;
  if (!scale.remarks.empty())
    noise.evidence = scale.remarks.front();
  else
    noise.evidence =
        scale.inverse_depth ? "steps of the depth" : "thickness of plane places";
  return noise;
}

Report::Colors
colorsIn(const CloudRows& rows)
{
  const ColorView colors = colorsOf(rows);
  if (!colors)
    return {};
  constexpr std::uint32_t without_alpha = 0x00ffffff;
  const auto at = [&](std::size_t i) {
    std::uint32_t packed = 0;
    std::memcpy(&packed,
                static_cast<const char*>(colors.first) + i * colors.stride,
                sizeof packed);
    return packed & without_alpha;
  };
  const std::uint32_t first = at(0);
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (at(i) != first)
      return {ColorContent::Varied};
  return {first == 0 ? ColorContent::Empty : ColorContent::One};
}

} // namespace

std::optional<UpEvidence>
statedUp(const std::optional<Eigen::Vector3d>& given, const PointCloudFile& file)
{
  if (given)
    return UpEvidence{UpOutcome::Stated, *given, 1, "stated"};
  if (file.up)
    return UpEvidence{
        UpOutcome::Stated, file.up->cast<double>().normalized(), 1, "stated"};
  return std::nullopt;
}

} // namespace acmap

using namespace acmap;

void
CloudAssessment::setInputCloud(const std::shared_ptr<const PointCloudFile>& file)
{
  requireGiven(file);
  setInputCloud(sharedCloud(file), file);
}

void
CloudAssessment::setInputCloud(const CloudRows& rows,
                               std::shared_ptr<const PointCloudFile> file)
{
  requireGiven(rows);
  rows_ = rows;
  file_ = file ? std::move(file) : std::make_shared<const PointCloudFile>();
}

void
CloudAssessment::setViewpoints(std::vector<Eigen::Vector3f> viewpoints)
{
  requireViewpoints(viewpoints);
  viewpoints_ = std::move(viewpoints);
}

void
CloudAssessment::setUpDirection(const Eigen::Vector3d& up)
{
  given_up_ = requiredDirection(up);
}

void
CloudAssessment::compute()
{
  const PointView points = requirePoints(rows_);
  const Progress progress(progress_);
  progress.tell(0, "assessment");
  CloudAssessmentReport report;
  StepTimer timer(report);
  withThreads(threads_, [&] { countPoints(points, report); });
  const PCLPointCloud2& layout = rows_.layout();
  report.columns = layout.height > 1 ? layout.width : 0;
  report.shift = file_->shift;
  report.text_columns = file_->columns;
  report.colors = colorsIn(rows_);
  timer.finish("points");
  report.names_views = findField(layout, "view", PCLPointField::INT32);
  if (!report.names_views)
    report.sensors =
        withThreads(threads_, [&] { return sensorEvidence(rows_, *file_); });
  timer.finish("sensors");
  const auto sensor = report.sensors.isKnown()
                          ? std::make_optional(file_->sensor_origin)
                          : std::nullopt;
  scale_ = measureNoiseScale(
      points, sensorsOf(rows_, viewpoints_, sensor), threads_, report.columns);
  report.spacing = scale_.spacing;
  report.noise = noiseOf(scale_);
  timer.finish("noise");
  const std::optional<UpEvidence> stated = statedUp(given_up_, *file_);
  report.up = stated ? *stated
                     : findUp(points,
                              scale_.spacing,
                              scale_.sigma,
                              file_->usual_up,
                              threads_,
                              file_->sensor_origin.isZero(0) ? report.sensors
                                                             : SensorEvidence());
  timer.finish("up");
  report.unit = unitOf(*file_, points, scale_.spacing);
  if (report.unit.outcome == UnitOutcome::Doubtful &&
      report.up.outcome == UpOutcome::Found) {
    report.up = UpEvidence();
    if (file_->usual_up)
      report.up.value = file_->usual_up->cast<double>().normalized();
    report.up.evidence = "the unit is doubtful";
  }
  if (!report.up.isKnown())
    report.remarks.push_back("the up direction is assumed: " + report.up.evidence +
                             " (setUpDirection, --up)");
  if (!report.noise->is_determined)
    report.remarks.push_back("the noise is undetermined: " + report.noise->evidence +
                             " (setVoxelSize, --consolidate)");
  if (report.unit.outcome == UnitOutcome::Doubtful)
    report.remarks.push_back("the unit is doubtful: " + report.unit.evidence);
  report_ = std::move(report);
}

} // namespace pcl
