#include "egomotion_runs.h"

#include "bench.h"
#include "bench_data.h"
#include "paper_patterns.h"
#include "rectification_runs.h"

#include <pcl/conversions.h>
#include <pcl/core/image_file.h>
#include <pcl/core/planar_pose.h>
#include <pcl/egomotion/visual_egomotion.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/pipeline/rgbd_observation.h>
#include <pcl/pipeline/rgbd_sequence.h>
#include <pcl/registration/gicp.h>
#include <pcl/registration/ndt.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/standard_scenes.h>
#include <pcl/stereo/active_stereo_grabber.h>

#include <opencv2/calib3d.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include <functional>
#include <memory>
#include <set>

namespace pcl::acmap::bench {

namespace {

/** The same building with a different grain on nearly textureless surfaces.
 * \param[in] building of rectangles, such as corridors */
SceneGeometry
withGrain(const SceneGeometry& building, double grain)
{
  constexpr double textureless = 2;
  SceneGeometry geometry;
  for (const SimulatedSurface& surface : building.surfaces()) {
    SurfaceLook look = surface.look;
    if (look.texture <= textureless)
      look.texture = grain;
    const auto plane = static_cast<std::size_t>(surface.plane);
    geometry.addRectangle(surface.name,
                          building.planes()[plane].name,
                          std::get<SimulatedRectangle>(surface.shape),
                          look);
  }
  return geometry;
}

} // namespace

EgomotionSequence
driveThrough(const std::string& name, std::optional<double> grain, std::size_t views)
{
  SimulatedScene scene = standardScene(name);
  scene.views.resize(std::min(views, scene.views.size()));
  if (grain)
    scene.geometry = withGrain(scene.geometry, *grain);
  std::ostringstream title;
  title << name << ", grain " << grain.value_or(2);
  EgomotionSequence sequence{title.str(), true, scene.rig, {}, scene.views};
  ActiveStereoGrabber stereo(
      std::make_shared<SimulatedRigGrabber>(scene, drawPatterns()));
  const std::function<ActiveStereoGrabber::CloudCallback> keep =
      [&sequence](const EgomotionCloud::ConstPtr& cloud) {
        sequence.clouds.push_back(cloud);
      };
  stereo.registerCallback(keep);
  stereo.start();
  stereo.wait();
  if (const std::exception_ptr error = stereo.getError())
    std::rethrow_exception(error);
  return sequence;
}

std::optional<EgomotionSequence>
loadKitchen()
{
  const auto folder = pathOfKitchen();
  if (!folder)
    return std::nullopt;
  const RgbdSequence recorded = openRgbdSequence(*folder);
  const ColorCamera& camera = recorded.color_camera.value();
  EgomotionSequence kitchen;
  kitchen.name = "redkitchen";
  kitchen.camera.focal_length = camera.pinhole.fx;
  kitchen.camera.center_x = camera.pinhole.cx;
  kitchen.camera.center_y = camera.pinhole.cy;
  for (const RgbdFrame& frame : recorded.frames) {
    const auto cloud = std::make_shared<EgomotionCloud>();
    fromPCLPointCloud2(
        registeredCloud(
            loadRgbImage(frame.color),
            measuredPoints(loadGrayImage16(frame.depth), recorded.camera, {}),
            camera),
        *cloud);
    kitchen.clouds.push_back(cloud);
    kitchen.truth.push_back(loadPose(frame, recorded.cameras()));
  }
  return kitchen;
}

EgomotionMethod
oursMethod(bool refines)
{
  const auto egomotion = std::make_shared<VisualEgomotion<PointXYZRGBSigma>>();
  egomotion->setNumberOfThreads(1);
  egomotion->setRefinement(refines);
  return {refines ? "acmap" : "acmap, features alone",
          [egomotion](const EgomotionSequence& sequence,
                      std::size_t source,
                      std::size_t target) -> std::optional<Eigen::Isometry3d> {
            egomotion->setMotionModel(sequence.is_planar ? MotionModel::Planar
                                                         : MotionModel::Rigid);
            egomotion->setInputSource(sequence.clouds[source]);
            egomotion->setInputTarget(sequence.clouds[target]);
            const auto estimate = egomotion->compute();
            if (!estimate)
              return std::nullopt;
            return estimate->T_target_source;
          }};
}

namespace {

using Points = PointCloud<PointXYZ>;

Points::Ptr
sparseCloud(const EgomotionCloud& cloud)
{
  constexpr float leaf = 0.05F, reach = 6; // metres
  const auto points = std::make_shared<Points>();
  for (const PointXYZRGBSigma& point : cloud)
    if (point.z <= reach) // not NaN
      points->push_back({point.x, point.y, point.z});
  VoxelGrid<PointXYZ> grid;
  grid.setInputCloud(points);
  grid.setLeafSize(leaf, leaf, leaf);
  const auto sparse = std::make_shared<Points>();
  grid.filter(*sparse);
  return sparse;
}

template <typename Registration>
std::optional<Eigen::Isometry3d>
aligned(Registration& registration,
        const EgomotionCloud& source,
        const EgomotionCloud& target)
{
  registration.setInputSource(sparseCloud(source));
  registration.setInputTarget(sparseCloud(target));
  Points moved;
  registration.align(moved);
  if (!registration.hasConverged())
    return std::nullopt;
  return motionOf(registration.getFinalTransformation());
}

} // namespace

EgomotionMethod
gicpMethod(double correspondence_distance, int neighbours)
{
  std::ostringstream title;
  title << "PCL GICP, to " << correspondence_distance << " m, " << neighbours
        << " neighbours";
  return {
      title.str(),
      [=](const EgomotionSequence& sequence, std::size_t source, std::size_t target) {
        GeneralizedIterativeClosestPoint<PointXYZ, PointXYZ> gicp;
        gicp.setMaxCorrespondenceDistance(correspondence_distance);
        gicp.setCorrespondenceRandomness(neighbours);
        return aligned(gicp, *sequence.clouds[source], *sequence.clouds[target]);
      }};
}

EgomotionMethod
ndtMethod(double resolution)
{
  // PCL's tutorial uses 0.01 and 35, with which it stops after the first step here.
  constexpr double step = 0.1, min_change = 1e-4; // metres, square metres
  constexpr int max_iterations = 100;
  std::ostringstream title;
  title << "PCL NDT, cells of " << resolution << " m";
  return {
      title.str(),
      [=](const EgomotionSequence& sequence, std::size_t source, std::size_t target) {
        NormalDistributionsTransform<PointXYZ, PointXYZ> ndt;
        ndt.setResolution(static_cast<float>(resolution));
        ndt.setStepSize(step);
        ndt.setTransformationEpsilon(min_change);
        ndt.setMaximumIterations(max_iterations);
        return aligned(ndt, *sequence.clouds[source], *sequence.clouds[target]);
      }};
}

namespace {

struct OrbView {
  std::vector<cv::KeyPoint> keypoints;
  cv::Mat descriptors;
};

OrbView
describe(const EgomotionCloud& cloud, const OrbSetting& setting)
{
  cv::Mat color(static_cast<int>(cloud.height), static_cast<int>(cloud.width), CV_8UC3);
  auto* value = color.data;
  for (const PointXYZRGBSigma& point : cloud)
    for (const std::uint8_t channel : {point.r, point.g, point.b})
      *value++ = channel;
  cv::Mat grey;
  cv::cvtColor(color, grey, cv::COLOR_RGB2GRAY);
  OrbView view;
  const cv::Ptr<cv::ORB> orb = cv::ORB::create(setting.features);
  orb->setFastThreshold(setting.fast_threshold);
  orb->detectAndCompute(grey, cv::noArray(), view.keypoints, view.descriptors);
  return view;
}

/** Matches from source to target. */
std::vector<cv::DMatch>
matchesOf(const OrbView& source, const OrbView& target, double ratio)
{
  std::vector<cv::DMatch> matches;
  if (source.keypoints.empty() || target.keypoints.empty())
    return matches;
  if (ratio >= 1) {
    cv::BFMatcher(cv::NORM_HAMMING, true)
        .match(source.descriptors, target.descriptors, matches);
    return matches;
  }
  std::vector<std::vector<cv::DMatch>> nearest;
  cv::BFMatcher(cv::NORM_HAMMING)
      .knnMatch(source.descriptors, target.descriptors, nearest, 2);
  for (const std::vector<cv::DMatch>& pair : nearest)
    if (pair.size() == 2 && pair[0].distance < ratio * pair[1].distance)
      matches.push_back(pair[0]);
  return matches;
}

/** Points of the target with their pixels in the source. */
struct PnpInput {
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> pixels;
};

PnpInput
pointsOf(const EgomotionCloud& cloud,
         const std::vector<cv::DMatch>& matches,
         const OrbView& source,
         const OrbView& target)
{
  PnpInput input;
  for (const cv::DMatch& match : matches) {
    const cv::Point seen =
        target.keypoints[static_cast<std::size_t>(match.trainIdx)].pt;
    const PointXYZRGBSigma& point = cloud.at(seen.x, seen.y);
    if (std::isnan(point.z))
      continue;
    input.points.emplace_back(point.x, point.y, point.z);
    input.pixels.emplace_back(
        source.keypoints[static_cast<std::size_t>(match.queryIdx)].pt);
  }
  return input;
}

std::optional<Eigen::Isometry3d>
poseOf(const PnpInput& input, const TrinocularRig& rig, const OrbSetting& setting)
{
  constexpr int iterations = 1000;
  constexpr double confidence = 0.999;
  const cv::Matx33d camera(rig.focal_length,
                           0,
                           rig.center_x, //
                           0,
                           rig.focal_length,
                           rig.center_y, //
                           0,
                           0,
                           1);
  if (static_cast<int>(input.points.size()) < setting.min_inliers)
    return std::nullopt;
  cv::Vec3d turn, shift;
  std::vector<int> inliers;
  cv::theRNG().state = 1; // the same for each pair
  if (!cv::solvePnPRansac(input.points,
                          input.pixels,
                          camera,
                          cv::noArray(),
                          turn,
                          shift,
                          false,
                          iterations,
                          static_cast<float>(setting.tolerance),
                          confidence,
                          inliers,
                          cv::SOLVEPNP_EPNP) ||
      static_cast<int>(inliers.size()) < setting.min_inliers)
    return std::nullopt;
  PnpInput good;
  for (const int i : inliers) {
    good.points.push_back(input.points[static_cast<std::size_t>(i)]);
    good.pixels.push_back(input.pixels[static_cast<std::size_t>(i)]);
  }
  cv::solvePnPRefineLM(good.points, good.pixels, camera, cv::noArray(), turn, shift);
  const Eigen::Vector3d axis(turn[0], turn[1], turn[2]);
  Eigen::Isometry3d T_source_target(
      Eigen::AngleAxisd(axis.norm(), axis.stableNormalized()));
  T_source_target.translation() << shift[0], shift[1], shift[2];
  return T_source_target.inverse();
}

} // namespace

EgomotionMethod
orbMethod(const OrbSetting& setting)
{
  return {"OpenCV ORB (" + std::to_string(setting.features) + ", FAST " +
              std::to_string(setting.fast_threshold) + ") + PnP",
          [setting](const EgomotionSequence& sequence,
                    std::size_t source,
                    std::size_t target) {
            cv::setNumThreads(1);
            const OrbView now = describe(*sequence.clouds[source], setting);
            const OrbView before = describe(*sequence.clouds[target], setting);
            return poseOf(pointsOf(*sequence.clouds[target],
                                   matchesOf(now, before, setting.ratio),
                                   now,
                                   before),
                          sequence.camera,
                          setting);
          }};
}

namespace {

/** Motions and their errors. */
class RunTally {
public:
  RunTally(const EgomotionMethod& method, const EgomotionSequence& sequence)
  : method_(method)
  , sequence_(sequence)
  {
    run_.name = method.name;
  }

  /** Adds a motion and returns it; identity for a failure. */
  Eigen::Isometry3d
  add(std::size_t target, std::size_t source)
  {
    std::optional<Eigen::Isometry3d> found;
    run_.seconds +=
        measureCost([&] { found = method_.motion(sequence_, source, target); }).cpu;
    const Eigen::Isometry3d truth =
        sequence_.truth[target].inverse() * sequence_.truth[source];
    Eigen::Isometry3d motion = found.value_or(Eigen::Isometry3d::Identity());
    if (sequence_.is_planar)
      motion = isometryOf(planarPartOf(motion));
    const MotionError error = motionError(motion, truth);
    all_.push_back(error);
    if (found)
      estimated_.push_back(error);
    else
      ++run_.failures;
    run_.wrong += found && isWrong(error) ? 1 : 0;
    return motion;
  }

  EgomotionRun
  sum()
  {
    run_.estimated = summaryOf(estimated_);
    run_.all = summaryOf(all_);
    run_.seconds /= static_cast<double>(all_.size());
    return run_;
  }

private:
  const EgomotionMethod& method_;
  const EgomotionSequence& sequence_;
  EgomotionRun run_;
  std::vector<MotionError> estimated_, all_;
};

AbsoluteTrajectoryError
chainError(const EgomotionSequence& sequence,
           const std::vector<Eigen::Isometry3d>& found)
{
  if (!sequence.is_planar)
    return absoluteTrajectoryError(found, sequence.truth);
  return absoluteTrajectoryError(planarPartsOf(found), planarPartsOf(sequence.truth));
}

} // namespace

bool
isWrong(const MotionError& error)
{
  constexpr double metres = 0.1, radians = 5 * M_PI / 180;
  return error.translation > metres || error.rotation > radians;
}

EgomotionRun
runChain(const EgomotionMethod& method, const EgomotionSequence& sequence)
{
  RunTally tally(method, sequence);
  std::vector<Eigen::Isometry3d> poses{sequence.truth.front()};
  for (std::size_t i = 1; i < sequence.clouds.size(); ++i)
    poses.push_back(poses.back() * tally.add(i - 1, i));
  EgomotionRun run = tally.sum();
  run.chain = chainError(sequence, poses);
  run.poses = std::move(poses);
  return run;
}

EgomotionRun
runApart(const EgomotionMethod& method,
         const EgomotionSequence& sequence,
         std::size_t step)
{
  constexpr std::size_t max_pairs = 25;
  RunTally tally(method, sequence);
  const std::size_t pairs = sequence.clouds.size() - step;
  const std::size_t every = (pairs + max_pairs - 1) / max_pairs;
  for (std::size_t i = 0; i < pairs; i += every)
    tally.add(i, i + step);
  return tally.sum();
}

} // namespace pcl::acmap::bench
