#include "stage_reports.h"

#include <pcl/core/impl/unit_text.h>

#include <cstdio>

namespace pcl::acmap {

namespace {

/** An axis by its name, another direction by three numbers. */
std::string
directionText(const Eigen::Vector3d& direction)
{
  int axis = 0;
  const double largest = direction.cwiseAbs().maxCoeff(&axis);
  constexpr double is_axis = 0.99996; // within half a degree
  if (largest > is_axis)
    return std::string(direction[axis] < 0 ? "-" : "") + "xyz"[axis];
  char text[64];
  std::snprintf(
      text, sizeof text, "%.3f,%.3f,%.3f", direction.x(), direction.y(), direction.z());
  return text;
}

std::string
describe(const CloudAssessmentReport::Noise& noise)
{
  const auto millimetres = [](double metres) { return shortNumber(1000 * metres); };
  if (!noise.is_determined)
    return "undetermined (" + noise.evidence + "); --consolidate states a voxel";
  std::string text = millimetres(noise.value) + " mm, ";
  if (noise.interval)
    text += millimetres((*noise.interval)[0]) + " to " +
            millimetres((*noise.interval)[1]) + " mm, ";
  return text + shortNumber(noise.confidence) + " (" + noise.evidence +
         "); --consolidate states a voxel";
}

} // namespace

std::string
describe(const UpEvidence& up)
{
  return directionText(up.value) + ", " +
         (up.isKnown() ? shortNumber(up.confidence) : std::string("assumed")) + " (" +
         up.evidence + "); --up states another";
}

std::string
describe(const SensorEvidence& sensor)
{
  const std::string evidence = " (" + sensor.evidence + "); --sensor-at states ";
  switch (sensor.outcome) {
  case SensorOutcome::Proved:
    return "at the origin, " + shortNumber(sensor.confidence) + evidence + "another";
  case SensorOutcome::Refuted:
    return "not at the origin" + evidence + "one";
  default:
    return "undetermined" + evidence + "one";
  }
}

void
tellConsolidation(const ConsolidationReport& report, StageLog& log)
{
  log.details["consolidation"] = jsonOf(report);
  log.tell("consolidated",
           std::to_string(report.points) + " points to " +
               std::to_string(report.representatives) + ", voxels of " +
               shortNumber(report.voxel_size) + " m, noise " +
               shortNumber(1000 * report.sigma) + " to about " +
               shortNumber(1000 * report.residual) + " mm");
}

void
tellDepthNoise(const NoiseScale::InverseDepth& noise, StageLog& log)
{
  log.details["depth"] = fieldsOf(noise);
  log.details["depth"]["sigma"] = noise.sigma();
  const auto at = [](double inverse_depth, double depth) {
    return shortNumber(1000 * inverse_depth * depth * depth) + " mm";
  };
  log.tell("depth",
           (noise.step > 0 ? "quantised, steps of " + at(noise.step, 2) + " at 2 m, " +
                                 at(noise.step, 4) + " at 4 m"
                           : std::string("not quantised")) +
               "; noise " + at(noise.sigma(), 2) + " at 2 m, " + at(noise.sigma(), 4) +
               " at 4 m");
}

void
tellRefinement(const DepthRefinementReport& report, StageLog& log)
{
  log.details["refinement"] = jsonOf(report, {{"noise"}}); // told by the depth
  const std::size_t measured_points = report.points - report.invalid_points;
  log.tell("refined",
           percent(report.on_planes, measured_points) + " of the points onto " +
               std::to_string(report.planes) + " planes, " +
               percent(report.smoothed, measured_points) + " onto their neighbourhood");
}

std::string
describe(const CloudAssessmentReport::Unit& unit)
{
  switch (unit.outcome) {
  case UnitOutcome::Stated:
    return unitText(unit.value) + " m, stated";
  case UnitOutcome::Assumed:
    return "metres, assumed (" + unit.evidence + "); --scale states another";
  case UnitOutcome::Doubtful:
    break;
  }
  return "metres, doubtful (" + unit.evidence + ")";
}

void
tellColumns(const std::string& columns, StageLog& log)
{
  if (!columns.empty())
    log.tell("columns", columns + "; --columns states others");
}

void
tellAssessment(const CloudAssessmentReport& report, StageLog& log)
{
  log.details["assessment"] = jsonOf(report);
  tellColumns(report.text_columns, log);
  if (report.up.outcome != UpOutcome::Stated)
    log.tell("up", describe(report.up));
  if (!report.names_views && report.sensors.outcome != SensorOutcome::Stated)
    log.tell("sensor", describe(report.sensors));
  if (report.noise)
    log.tell("noise", describe(*report.noise));
}

std::string
percent(std::size_t part, std::size_t whole)
{
  return shortNumber(whole ? 100.0 * static_cast<double>(part) /
                                 static_cast<double>(whole)
                           : 0.0) +
         " %";
}

} // namespace pcl::acmap
