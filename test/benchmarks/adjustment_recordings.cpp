#include "adjustment_runs.h"
#include "bench.h"
#include "bench_data.h"
#include "chain_runs.h"
#include "laser_recording.h"

#include <pcl/core/impl/moments.h>
#include <pcl/core/trajectory.h>
#include <pcl/core/trajectory_error.h>
#include <pcl/pipeline/rgbd_sequence.h>
#include <pcl/pipeline/sequence_adjustment.h>
#include <pcl/pipeline/visual_odometry.h>
#include <pcl/search/kdtree.h>

#include <utility>

namespace pcl::acmap::bench {
namespace {

using Poses = std::vector<Eigen::Isometry3d>;

std::vector<ChainView>
viewsOf(const ObservationSequence& sequence,
        const std::vector<std::size_t>& places,
        const Poses& given,
        const Poses& found)
{
  std::vector<ChainView> views;
  for (std::size_t i = 0; i < places.size(); ++i)
    views.push_back(
        {thinnedPoints(*sequence.load(places[i]).file), given[i], found[i]});
  return views;
}

void
printKitchenRow(const std::string& name,
                const ObservationSequence& sequence,
                const std::vector<std::size_t>& places,
                const Poses& given,
                const Poses& found)
{
  const std::vector<ChainView> views = viewsOf(sequence, places, given, found);
  Row row;
  row << name;
  for (const std::size_t step : {1, 5, 10, 30}) {
    const SurfaceAgreement surfaces = compareSurfaces(views, step, &ChainView::found);
    row << figure(milli * surfaces.median, 1) << figure(milli * surfaces.maximum, 1);
  }
  row << figure(centi * absoluteTrajectoryError(found, given).aligned, 2);
}

/** A part of the scans of the carried laser. */
struct LaserScans {
  std::vector<PointCloud<PointXYZ>::Ptr> clouds;
  Poses poses;
};

std::pair<LaserScans, LaserScans>
partsOf(const ObservationSequence& recorded)
{
  constexpr std::size_t every = 5;
  std::pair<LaserScans, LaserScans> scans; // used, held out
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    const PosedObservation scan = recorded.load(i);
    const auto cloud = std::make_shared<PointCloud<PointXYZ>>();
    fromPCLPointCloud2(scan.file->cloud, *cloud);
    LaserScans& part = i % every == every - 1 ? scans.second : scans.first;
    part.clouds.push_back(cloud);
    part.poses.push_back(scan.T_map_camera);
  }
  return scans;
}

/** The pose of a held-out scan after the corrections of the scans before and after it, each
 * in its own frame; halfway between both.
 * \param[in] before number of the scan before it */
Eigen::Isometry3d
correctedBetween(const Poses& given,
                 const Poses& adjusted,
                 std::size_t before,
                 const Eigen::Isometry3d& pose)
{
  const auto corrected = [&](std::size_t i) {
    return adjusted[i] * given[i].inverse() * pose;
  };
  const Eigen::Isometry3d first = corrected(std::min(before, given.size() - 1)),
                          second = corrected(std::min(before + 1, given.size() - 1));
  Eigen::Isometry3d middle;
  middle.linear() = Eigen::Quaterniond(first.linear())
                        .slerp(0.5, Eigen::Quaterniond(second.linear()))
                        .toRotationMatrix();
  middle.translation() = (first.translation() + second.translation()) / 2;
  middle.makeAffine();
  return middle;
}

/** Distances of the points of a scan from the planes through their neighbours in a map,
 * metres. */
std::vector<double>
distancesFromMap(const PointCloud<PointXYZ>& scan,
                 const Eigen::Isometry3d& pose,
                 const pcl::search::KdTree<PointXYZ>& tree,
                 const PointCloud<PointXYZ>& map)
{
  constexpr std::size_t every = 20;
  constexpr double radius = 0.3, flat = 0.1;
  constexpr std::size_t enough = 12;
  std::vector<double> distances;
  Indices found;
  std::vector<float> squares;
  for (std::size_t i = 0; i < scan.size(); i += every) {
    const Eigen::Vector3d place = pose * scan[i].getVector3fMap().cast<double>();
    PointXYZ query;
    query.getVector3fMap() = place.cast<float>();
    if (tree.radiusSearch(query, radius, found, squares) < static_cast<int>(enough))
      continue;
    Moments moments;
    for (const auto k : found)
      moments += momentsOf(
          map[static_cast<std::size_t>(k)].getVector3fMap().cast<double>() - place);
    const PlaneFit fit = fitPlane(moments);
    if (fit.variances[1] > 0 && fit.variances[0] < flat * fit.variances[1])
      distances.push_back(std::abs(fit.normal.dot(fit.mean)));
  }
  return distances;
}

const Section kitchen_section("kitchen", [] {
  const auto folder = pathOfKitchen();
  if (!folder)
    return;
  const RgbdSequence recorded = openRgbdSequence(*folder);
  const ObservationSequence sequence(recorded, recorded.cameras());
  VisualOdometry odometry;
  VisualOdometry::Egomotion egomotion = odometry.getEgomotion();
  egomotion.setMotionModel(MotionModel::Rigid);
  odometry.setEgomotion(egomotion);
  const VisualOdometryResult result = odometry.compute(sequence);
  std::vector<double> stamps;
  for (std::size_t i = 0; i < sequence.size(); ++i)
    stamps.push_back(sequence.stamp(i));
  const EstimatedPoses estimated = result.estimated(stamps);
  Poses given;
  for (const std::size_t place : estimated.places)
    given.push_back(sequence.load(place).T_map_camera);
  printHead("poses | views 1 apart, median, mm | 90 % | 5 apart | 90 % | 10 apart | 90 "
            "% | 30 apart | 90 % | ATE aligned, cm");
  printKitchenRow(
      "egomotion", sequence, estimated.places, given, estimated.trajectory.poses);
  SequenceAdjustment adjustment;
  adjustment.setNumberOfThreads(1);
  adjustment.setOdometryNoise(*estimated.noise);
  Trajectory adjusted;
  const Cost cost = measureCost([&] {
    adjustment.compute(sequence.withPoses(estimated.places, estimated.trajectory),
                       adjusted);
  });
  printKitchenRow("adjusted", sequence, estimated.places, given, adjusted.poses);
  printKitchenRow("given", sequence, estimated.places, given, given);
  const PlaneAdjustmentReport& report = adjustment.getReport();
  std::cout << "\n"
            << nameOf(report.outcome) << ": " << report.reason << "; significance "
            << report.significance << ", prior " << report.prior
            << ", factors of the odometry " << report.odometry_factors[0] << " and "
            << report.odometry_factors[1] << ", floor at 2 m " << milli * report.floor
            << " mm, noise at 2 m " << milli * report.noise_factor << " mm; "
            << cost.cpu << " s CPU\n";
});

const Section livox_section("livox", [] {
  constexpr double max_ratio = 0.7;
  const std::optional<ObservationSequence> scans = loadLaserScans();
  if (!scans)
    return;
  // Held-out scans are adjusted to the map that the others give: both sets of poses are
  // found in one run each, so that a held-out scan never moved what it is compared with.
  const auto [used, held_out] = partsOf(*scans);
  PlaneAdjustment<PointXYZ> adjustment;
  adjustment.setNumberOfThreads(1);
  adjustment.setOdometryNoise({0.02, 0.01, 0.005, 0.01});
  for (std::size_t i = 0; i < used.clouds.size(); ++i)
    adjustment.addPointCloud(used.clouds[i], used.poses[i]);
  const Cost cost = measureCost([&] { adjustment.compute(); });
  Poses adjusted;
  for (std::size_t i = 0; i < used.clouds.size(); ++i)
    adjusted.push_back(adjustment.getPose(i));
  printHead("map | thickness to held-out scans, rms of the best 90 %, mm | median, mm");
  double thickness[2] = {};
  for (const bool is_adjusted : {false, true}) {
    const PointCloud<PointXYZ>::Ptr map(new PointCloud<PointXYZ>);
    for (std::size_t i = 0; i < used.clouds.size(); ++i)
      for (const PointXYZ& point : *used.clouds[i]) {
        PointXYZ moved;
        moved.getVector3fMap() = ((is_adjusted ? adjusted : used.poses)[i] *
                                  point.getVector3fMap().cast<double>())
                                     .cast<float>();
        map->push_back(moved);
      }
    pcl::search::KdTree<PointXYZ> tree;
    tree.setInputCloud(map);
    std::vector<double> distances;
    for (std::size_t i = 0; i < held_out.clouds.size(); ++i) {
      const Eigen::Isometry3d pose =
          is_adjusted
              ? correctedBetween(used.poses, adjusted, 4 * i + 3, held_out.poses[i])
              : held_out.poses[i];
      const auto found = distancesFromMap(*held_out.clouds[i], pose, tree, *map);
      distances.insert(distances.end(), found.begin(), found.end());
    }
    const double limit = quantile(distances, 0.9);
    double squares = 0;
    std::size_t count = 0;
    for (const double distance : distances)
      if (distance <= limit) {
        squares += distance * distance;
        ++count;
      }
    thickness[is_adjusted] = std::sqrt(squares / static_cast<double>(count));
    Row() << (is_adjusted ? "adjusted" : "as given")
          << figure(milli * thickness[is_adjusted], 1)
          << figure(milli * median(distances), 1);
  }
  const PlaneAdjustmentReport& report = adjustment.getReport();
  std::cout << "\n"
            << nameOf(report.outcome) << ": " << report.reason << "; ratio "
            << thickness[1] / thickness[0] << " (goal " << max_ratio
            << "); significance " << report.significance << ", thickness of the planes "
            << milli * report.thickness_before << " to "
            << milli * report.thickness_after << " mm, noise at 2 m "
            << milli * report.noise_factor << " mm; " << cost.cpu << " s CPU\n";
});

} // namespace
} // namespace pcl::acmap::bench
