#include "beam_scan.h"

#include <pcl/core/impl/quantile.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {
namespace {

constexpr double min_range = 0.1;      ///< metres
constexpr double max_beams = 360;      ///< of a scan; denser ones are thinned
constexpr int beams_of_line = 4;       ///< on each side of an echo
constexpr double max_roughness = 0.04; ///< metres, rms, of a line
constexpr std::size_t min_echoes = 3;  ///< of a line
constexpr double usual_beams = 180;    ///< to which scores are scaled

struct PolarPoint {
  double angle, range;
  Eigen::Vector2d place;
};

/** Is a point of a wall at the height of the sensor, where little stands in front of it? */
bool
isInSlice(const LevelledPoints& seen, std::size_t point)
{
  constexpr float half_height = 0.3F; // metres
  constexpr float upright = 0.5F;     // largest |cosine| of a normal to the vertical
  const auto height = static_cast<float>(seen.sensor_height);
  return seen.points[point].allFinite() &&
         std::abs(seen.points[point].y() - height) < half_height &&
         !(!seen.normals.empty() && std::abs(seen.normals[point].y()) > upright);
}

std::vector<PolarPoint>
polarPoints(const LevelledPoints& seen)
{
  std::vector<PolarPoint> points;
  for (std::size_t k = 0; k < seen.points.size(); ++k) {
    const Eigen::Vector2d place(seen.points[k].x(), seen.points[k].z());
    const double range = place.norm();
    if (isInSlice(seen, k) && range > min_range)
      points.push_back({std::atan2(place.x(), place.y()), range, place});
  }
  std::stable_sort(
      points.begin(), points.end(), [](const PolarPoint& a, const PolarPoint& b) {
        return a.angle < b.angle;
      });
  return points;
}

/** The usual step between beams; missing echoes only make some steps larger. */
double
stepOf(const std::vector<PolarPoint>& points, bool is_scan)
{
  constexpr double step_of_slice =
      1.5 * M_PI / 180; // beams that nearly always have points
  if (!is_scan)
    return step_of_slice;
  std::vector<double> steps;
  for (std::size_t k = 1; k < points.size(); ++k)
    steps.push_back(points[k].angle - points[k - 1].angle);
  const double sweep = points.back().angle - points.front().angle;
  return std::max(medianOf(steps), std::max(sweep, 0.01) / max_beams);
}

/** The point of each beam: the nearest to its middle, or of those in a slice the one with the
 * median range. */
std::vector<const PolarPoint*>
pointsOfBeams(const std::vector<PolarPoint>& points, const BeamScan& scan, bool is_scan)
{
  std::vector<std::vector<const PolarPoint*>> in_beam(scan.ranges.size());
  const auto placeOf = [&](const PolarPoint& point) {
    return (point.angle - scan.first_angle) / scan.step;
  };
  for (const PolarPoint& point : points) {
    const auto beam = static_cast<std::size_t>(std::lround(placeOf(point)));
    if (beam < in_beam.size())
      in_beam[beam].push_back(&point);
  }
  std::vector<const PolarPoint*> chosen(in_beam.size(), nullptr);
  for (std::size_t beam = 0; beam < in_beam.size(); ++beam) {
    std::vector<const PolarPoint*>& all = in_beam[beam];
    if (all.empty())
      continue;
    std::stable_sort(
        all.begin(), all.end(), [&](const PolarPoint* a, const PolarPoint* b) {
          const auto middle = static_cast<double>(beam);
          return is_scan
                     ? std::abs(placeOf(*a) - middle) < std::abs(placeOf(*b) - middle)
                     : a->range < b->range;
        });
    chosen[beam] = all[is_scan ? 0 : all.size() / 2];
  }
  return chosen;
}

/** Fits lines to neighbouring echoes. */
void
addNormals(BeamScan& scan)
{
  const int beams = static_cast<int>(scan.ranges.size());
  for (int beam = 0; beam < beams; ++beam) {
    if (scan.echo_of[beam] < 0)
      continue;
    BeamScan::Echo& echo = scan.echoes[scan.echo_of[beam]];
    const double reach = 2 * std::max(0.15, 4 * scan.ranges[beam] * scan.step);
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
    std::size_t count = 0;
    for (int k = std::max(0, beam - beams_of_line);
         k <= std::min(beams - 1, beam + beams_of_line);
         ++k) {
      if (scan.echo_of[k] < 0)
        continue;
      const Eigen::Vector2d off = scan.echoes[scan.echo_of[k]].place - echo.place;
      if (off.norm() > reach)
        continue;
      ++count;
      mean += off;
      moments += off * off.transpose();
    }
    if (count < min_echoes)
      continue;
    mean /= static_cast<double>(count);
    const Eigen::Matrix2d spread =
        moments / static_cast<double>(count) - mean * mean.transpose();
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
    solver.computeDirect(spread);
    if (!(std::sqrt(std::max(0.0, solver.eigenvalues()[0])) < max_roughness) ||
        !(solver.eigenvalues()[0] < 0.2 * solver.eigenvalues()[1]))
      continue;
    const Eigen::Vector2d normal = solver.eigenvectors().col(0);
    echo.normal = normal.dot(echo.place) > 0 ? Eigen::Vector2d(-normal) : normal;
    echo.is_on_line = true;
  }
}

/** The way from a scan to the other only. */
void
addOneWay(const BeamScan& to,
          const BeamScan& from,
          const PlanarMotion& motion,
          PairScore& score)
{
  const double weight = usual_beams / static_cast<double>(from.ranges.size());
  const Eigen::Matrix2d rotation = motion.rotation();
  for (const BeamScan::Echo& echo : from.echoes) {
    if (!echo.is_on_line)
      continue;
    const Eigen::Vector2d place = motion.place(echo.place.x(), echo.place.y());
    const double range = place.norm();
    const double cosine =
        range > min_range ? -(rotation * echo.normal).dot(place) / range : 0;
    if (!(cosine > 0)) // faces away
      continue;
    const double at = to.beamAt(place);
    if (at < 0)
      continue;
    const int beam = static_cast<int>(at),
              last = static_cast<int>(to.ranges.size()) - 1;
    if (!(to.ranges[beam] > 0 && to.ranges[beam + 1] > 0))
      continue;
    double low = to.ranges[beam], high = low;
    for (int k = std::max(0, beam - 1); k <= std::min(last, beam + 2); ++k)
      if (to.ranges[k] > 0) {
        low = std::min(low, to.ranges[k]);
        high = std::max(high, to.ranges[k]);
      }
    const double margin = 0.1 + 0.01 * range;
    const double slope = std::max(cosine, 0.15);
    if ((low - range) * slope > margin) {
      if (cosine > 0.3) {
        score.through += weight;
        score.merit -= 2 * weight;
      }
    }
    else if ((range - high) * slope > margin) {
      score.occluded += weight;
      score.merit -= 0.5 * weight;
    }
    else if (cosine > 0.1) {
      const int nearest = at - beam < 0.5 ? beam : beam + 1;
      const BeamScan::Echo* line = nullptr;
      for (const int k : {nearest, 2 * beam + 1 - nearest})
        if (!line && to.echoes[to.echo_of[k]].is_on_line)
          line = &to.echoes[to.echo_of[k]];
      const double between =
          to.ranges[beam] + (at - beam) * (to.ranges[beam + 1] - to.ranges[beam]);
      const double off =
          line ? line->normal.dot(place - line->place) : (between - range) * cosine;
      const double sigma = 0.025 + 0.004 * range;
      score.agree += weight;
      score.merit +=
          weight * std::log(0.3 + 8 * std::exp(-off * off / (2 * sigma * sigma)));
    }
  }
}

} // namespace

bool
isPlanarScan(const LevelledPoints& seen)
{
  constexpr float thickness = 0.05F; // metres
  const auto height = static_cast<float>(seen.sensor_height);
  return std::all_of(
      seen.points.begin(), seen.points.end(), [=](const Eigen::Vector3f& point) {
        return !point.allFinite() || std::abs(point.y() - height) < thickness;
      });
}

double
BeamScan::directionOf(const Eigen::Vector2d& place) const
{
  const double middle = first_angle + step * static_cast<double>(ranges.size() - 1) / 2;
  const double angle =
      middle + std::remainder(std::atan2(place.x(), place.y()) - middle, 2 * M_PI);
  return (angle - first_angle) / step;
}

double
BeamScan::beamAt(const Eigen::Vector2d& place) const
{
  const double at = directionOf(place);
  return at < 0 || !(at < static_cast<double>(ranges.size() - 1)) ? -1 : at;
}

BeamScan
beamScanOf(const LevelledPoints& seen)
{
  BeamScan scan;
  const std::vector<PolarPoint> points = polarPoints(seen);
  if (points.size() < min_echoes) {
    scan.ranges.assign(2, 0);
    scan.echo_of.assign(2, -1);
    return scan;
  }
  const bool is_scan = isPlanarScan(seen);
  scan.first_angle = points.front().angle;
  scan.step = stepOf(points, is_scan);
  const auto beams = static_cast<std::size_t>(
      std::lround((points.back().angle - scan.first_angle) / scan.step) + 1);
  scan.ranges.assign(std::max<std::size_t>(beams, 2), 0);
  scan.echo_of.assign(scan.ranges.size(), -1);
  const std::vector<const PolarPoint*> chosen = pointsOfBeams(points, scan, is_scan);
  for (std::size_t beam = 0; beam < chosen.size(); ++beam)
    if (chosen[beam]) {
      scan.ranges[beam] = chosen[beam]->range;
      scan.echo_of[beam] = static_cast<int>(scan.echoes.size());
      scan.echoes.push_back({chosen[beam]->place, Eigen::Vector2d::Zero(), false});
    }
  addNormals(scan);
  return scan;
}

PairScore
scoreOf(const BeamScan& i, const BeamScan& j, const PlanarPose& T_i_j)
{
  PairScore score;
  addOneWay(i, j, PlanarMotion(T_i_j), score);
  const PlanarAction back = actionBetween(T_i_j, PlanarPose());
  addOneWay(j, i, PlanarMotion({back.dx, back.dz, back.dtheta}), score);
  return score;
}

} // namespace pcl::acmap
