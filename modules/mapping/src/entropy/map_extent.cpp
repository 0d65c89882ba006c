#include "map_extent.h"

#include <pcl/core/impl/arguments.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl::acmap {

void
MapExtent::add(const Eigen::Vector2d& place, double weight)
{
  if (weight_ == 0)
    origin_ = place;
  const Eigen::Vector2d way = place - origin_;
  weight_ += weight;
  sum_ += weight * way;
  squares_ += weight * way * way.transpose();
}

void
MapExtent::add(const MapExtent& observation, const PlanarMotion& motion)
{
  const double weight = observation.weight_;
  if (weight == 0)
    return;
  const Eigen::Vector2d way = observation.sum_ / weight;
  const Eigen::Vector2d mean = observation.origin_ + way;
  add(motion.place(mean[0], mean[1]), weight);
  const Eigen::Matrix2d scatter =
      observation.squares_ - observation.sum_ * way.transpose();
  squares_ += motion.rotation() * scatter * motion.rotation().transpose();
}

int
MapExtent::dimensions(double bin_size) const
{
  if (weight_ == 0)
    return 0;
  const Eigen::Vector2d mean = sum_ / weight_;
  const Eigen::Matrix2d covariance = squares_ / weight_ - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(covariance, Eigen::EigenvaluesOnly);
  const double minor = std::sqrt(std::max(solver.eigenvalues()[0], 0.0));
  const double major = std::sqrt(std::max(solver.eigenvalues()[1], 0.0));
  const double minimum = std::max(1e-4 * bin_size, 1e-7 * major);
  return (major > minimum) + (minor > minimum);
}

bool
canHaveGrid(const std::vector<BinRange>& ranges,
            double weight,
            const MapEntropySettings& settings,
            MapEntropyReport& report)
{
  if (report.distant_points) {
    std::ostringstream text;
    text << report.distant_points
         << " points are 1e+09 m or more from their sensor: no entropy, take them out";
    report.remarks.push_back(text.str());
    return false;
  }
  if (weight == 0 && report.points > report.invalid_points) {
    report.remarks.emplace_back("no point has a weight: no entropy");
    return false;
  }
  BinRange all;
  std::size_t widest = 0;
  double maximum = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    all.add(ranges[i]);
    const double bins =
        ranges[i].isEmpty() ? 0 : EntropyGrid::binsOf(ranges[i], settings);
    if (bins > maximum)
      widest = i;
    maximum = std::max(maximum, bins);
  }
  if (all.isEmpty()) {
    report.remarks.emplace_back("no finite point: no entropy");
    return false;
  }
  const double bins = EntropyGrid::binsOf(all, settings);
  if (bins <= maximum_entropy_bins)
    return true;
  std::ostringstream text;
  text << "the map takes " << bins << " bins of " << settings.bin_size
       << " m, of which " << maximum_entropy_bins
       << " are allowed: no entropy. The widest observation, " << widest << ", takes "
       << maximum << " alone";
  report.remarks.push_back(text.str());
  return false;
}

void
remarkOnMap(const MapEntropyTerms& terms,
            const MapEntropySettings& settings,
            MapEntropyReport& report)
{
  if (settings.direction_aware && report.directed_points == 0)
    report.remarks.emplace_back("no point has the normal of a wall: directions, which "
                                "were asked for, play no role");
  if (report.observations == 1)
    report.remarks.emplace_back(
        "one observation: there is nothing that it could fit or not fit");
  if (terms.dimensions == 0)
    report.remarks.emplace_back("all points lie in one place of the XZ plane: the "
                                "entropy tells nothing of how they are turned");
  if (terms.dimensions == 1)
    report.remarks.emplace_back(
        "all points lie on one line of the XZ plane: the entropy "
        "tells little of moves along it");
}

void
requirePlanarPose(const PlanarPose& pose)
{
  requireInRange("x of the pose", pose.x, -1e9, 1e9, "m");
  requireInRange("z of the pose", pose.z, -1e9, 1e9, "m");
  requireInRange("theta of the pose", pose.theta, -1e3, 1e3, "rad");
}

const MapEntropySettings&
requireSmoothing(const MapEntropySettings& settings)
{
  requireInRange("smoothing sigma_XZ",
                 settings.smoothing,
                 0,
                 100 * settings.bin_size,
                 "m (100 bins)");
  return settings;
}

void
addCounts(const MapEntropyReport& counts, MapEntropyReport& report)
{
  report.observations += counts.observations;
  report.points += counts.points;
  report.invalid_points += counts.invalid_points;
  report.distant_points += counts.distant_points;
  report.directed_points += counts.directed_points;
  report.cells += counts.cells;
}

} // namespace pcl::acmap
